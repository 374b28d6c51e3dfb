#include "data/cells/near_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/parallel.h"
#include "data/cells/cell_tree.h"

namespace aeolic {
namespace {

constexpr std::size_t kGrain = 256;

// How far off a wall flow is looked for, in halves of the width of the cell beside it.
constexpr double kTimesFarther[kWallTries] = {1, 2, 4, 8};

// A quad's diagonal is 1.41 times as long as its cell is wide across a flat wall.
constexpr double kLongestOfCellWidth = 1.5;

// Cells that are thinner than this, as a part of an edge, are damaged: a few halvings would not make parts of their
// size.
constexpr double kThinnest = 0x1p-40;

// An edge that touches no cell is still cut, down to this part of the volume's diagonal, where cells may be near it.
constexpr double kLongestBesideVolume = 1.0 / 16;

// All of a triangle is nearer than this to the middle of its longest edge, in lengths of that edge.
constexpr double kReachOfLongestEdge = 0.87;

struct Found {
    glm::dvec3 vector{std::numeric_limits<double>::quiet_NaN()};
    double scalar = std::numeric_limits<double>::quiet_NaN();
    bool inside = false, atRest = false;
};

/// A point of a surface, or, if that is outside of the volume, the volume's nearest to it, where `place` is: cells may
/// be thinner than surface and volume differ.
glm::dvec3 inVolume(const VolumeSampler& sampler, const glm::dvec3& pointWorld, const CellPlace& place)
{
    return place.distanceSquared > 0 ? sampler.pointOf(place) : pointWorld;
}

/// Looks up single points of a surface.
class Lookup {
public:
    Lookup(const VolumeSampler& sampler, const WallLookup& lookup)
        : sampler_(sampler), lookup_(lookup), rest_(kAtRest * sampler.maxVector())
    {
    }

    Found at(const glm::dvec3& pointWorld, const glm::dvec3& normal) const
    {
        Found found = valuesAt(pointWorld, normal);
        if (lookup_.shearLength) found.scalar = glm::length(found.vector);
        return found;
    }

private:
    Found valuesAt(const glm::dvec3& pointWorld, const glm::dvec3& normal) const
    {
        CellPlace place;
        if (lookup_.offsetWorld) {
            Found found = take(pointWorld + lookup_.side * *lookup_.offsetWorld * normal);
            if (!lookup_.shear || !found.inside) return found;
            const Found wall = sampler_.meansOfCells() ? Found{} : take(pointWorld);
            found.vector = shearOf(wall, found.vector, *lookup_.offsetWorld, normal);
            return found;
        }
        if (!sampler_.find(pointWorld, lookup_.side * normal, place)) return {};
        const glm::dvec3 start = inVolume(sampler_, pointWorld, place);
        const Found wall = valueOf(place);
        const double speed = glm::length(wall.vector);
        if (lookup_.shear && sampler_.meansOfCells()) return besideWall(start, normal, place, wall);
        if (speed > rest_ && !lookup_.shear) return wall;  // Not so where it is masked.
        return awayFromWall(start, normal, place, wall);
    }

    Found valueOf(const CellPlace& place) const
    {
        Found found;
        found.inside = true;
        found.vector = sampler_.vectorAt(place);
        if (lookup_.scalar) found.scalar = sampler_.scalarAt(place);
        if (lookup_.length) found.scalar = glm::length(found.vector);
        return found;
    }

    Found take(const glm::dvec3& pointWorld) const
    {
        CellPlace place;
        return sampler_.find(pointWorld, glm::dvec3(0), place) ? valueOf(place) : Found{};
    }

    static glm::dvec3 shearOf(const Found& wall, const glm::dvec3& vector, double distance, const glm::dvec3& normal)
    {
        const bool known = wall.inside && std::isfinite(glm::length(wall.vector));
        const glm::dvec3 change = known ? vector - wall.vector : vector;
        return (change - glm::dot(change, normal) * normal) / std::abs(distance);
    }

    /// The shear where `wall` has the adjacent cells' vectors, as far off as their centres.
    Found besideWall(const glm::dvec3& pointWorld, const glm::dvec3& normal, const CellPlace& beside,
                     const Found& wall) const
    {
        const double ofAll = sampler_.meanDistanceOfCenters(pointWorld, lookup_.side * normal);
        const double height = ofAll > 0 ? ofAll : heightOf(beside, pointWorld, normal);
        Found found = wall;
        found.vector = height > 0 ? shearOf({}, wall.vector, height, normal) : glm::dvec3(0);
        return found;
    }

    /// The place as far off as the middle of the cell, also where the surface does not follow the cells.
    double heightOf(const CellPlace& place, const glm::dvec3& pointWorld, const glm::dvec3& normal) const
    {
        return 0.5 * sampler_.heightOver(place, pointWorld, normal);
    }

    Found awayFromWall(const glm::dvec3& pointWorld, const glm::dvec3& normal, const CellPlace& beside,
                       const Found& wall) const
    {
        const double height = heightOf(beside, pointWorld, normal);
        for (const double times : std::span(kTimesFarther).first(std::size_t(lookup_.tries))) {
            for (const double side : {lookup_.side, -lookup_.side}) {
                const double distance = side * times * height;
                CellPlace place;
                if (!(height > 0) || !sampler_.findWithin(pointWorld + distance * normal, place)) continue;
                Found found = valueOf(place);
                const glm::dvec3 along = found.vector - glm::dot(found.vector, normal) * normal;
                if (!(glm::length(along) > rest_)) continue;
                found.vector = lookup_.shear ? shearOf(wall, found.vector, distance, normal) : along;
                return found;
            }
        }
        Found still = wall;
        still.atRest = true;
        if (lookup_.shear) still.vector = 0.0 * wall.vector;  // Masked stays masked.
        return still;
    }

    const VolumeSampler& sampler_;
    const WallLookup& lookup_;
    const double rest_;
};

}  // namespace

WallValues lookUpNearWall(const SurfaceMesh& mesh, const VolumeSampler& sampler, const WallLookup& lookup)
{
    WallValues values;
    values.vectors.resize(mesh.positions.size());
    values.within.resize(mesh.positions.size());
    values.atRest.resize(mesh.positions.size());
    if (lookup.scalar || lookup.length || lookup.shearLength) values.scalars.resize(mesh.positions.size());
    const Lookup single(sampler, lookup);
    parallelRanges(mesh.positions.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Found found =
                single.at(mesh.originWorld + glm::dvec3(mesh.positions[i]), glm::dvec3(mesh.normals[i]));
            values.vectors[i] = glm::vec3(found.vector);
            if (!values.scalars.empty()) values.scalars[i] = float(found.scalar);
            values.within[i] = found.inside;
            values.atRest[i] = found.atRest;
        }
    });
    values.inside = std::ranges::count(values.within, char(true));
    return values;
}

std::vector<double> lookUpReach(const SurfaceMesh& mesh, const VolumeSampler& sampler, const WallLookup& lookup)
{
    constexpr double aHairMore = 1 + 1e-9;
    const double offset = lookup.offsetWorld ? std::abs(*lookup.offsetWorld) : 0;
    const double times = kTimesFarther[lookup.offsetWorld ? 0 : lookup.tries - 1];
    const bool toCenters = lookup.shear && !lookup.offsetWorld && sampler.meansOfCells();
    std::vector<double> reach(mesh.positions.size());
    parallelRanges(reach.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec3 point = mesh.originWorld + glm::dvec3(mesh.positions[i]), normal(mesh.normals[i]);
            double farthest = offset;
            for (const double side : {1.0, -1.0}) {
                CellPlace place;
                if (!sampler.find(point, side * normal, place)) continue;
                const glm::dvec3 start = inVolume(sampler, point, place);
                double off = 0.5 * times * sampler.heightOver(place, start, normal);
                if (toCenters) off = std::max(off, sampler.reachOfCenters(start, side * normal));
                farthest = std::max(farthest, glm::length(start - point) + off);
            }
            reach[i] = aHairMore * farthest;
        }
    });
    return reach;
}

std::int64_t pointsTowardsVolume(const SurfaceMesh& mesh, const VolumeSampler& sampler)
{
    return parallelSum(mesh.positions.size(), kGrain, [&](std::size_t i) {
        const glm::dvec3 point = mesh.originWorld + glm::dvec3(mesh.positions[i]), normal(mesh.normals[i]);
        CellPlace place;
        if (!sampler.find(point, normal, place)) return 0;
        const glm::dvec3 start = inVolume(sampler, point, place),
                         off = 0.5 * sampler.heightOver(place, start, normal) * normal;
        const auto flows = [&](const glm::dvec3& at) {
            return sampler.findWithin(at, place) && std::isfinite(glm::length(sampler.vectorAt(place)));
        };
        return int(flows(start + off)) - int(flows(start - off));
    });
}

bool longerThanCell(const VolumeSampler& sampler, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 middle = 0.5 * (a + b);
    const double length = glm::length(b - a);
    if (!(length > 0)) return false;
    CellPlace place;
    if (sampler.find(middle, glm::dvec3(0), place)) {
        const double width = sampler.widthOf(place, (b - a) / length);
        const double finest =
            std::max(width, std::sqrt(place.distanceSquared));  // Far from a cell its details are lost.
        return length > kLongestOfCellWidth * finest && width > kThinnest * length;
    }
    const double distance = std::sqrt(CellTree::distanceSquared(sampler.bounds(), middle));
    return distance < kReachOfLongestEdge * length && length > kLongestBesideVolume * sampler.bounds().diagonal();
}

}  // namespace aeolic
