#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"
#include "data/bricks.h"
#include "data/load/loaded_surface.h"
#include "data/load/progress.h"
#include "data/load/time_series.h"
#include "data/tally.h"
#include "data/vector_field.h"
#include "description/surface_spec.h"

namespace aeolic {

/// One moment of a field and of what is cut out of it.
struct FieldStep {
    std::shared_ptr<const GridField> vectors;  ///< Null where the cut carries them.
    std::shared_ptr<const GridField> scalar;   ///< To colour by, where it is neither the surface's nor a length.
    std::optional<LoadedSurface> cut;          ///< To be finished.
    bool hasScalar = false;                    ///< Something to colour by is in the field …
    bool scalarIsLength = false;               ///< … and it is the vectors' own length.
    std::string scalarName;
    std::string arrays;             ///< What there is, for messages …
    ArrayChoices offered;           ///< … and to choose from.
    std::vector<double> timeSteps;  ///< Of a file with several.
    std::vector<Tally> tallies;

    std::uint64_t bytes() const { return (vectors ? vectors->bytes() : 0) + (scalar ? scalar->bytes() : 0); }
};

/// The surface from a file, to be finished; of several parts only the pieces of `part`, dealt by `shares` (bytes of
/// each piece; none: this file's). `wantVectors`: there is no other source of vectors. Throws InputError.
LoadedSurface loadSurfaceFile(const StepFile& file, const SceneDescription& description, bool wantVectors,
                              const FieldPart& part, const std::vector<std::uint64_t>& shares,
                              const ProgressReport& progress);

/// A built-in field in a box, at a moment. `colorBy`: what is still to be coloured by, or empty.
FieldStep makeFieldStep(const SceneDescription& description, const Bounds& boundsWorld, const FieldPart& part,
                        double time, const std::string& colorBy);

/// A field from a file, with the surface that `spec` may cut out of it. Throws InputError.
FieldStep loadFieldFile(const StepFile& file, const SceneDescription& description, const SurfaceSpec& spec,
                        const FieldPart& part, const std::string& colorBy, const ProgressReport& progress);

}  // namespace aeolic
