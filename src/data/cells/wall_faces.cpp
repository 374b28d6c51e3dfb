#include "data/cells/wall_faces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

#include "base/mixed_bits.h"

namespace aeolic {
namespace {

/// Corners of less weight are left out: points of a surface that are corners of the volume are so up to rounding.
constexpr double kLeastWeight = 1e-3;

std::uint64_t keyOf(const glm::dvec3& place)
{
    std::uint64_t key = 0;
    for (int c = 0; c < 3; ++c) key = mixedBits(key + std::bit_cast<std::uint64_t>(place[c] + 0.0));  // No -0.
    return key;
}

}  // namespace

void WallFaces::Faces::clear()
{
    cells.clear();
    faces.clear();
    corners.clear();
}

/// Adds a cell and its faces. `corner`: those with a corner there alone; a cell that has none is not added.
void WallFaces::addFaces(std::uint32_t cell, const glm::dvec3* corner, Faces& found) const
{
    const std::size_t before = found.faces.size();
    cells_.forEachFace(cell, [&](Corners face) {
        const auto isThere = [&](std::uint32_t id) { return cells_.points[id] == *corner; };
        if (corner && std::ranges::none_of(face, isThere)) return;
        std::uint64_t key = 0;  // A sum: it does not depend on where a face begins, and which way it goes around.
        for (const std::uint32_t id : face) key += keyOf(cells_.points[id]);
        found.faces.push_back({key, cell, std::uint32_t(found.corners.size()), std::uint32_t(face.size())});
        found.corners.insert(found.corners.end(), face.begin(), face.end());
    });
    if (found.faces.size() > before) found.cells.push_back(cell);
}

void WallFaces::keepOuter(Faces& found)
{
    std::vector<Face>& faces = found.faces;
    std::ranges::sort(faces, [](const Face& a, const Face& b) {
        return std::tie(a.key, a.owner, a.first) < std::tie(b.key, b.owner, b.first);
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const bool twice =
            (i > 0 && faces[i - 1].key == faces[i].key) || (i + 1 < faces.size() && faces[i + 1].key == faces[i].key);
        if (!twice) faces[kept++] = faces[i];
    }
    faces.resize(kept);
}

/// The wall's face that a point is on; one without corners where there is none. One that looks the other way than
/// `towards` only where no other is.
WallFaces::Wall WallFaces::wallAt(const glm::dvec3& point, const glm::dvec3& towards) const
{
    thread_local Faces near;
    near.clear();
    tree_.forEachNear(
        point, [&] { return slackWorld_ * slackWorld_; }, [&](std::uint32_t cell) { addFaces(cell, nullptr, near); });
    keepOuter(near);
    Wall wall;
    std::tuple<bool, double, std::uint64_t> best{true, kInfinity, 0};
    for (const Face& face : near.faces) {
        const Corners corners = near.of(face);
        const FacePlane plane = planeOf(cells_, corners, centerOf(cells_, face.owner));
        const double along = glm::dot(plane.inwards, towards);
        if (!(std::abs(along) >= kAlongSurface)) continue;
        const CellPlace place = nearestOnFace(cells_, corners, point);
        if (!(place.distanceSquared <= slackWorld_ * slackWorld_)) continue;
        const std::tuple candidate{along < 0, place.distanceSquared, face.key};
        if (!(candidate < best)) continue;
        best = candidate;
        wall = {corners, place, along < 0 ? -towards : towards};
    }
    return wall;
}

/// How far a cell's centre is from the walls around one of its corners: from its own that looks `towards`, or from the
/// nearest that does so and has the cell in front of it. That leaves out where the flow comes in beside a wall. Around
/// the edge of a body there are cells behind all of those: they count from the nearest of any wall.
double WallFaces::distanceOf(std::uint32_t cell, const Faces& walls, const glm::dvec3& towards) const
{
    const glm::dvec3 center = centerOf(cells_, cell);
    double own = kInfinity, inFront = kInfinity, any = kInfinity;
    for (const Face& face : walls.faces) {
        const Corners corners = walls.of(face);
        const FacePlane plane = planeOf(cells_, corners, centerOf(cells_, face.owner));
        const double height = glm::dot(center - plane.middle, plane.inwards),
                     squared = nearestOnFace(cells_, corners, center).distanceSquared;
        any = std::min(any, squared);
        if (!(glm::dot(plane.inwards, towards) >= kAlongSurface && height > 0)) continue;
        inFront = std::min(inFront, squared);
        if (face.owner == cell) own = std::min(own, height);
    }
    if (own < kInfinity) return own;
    return std::sqrt(inFront < kInfinity ? inFront : any);
}

/// The mean distance of the centres of all cells that meet at a corner of a wall. 0 where there is no wall.
double WallFaces::meanAtCorner(std::uint32_t corner, const glm::dvec3& towards) const
{
    thread_local Faces meeting;
    meeting.clear();
    const glm::dvec3& place = cells_.points[corner];
    tree_.forEachNear(
        place, [] { return 0.0; }, [&](std::uint32_t cell) { addFaces(cell, &place, meeting); });
    keepOuter(meeting);
    if (meeting.faces.empty()) return 0;
    std::ranges::sort(meeting.cells);  // The sum's order must not depend on the tree.
    double sum = 0;
    for (const std::uint32_t cell : meeting.cells) sum += distanceOf(cell, meeting, towards);
    return sum / double(meeting.cells.size());
}

double WallFaces::meanDistanceOfCenters(const glm::dvec3& point, const glm::dvec3& towards) const
{
    const Wall wall = wallAt(point, towards);
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < wall.face.size(); ++k) {
        double weight = wall.place.weights[1] / double(wall.face.size());
        if (k == wall.place.side) weight += wall.place.weights[2];
        if (k == (wall.place.side + 1) % wall.face.size()) weight += wall.place.weights[3];
        if (!(weight >= kLeastWeight)) continue;
        const double mean = meanAtCorner(wall.face[k], wall.towards);
        if (!(mean > 0)) continue;
        sum += weight * mean;
        weights += weight;
    }
    return weights > 0 ? sum / weights : 0;
}

double WallFaces::reach(const glm::dvec3& point, const glm::dvec3& towards) const
{
    double squared = 0;
    for (const std::uint32_t id : wallAt(point, towards).face) {
        const glm::dvec3 off = cells_.points[id] - point;
        squared = std::max(squared, glm::dot(off, off));
    }
    return std::sqrt(squared);
}

}  // namespace aeolic
