#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "base/bounds.h"

namespace aeolic {

/// Where a point is in a volume. In cells of any shape: the weights of a cell's centre, of the centre of one of its
/// faces, and of two neighbouring corners of that face. In a uniform grid: the fractions of a cell in x, y and z.
struct CellPlace {
    std::uint64_t cell = 0;
    std::uint32_t face = 0, side = 0;
    std::array<double, 4> weights{};
    double distanceSquared = 0;  ///< From the point to the place; 0 where the point is in the cell.
};

/// Looks values up in a volume's cells. Any number of threads may ask, and the answers do not depend on them.
class VolumeSampler {
public:
    virtual ~VolumeSampler() = default;

    /// Whether a cell holds the point, up to the precision of floats, and where.
    virtual bool findWithin(const glm::dvec3& pointWorld, CellPlace& place) const = 0;

    /// The same, or the nearest place of the nearest cell, if that is no farther than half of the cell's diagonal. Of
    /// several cells that hold the point one in the direction `towards` is preferred, so that the two sides of a thin
    /// wall have their own, and a point that is nearly on one of its faces along that wall is taken there. Zero does
    /// neither.
    virtual bool find(const glm::dvec3& pointWorld, const glm::dvec3& towards, CellPlace& place) const = 0;

    /// Values at a place; NaN where one of the cell's corners is masked.
    virtual glm::dvec3 vectorAt(const CellPlace& place) const = 0;
    virtual double scalarAt(const CellPlace& place) const = 0;

    /// Where the place is, world units.
    virtual glm::dvec3 pointOf(const CellPlace& place) const = 0;

    /// How far the place's cell reaches off the surface at a point of this normal, which is beside the cell or in it:
    /// off its own face under the point, where it has one along the surface.
    virtual double heightOver(const CellPlace& place, const glm::dvec3& pointWorld, const glm::dvec3& normal) const = 0;

    /// The mean distance from the wall, at this point of it, of the centres of those cells whose values are averaged at
    /// the point. 0 where the point is on no wall, that is, on no outer face of the volume, and where no values are
    /// means of cells. `towards`: the wall's normal, into the volume.
    virtual double meanDistanceOfCenters([[maybe_unused]] const glm::dvec3& pointWorld,
                                         [[maybe_unused]] const glm::dvec3& towards) const
    {
        return 0;
    }

    /// How far from the point the wall faces lie, at most, that meanDistanceOfCenters() looks at.
    virtual double reachOfCenters([[maybe_unused]] const glm::dvec3& pointWorld,
                                  [[maybe_unused]] const glm::dvec3& towards) const
    {
        return 0;
    }

    /// How far the place's cell reaches along a direction of unit length.
    virtual double widthOf(const CellPlace& place, const glm::dvec3& direction) const = 0;

    virtual const Bounds& bounds() const = 0;
    virtual double maxVector() const = 0;  ///< The longest of the vectors.

    /// Vectors are means of the cells around a point: at a wall they are not the wall's, but the cells' beside it.
    virtual bool meansOfCells() const { return false; }
};

}  // namespace aeolic
