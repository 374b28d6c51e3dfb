#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/data.h"
#include "aeolic/scene_description.h"
#include "data/bricks.h"
#include "data/cells/volume_sampler.h"
#include "data/load/scene_sources.h"
#include "data/loaded_surface.h"
#include "data/progress.h"
#include "data/tally.h"
#include "data/vector_field.h"
#include "description/color_by.h"
#include "description/surface_spec.h"
#include "description/wall_shear.h"

namespace aeolic {

class GridFile;

/// One moment of a field and of what is cut out of it.
struct FieldStep {
    std::shared_ptr<const GridField> vectors;    ///< Null where the cut carries them.
    std::shared_ptr<const VolumeSampler> cells;  ///< Instead of vectors and scalar: looked up on the whole surface.
    std::shared_ptr<const GridField> scalar;     ///< To colour by, where it is neither the surface's nor a length.
    std::optional<LoadedSurface> cut;            ///< To be finished.
    bool hasScalar = false;                      ///< Something to colour by is in the field.
    bool scalarIsLength = false;                 ///< That something is the vectors' own length.
    std::string scalarName;
    std::string arrays;             ///< What arrays there are, for messages.
    ArrayChoices offered;           ///< What arrays there are to choose from.
    std::vector<double> timeSteps;  ///< Those of a file that holds several.
    std::vector<Tally> tallies;
};

/// Reads or makes single steps of a scene's surface and field. Local. Other threads may use it too, once what is known
/// of the first moment stands in it.
struct StepReader {
    /// `part`: which of the field, and of an isosurface of it; `pieces`: which of a surface from a file or in memory.
    /// `memory` stands in the place of files. Throws InputError for sources that do not go together or that make no
    /// sense.
    StepReader(const SceneDescription& description, const Data& memory, const FieldPart& part, const FieldPart& pieces);

    /// Colours are the length of the wall shear that the vectors are.
    bool colorsAreShear() const { return fieldVectors.shear && colorBy.name == description.field.vectors + ":mag"; }

    /// A surface that is no cut, to be finished; where it is split, this part's pieces, to be placed.
    LoadedSurface surface(double key, const ProgressReport& progress) const;

    FieldStep field(double key, const ProgressReport& progress) const;

    /// Throws InputError: neither the field's arrays nor the surface's have what is to be coloured by.
    [[noreturn]] void failColorBy(const std::string& fieldArrays) const;

    const SceneDescription description;
    Data memory;  ///< In the place of the files that the description names.
    const FieldPart part, pieces;
    const ColorBy colorBy;
    const FieldVectors fieldVectors;
    SceneSources sources;
    int ranksOnHost = 1;  ///< That read at once, and share this host's memory.

    // Known with the first moment, for all others.
    std::vector<std::uint64_t> shares;  ///< Bytes by which the pieces of every step are dealt: those of the first.
    Bounds boundsWorld;                 ///< The surface's: the box of a built-in flow.
    bool colorsFromField, colorsFromSurface;  ///< Where what is coloured by may be; one of them, once it is found.
    bool firstIsRead = false;                 ///< And the surface's arrays are known, where it has its own.
    std::string surfaceArrays = "none";       ///< For messages.

private:
    bool looksUpCells() const;  // Where the field is not on a uniform grid.
    FieldStep builtinField(double time, const std::string& wanted) const;
    FieldStep fieldStep(GridFile& grid, const std::string& wanted, const ProgressReport& progress) const;
    FieldStep fieldFile(const StepFile& file, const std::string& wanted, const ProgressReport& progress) const;
};

}  // namespace aeolic
