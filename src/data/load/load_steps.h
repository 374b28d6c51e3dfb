#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/data.h"
#include "aeolic/scene_description.h"
#include "aeolic/surface_spec.h"
#include "data/bricks.h"
#include "data/load/agreement.h"
#include "data/load/field/field_step.h"
#include "data/load/scene_sources.h"
#include "data/loaded_surface.h"
#include "data/progress.h"
#include "description/color_by.h"
#include "description/vectors_text.h"

namespace aeolic {

/// What one of a scene's surfaces is asked for.
struct SurfaceAsk {
    ColorBy colorBy;
    bool ownVectors = false;       ///< An array of its own has the vectors.
    bool fieldVectors = false;     ///< The field has them.
    bool colorsFromField = false;  ///< Where the colours' array may be; one of them, once it is found.
    bool colorsFromSurface = false;
    std::string arrays = "none";  ///< What arrays it has, for messages, once it is read.
};

/// Reads or makes single steps of a scene's surfaces and field. Local. Other threads may use it too, once it holds
/// the facts of the first moment.
struct StepReader {
    /// `part`: which of the field, and of an isosurface of it; `pieces`: which of a surface from a file or in memory.
    /// `memory` stands in the place of files. Throws InputError for sources that do not go together or that make no
    /// sense.
    StepReader(const SceneDescription& description, const Data& memory, const FieldPart& part, const FieldPart& pieces);

    /// What of the wall shear that the vectors are colours are; the whole: they are something else.
    ArrayPart shearColors() const
    {
        const ArrayPart asked = parseArray(fieldColors()).part;
        const bool areShear = fieldVectors.shear && asked != ArrayPart::whole &&
                              fieldColors() == description.field.vectors + std::string(suffixOf(asked));
        return areShear ? asked : ArrayPart::whole;
    }
    bool colorsAreShear() const { return shearColors() != ArrayPart::whole; }
    /// The facts of a field whose vectors' wall shear is drawn are those of the shear.
    void nameShear(FieldFacts& facts) const;

    /// The `index`-th surface, which is no cut, to be finished; where it is split, this part's pieces, to be placed.
    LoadedSurface surface(std::size_t index, double key, const ProgressReport& progress) const;

    /// What this rank reads of the field, to be completed.
    FieldStep field(double key, const ProgressReport& progress) const;

    /// Collective. Makes the steps that all ranks have of what each has read.
    void complete(FieldStep& step, Agreement& agreement) const;
    void complete(LoadedSurface& surface, Agreement& agreement) const;

    /// Where the field's first step has the colours' array, the colours come from the field in all moments.
    void decideColors(const FieldStep& first);

    /// Throws InputError: neither the field's arrays nor that surface's have what it is to be coloured by.
    [[noreturn]] void failColorBy(std::size_t index, const std::string& fieldArrays) const;

    const SceneDescription description;
    Data memory;  ///< In the place of the files that the description names.
    const FieldPart part, pieces;
    const FieldVectors fieldVectors;
    SceneSources sources;
    int ranksOnHost = 1;                     ///< That read at once, and share this host's memory.
    FieldPart fieldReaders, surfaceReaders;  ///< Ranks that read for each other; not split: each reads for itself.
    bool readsForHost = true;                ///< This rank reads a field that is whole for those of its host.

    // Known with the first moment, for all others.
    std::vector<SurfaceAsk> asks;       ///< [surfaces]
    std::vector<std::uint64_t> shares;  ///< Bytes by which the pieces of every step are dealt: those of the first.
    Bounds boundsWorld;                 ///< The surfaces': the box of a built-in flow.
    bool firstIsRead = false;           ///< And the surfaces' arrays are known, where they have their own.

private:
    void chooseFirstSteps();
    void requireReversible() const;
    SurfaceVectors ownVectors(const SurfaceItem& item) const;
    LoadedSurface surfaceAsStored(std::size_t index, double key, const ProgressReport& progress) const;
    std::string fieldColors() const;
    bool looksUpCells(const SurfaceSpec& spec) const;  // Where the field is not on a uniform grid.
    void requireColors(const FieldStep& step) const;
    void requireNoShear(std::size_t index) const;  // Of a cut through cells.
    FieldStep builtinField(double time) const;
    FieldStep fieldStep(GridFile& grid, const std::string& path, const ProgressReport& progress) const;
    FieldStep fieldFile(const StepFile& file, const ProgressReport& progress) const;
    LoadedSurface surfaceFile(const StepFile& file, SurfaceArrays arrays, const ProgressReport& progress) const;
    LoadedSurface surfaceFiles(const StepFile& file, SurfaceArrays arrays, const ProgressReport& progress) const;
    // A field that lies in pieces (field_pieces.cpp).
    std::vector<std::uint64_t> piecesOf(const StepFile& file) const;
    FieldStep unitePieces(const FieldStep& read, Agreement& agreement) const;
    LoadedSurface cutPieces(const FieldStep& read, std::size_t index, const FieldFacts& facts,
                            Agreement& agreement) const;
};

}  // namespace aeolic
