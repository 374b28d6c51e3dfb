#include "reader/parts/cell_faces.h"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

#include "base/fnv.h"

namespace aeolic {
namespace {

/// A cell's faces by its corners, seen from outside; -1 ends a face of three.
struct ShapeFaces {
    int count;
    std::array<std::array<int, 4>, 6> corners;
};

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

/// Whether all corners are points that are marked.
bool areAll(const std::vector<bool>& marked, std::span<const std::int64_t> corners)
{
    return std::all_of(corners.begin(), corners.end(), [&](std::int64_t corner) {
        return std::uint64_t(corner) < marked.size() && marked[std::size_t(corner)];
    });
}

/// Calls take(cell, corners) for every face of every cell that fills space, seen from outside; cells are numbered over
/// all lists. The corners hold until the call ends. The cells' sizes must fit (sizesFit()).
template <class Take>
void forEachFaceOf(const std::vector<PartCells>& volume, const Take& take)
{
    std::int64_t number = 0;
    std::array<std::int64_t, 4> own;
    for (const PartCells& cells : volume) {
        if (!fillsSpace(cells.shape)) {
            number += std::int64_t(cells.count);
            continue;
        }
        std::size_t at = 0, ofFace = 0;
        for (std::size_t cell = 0; cell < cells.count; ++cell, ++number) {
            if (cells.shape == CellShape::polyhedron) {
                for (std::int64_t k = 0; k < cells.sizes[cell]; ++k) {
                    const auto size = std::size_t(cells.ofFaces[ofFace++]);
                    take(number, std::span(cells.corners).subspan(at, size));
                    at += size;
                }
                continue;
            }
            const ShapeFaces& faces = shapes[std::size_t(cells.shape) - std::size_t(CellShape::tetra)];
            for (int k = 0; k < faces.count; ++k) {
                std::size_t size = 0;
                for (const int corner : faces.corners[std::size_t(k)])
                    if (corner >= 0) own[size++] = cells.corners[at + std::size_t(corner)];
                take(number, std::span<const std::int64_t>(own).first(size));
            }
            at += cornersOf(cells.shape);
        }
    }
}

}  // namespace

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
    forEachFaceOf(volume, [&](std::int64_t cell, std::span<const std::int64_t> face) {
        if (!areAll(touched, face)) return;
        const auto [begin, end] = wanted.equal_range(sorted(face, room));
        for (auto found = begin; found != end; ++found)
            if (cells[found->second] < 0) cells[found->second] = cell;
    });
    return cells;
}

CellFaces outerFacesOf(const std::vector<PartCells>& volume, const std::vector<bool>& chosen)
{
    constexpr auto twice = std::numeric_limits<std::size_t>::max();
    CellFaces found;
    std::unordered_map<Corners, std::size_t, HashOfCorners> known;
    Corners room;
    forEachFaceOf(volume, [&](std::int64_t cell, std::span<const std::int64_t> face) {
        if (!areAll(chosen, face)) return;
        const auto [place, first] = known.emplace(sorted(face, room), found.cells.size());
        if (!first) {
            if (place->second != twice) found.cells[place->second] = -1;
            place->second = twice;
            return;
        }
        found.faces.add(face);
        found.cells.push_back(cell);
    });
    CellFaces outer;
    for (std::size_t i = 0; i < found.cells.size(); ++i) {
        if (found.cells[i] < 0) continue;
        outer.faces.add(found.faces.face(i));
        outer.cells.push_back(found.cells[i]);
    }
    return outer;
}

}  // namespace aeolic
