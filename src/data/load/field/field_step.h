#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "data/field_facts.h"
#include "data/load/agreement.h"
#include "data/load/field/dealt_volume.h"
#include "data/loaded_surface.h"
#include "data/vector_field.h"

namespace aeolic {

class GridFile;

/// One moment of a field and of the surfaces that are cut out of it.
struct FieldStep : FieldFacts {
    std::shared_ptr<const GridField> vectors;  ///< Null where the cuts carry them, or all is looked up in cells.
    std::shared_ptr<const DealtVolume> cells;  ///< Instead of vectors and scalar: looked up on the whole surface.
    std::shared_ptr<const GridField> scalar;   ///< To colour by, where it is neither the surface's nor of the vectors.
    /// [surfaces] Those that are cut out of it, to be finished; or empty.
    std::vector<std::optional<LoadedSurface>> cuts;

    // What this rank has read for all, until StepReader::complete() makes the step of it.
    bool complete = true;
    std::shared_ptr<const CellVolume> readCells;    ///< Of a field that is whole.
    bool inPieces = false;                          ///< It lies in pieces; the same on all ranks.
    std::vector<std::shared_ptr<GridFile>> pieces;  ///< This rank's.
    int firstPiece = 0;                             ///< Which of all the first of them is.

    /// How many cells the whole field has, which is the same on all ranks. For a grid it is the number of its samples.
    std::uint64_t countCells() const;
};

/// Collective. The first rank has read a step that is whole, and so has the first rank of every other host. Now all
/// ranks have it: grids in memory that a host has once, cells where they were read.
void shareStep(FieldStep& step, Agreement& agreement);

}  // namespace aeolic
