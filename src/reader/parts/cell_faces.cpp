#include "reader/parts/cell_faces.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "base/fnv.h"

namespace aeolic {
namespace {

constexpr ShapeFaces shapes[] = {
    {4, {{{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}}}},                          // tetra
    {5, {{{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}}},            // pyramid
    {5, {{{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}}},              // wedge
    {6, {{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}}},  // hexahedron
};

using Corners = std::vector<std::int64_t>;

const Corners& sorted(std::span<const std::int64_t> face, Corners& room)
{
    room.assign(face.begin(), face.end());
    std::sort(room.begin(), room.end());
    return room;
}

struct HashOfCorners {
    std::size_t operator()(const Corners& corners) const
    {
        Fnv hash;
        for (const std::int64_t corner : corners) hash.mix(std::uint64_t(corner));
        return std::size_t(hash.value);
    }
};

}  // namespace

const ShapeFaces& facesOfShape(CellShape shape)
{
    return shapes[std::size_t(shape) - std::size_t(CellShape::tetra)];
}

PartCells FaceList::asPolygons() const
{
    PartCells cells{CellShape::polygon, count(), corners, {}, {}};
    cells.sizes.reserve(count());
    for (std::size_t i = 0; i < count(); ++i) cells.sizes.push_back(std::int64_t(face(i).size()));
    return cells;
}

std::vector<std::int64_t> cellsBehind(const FaceList& faces, const std::vector<PartCells>& volume)
{
    std::unordered_multimap<Corners, std::size_t, HashOfCorners> wanted;
    Corners room;
    for (std::size_t i = 0; i < faces.count(); ++i) wanted.emplace(sorted(faces.face(i), room), i);
    // Most cells of a volume do not touch the faces.
    std::vector<bool> touched;
    for (const std::int64_t corner : faces.corners) {
        if (std::uint64_t(corner) >= touched.size()) touched.resize(std::size_t(corner) + 1);
        touched[std::size_t(corner)] = true;
    }
    std::vector<std::int64_t> cells(faces.count(), -1);
    std::int64_t before = 0;
    for (const PartCells& each : volume) {
        forEachFaceOf(each, [&](std::size_t cell, std::span<const std::int64_t> face) {
            if (!std::all_of(face.begin(), face.end(), [&](std::int64_t corner) {
                    return std::uint64_t(corner) < touched.size() && touched[std::size_t(corner)];
                }))
                return;
            const auto [begin, end] = wanted.equal_range(sorted(face, room));
            for (auto found = begin; found != end; ++found)
                if (cells[found->second] < 0) cells[found->second] = before + std::int64_t(cell);
        });
        before += std::int64_t(each.count);
    }
    return cells;
}

CellFaces outerFacesOf(const std::vector<PartCells>& volume, const std::vector<bool>& chosen)
{
    constexpr auto twice = std::numeric_limits<std::size_t>::max();
    CellFaces found;
    std::unordered_map<Corners, std::size_t, HashOfCorners> known;
    Corners room;
    std::int64_t before = 0;
    for (const PartCells& each : volume) {
        forEachFaceOf(each, [&](std::size_t cell, std::span<const std::int64_t> face) {
            const bool all = std::all_of(face.begin(), face.end(), [&](std::int64_t corner) {
                return corner >= 0 && std::size_t(corner) < chosen.size() && chosen[std::size_t(corner)];
            });
            if (!all) return;
            const auto [place, first] = known.emplace(sorted(face, room), found.cells.size());
            if (!first) {
                if (place->second != twice) found.cells[place->second] = -1;
                place->second = twice;
                return;
            }
            found.faces.add(face);
            found.cells.push_back(before + std::int64_t(cell));
        });
        before += std::int64_t(each.count);
    }
    CellFaces outer;
    for (std::size_t i = 0; i < found.cells.size(); ++i) {
        if (found.cells[i] < 0) continue;
        outer.faces.add(found.faces.face(i));
        outer.cells.push_back(found.cells[i]);
    }
    return outer;
}

}  // namespace aeolic
