#pragma once

#include <vector>

#include "data/cells/cell_geometry.h"
#include "data/cells/cell_heights.h"
#include "data/cells/cell_tree.h"

namespace aeolic {

/// The walls of a volume: faces that only one cell has. Two pieces of a volume have points of their own, so faces are
/// compared by where their corners are, to the bit. The answers depend on the cells around the point alone.
class WallFaces {
public:
    /// `slackWorld`: a point no farther from a face is on it.
    WallFaces(const VolumeCells& cells, const CellTree& tree, double slackWorld)
        : cells_(cells), tree_(tree), slackWorld_(slackWorld)
    {
    }

    /// VolumeSampler::meanDistanceOfCenters(). Values of cells at a corner of a wall are the mean of all cells that
    /// meet there, and on the wall linear between corners. So are these distances: where all cells have the same vector
    /// over their distance, the wall has it, too, however uneven the cells are.
    double meanDistanceOfCenters(const glm::dvec3& point, const glm::dvec3& towards) const;

    /// VolumeSampler::reachOfCenters().
    double reach(const glm::dvec3& point, const glm::dvec3& towards) const;

private:
    struct Face {
        std::uint64_t key;    // The same for faces in the same place.
        std::uint32_t owner;  // The cell.
        std::uint32_t first, size;
    };
    struct Faces {
        std::vector<std::uint32_t> cells;
        std::vector<Face> faces;
        std::vector<std::uint32_t> corners;
        void clear();
        Corners of(const Face& face) const { return {corners.data() + face.first, face.size}; }
    };
    struct Wall {
        Corners face;
        CellPlace place;        // Of the point on it.
        glm::dvec3 towards{0};  // The direction that was asked for, or the opposite, so that it points to the cell.
    };

    void addFaces(std::uint32_t cell, const glm::dvec3* corner, Faces& found) const;
    static void keepOuter(Faces& found);
    Wall wallAt(const glm::dvec3& point, const glm::dvec3& towards) const;
    double distanceOf(std::uint32_t cell, const Faces& walls, const glm::dvec3& towards) const;
    double meanAtCorner(std::uint32_t corner, const glm::dvec3& towards) const;

    const VolumeCells& cells_;
    const CellTree& tree_;
    double slackWorld_;
};

}  // namespace aeolic
