#include "data/cells/cell_sampler.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "data/cells/cell_geometry.h"
#include "data/cells/cell_heights.h"
#include "data/cells/wall_faces.h"

namespace aeolic {
namespace {

// Surfaces have coordinates of floats: this part of the volume's diagonal decides nothing.
constexpr double kSlack = 0x1p-22;

std::vector<CellTree::Box> boxesOf(const VolumeCells& cells)
{
    std::vector<CellTree::Box> boxes(cells.count());
    parallelRanges(boxes.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) boxes[cell] = CellTree::Box::around(cells.boxOf(cell));
    });
    return boxes;
}

template <class Value, class Get>
Value valueAt(const VolumeCells& cells, const CellPlace& place, const Get& get)
{
    Value value = place.weights[0] * cellMean<Value>(cells, place.cell, get);
    std::uint32_t number = 0;
    cells.forEachFace(place.cell, [&](Corners face) {
        if (number++ != place.face) return;
        value += place.weights[1] * faceMean<Value>(face, get) + place.weights[2] * get(face[place.side]) +
                 place.weights[3] * get(face[(place.side + 1) % face.size()]);
    });
    return value;
}

}  // namespace

CellSampler::CellSampler(std::shared_ptr<const VolumeCells> cells)
    : cells_(std::move(cells)),
      tree_(boxesOf(*cells_)),
      bounds_(tree_.bounds()),
      slackWorld_(kSlack * bounds_.diagonal())
{
}

CellSampler::CellSampler(std::shared_ptr<const VolumeCells> cells, const Bounds& ofVolume)
    : cells_(std::move(cells)), tree_(boxesOf(*cells_)), bounds_(ofVolume), slackWorld_(kSlack * ofVolume.diagonal())
{
}

/// A cell that holds the point, or else the nearest of those hardly beside it: layers of cells may be thinner than the
/// slack.
bool CellSampler::findAmong(std::span<const Ranked> cells, const glm::dvec3& point, CellPlace& place) const
{
    for (const Ranked& ranked : cells)
        if (within(*cells_, ranked.second, point, place)) return true;
    bool found = false;
    for (const Ranked& ranked : cells) {
        const CellPlace candidate = nearestOn(*cells_, ranked.second, point, slackWorld_);
        if (!(candidate.distanceSquared <= slackWorld_ * slackWorld_)) continue;
        if (!found || candidate.distanceSquared < place.distanceSquared) place = candidate;
        found = true;
    }
    return found;
}

/// Finds the best of the cells that hold the point. To find out whether a cell does takes most of the time, so the best
/// are tried first.
bool CellSampler::findBest(const glm::dvec3& point, const glm::dvec3& towards, CellPlace& place) const
{
    thread_local std::vector<Ranked> ranks;  // One list a thread: to make it takes as long as a search.
    ranks.clear();
    const bool anySide = towards == glm::dvec3(0);
    tree_.forEachNear(
        point, [&] { return slackWorld_ * slackWorld_; },
        [&](std::uint32_t cell) {
            ranks.emplace_back(!anySide && !isTowards(*cells_, cell, point, towards, slackWorld_), cell);
        });
    std::ranges::sort(ranks);
    const auto others = std::ranges::partition_point(ranks, [](const Ranked& r) { return !r.first; });
    return findAmong({ranks.begin(), others}, point, place) || findAmong({others, ranks.end()}, point, place);
}

bool CellSampler::findWithin(const glm::dvec3& pointWorld, CellPlace& place) const
{
    return findBest(pointWorld, glm::dvec3(0), place);
}

bool CellSampler::find(const glm::dvec3& pointWorld, const glm::dvec3& towards, CellPlace& place) const
{
    if (!std::isfinite(pointWorld.x + pointWorld.y + pointWorld.z)) return false;
    if (findBest(pointWorld, towards, place)) {
        if (towards != glm::dvec3(0)) settleOnFace(*cells_, pointWorld, towards, slackWorld_, place);
        return true;
    }
    place.distanceSquared = kInfinity;
    tree_.forEachNear(
        pointWorld, [&] { return place.distanceSquared; },
        [&](std::uint32_t cell) {
            const CellPlace candidate = nearestOn(*cells_, cell, pointWorld);
            const bool nearer = candidate.distanceSquared < place.distanceSquared ||
                                (candidate.distanceSquared == place.distanceSquared && cell < place.cell);
            if (nearer) place = candidate;
        });
    if (!(place.distanceSquared < kInfinity)) return false;
    const double half = 0.5 * cells_->boxOf(place.cell).diagonal();
    return place.distanceSquared <= half * half;
}

glm::dvec3 CellSampler::vectorAt(const CellPlace& place) const
{
    return valueAt<glm::dvec3>(*cells_, place, [&](std::uint32_t id) { return glm::dvec3(cells_->vectors[id]); });
}

double CellSampler::scalarAt(const CellPlace& place) const
{
    return valueAt<double>(*cells_, place, [&](std::uint32_t id) { return double(cells_->scalars[id]); });
}

glm::dvec3 CellSampler::pointOf(const CellPlace& place) const
{
    return valueAt<glm::dvec3>(*cells_, place, [&](std::uint32_t id) { return cells_->points[id]; });
}

double CellSampler::heightOver(const CellPlace& place, const glm::dvec3& pointWorld, const glm::dvec3& normal) const
{
    return aeolic::heightOver(*cells_, std::uint32_t(place.cell), pointWorld, normal, slackWorld_);
}

double CellSampler::meanDistanceOfCenters(const glm::dvec3& pointWorld, const glm::dvec3& towards) const
{
    return WallFaces(*cells_, tree_, slackWorld_).meanDistanceOfCenters(pointWorld, towards);
}

double CellSampler::reachOfCenters(const glm::dvec3& pointWorld, const glm::dvec3& towards) const
{
    return WallFaces(*cells_, tree_, slackWorld_).reach(pointWorld, towards);
}

double CellSampler::widthOf(const CellPlace& place, const glm::dvec3& direction) const
{
    return aeolic::widthOf(*cells_, std::uint32_t(place.cell), direction);
}

}  // namespace aeolic
