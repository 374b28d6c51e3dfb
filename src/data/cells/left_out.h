#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "data/cells/cell_tree.h"
#include "data/cells/coarse_boxes.h"
#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// How large the cells are that were left out of a volume, roughly by where they are: the least diagonal of those whose
/// middle is in the same coarse box. It tells whether any of them is missing somewhere.
class LeftOut {
public:
    LeftOut() = default;

    /// For about so many cells with their middles in these bounds.
    LeftOut(const Bounds& middlesWorld, std::size_t cells)
        : boxes_(middlesWorld, cells), diagonals_(boxes_.size(), kAll)
    {
    }

    // One cell, or some with their middles in a box, or some that are anywhere. Any number of threads may add.
    void add(const glm::dvec3& middleWorld, double diagonal);
    void add(const CellTree::Box& middlesWorld, double leastDiagonal);
    void addAnywhere(double leastDiagonal);

    /// The least diagonal of all; infinite where there are none.
    double least() const;

    /// No more than the least diagonal of those with their middles in a box.
    double leastIn(const Bounds& boxWorld) const;

    /// False where all cells are there whose middle is no farther from some triangle of the mesh than the triangle's
    /// reach and the cell's diagonal. Where only a few are missing it may be true for none. `reach`: [points]. A
    /// triangle has the largest of its corners'. `diagonals`: cells whose middle is no farther from the mesh than so
    /// many of their diagonals were not left out; more than 1. Parallel.
    bool mayLack(const SurfaceMesh& mesh, const std::vector<double>& reach, double diagonals) const;

private:
    static constexpr double kAll = std::numeric_limits<double>::infinity();

    CoarseBoxes boxes_;
    std::vector<double> diagonals_;  // [boxes_]
    double anywhere_ = kAll;
};

}  // namespace aeolic
