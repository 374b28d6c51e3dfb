#include "data/vtk/surface/outer_faces.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <tuple>

#include "base/large_memory.h"
#include "base/parallel.h"

namespace aeolic {
namespace {

using OuterFace = std::array<std::uint32_t, 4>;

constexpr std::size_t kCellsAtOnce = 4096;

/// Which of a cell's corners its faces have, in VTK's order; -1 ends a triangle.
struct CellKind {
    int corners, count;
    std::array<std::array<int, 4>, 6> faces;
};

constexpr CellKind kNone{0, 0, {}}, kTetra{4, 4, {{{0, 1, 3, -1}, {0, 2, 1, -1}, {0, 3, 2, -1}, {1, 2, 3, -1}}}},
    kPyramid{5, 5, {{{3, 2, 1, 0}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}}},
    kWedge{6, 5, {{{0, 2, 5, 3}, {1, 0, 3, 4}, {2, 1, 4, 5}, {0, 1, 2, -1}, {3, 5, 4, -1}}}},
    kHexahedron{8, 6, {{{0, 1, 5, 4}, {0, 3, 2, 1}, {0, 4, 7, 3}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}}}},
    kVoxel{8, 6, {{{0, 1, 5, 4}, {0, 2, 3, 1}, {0, 4, 6, 2}, {1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7, 6}}}};

const CellKind* kindOfCell(unsigned char type)
{
    switch (type) {
        case VTK_EMPTY_CELL:
            return &kNone;
        case VTK_TETRA:
            return &kTetra;
        case VTK_PYRAMID:
            return &kPyramid;
        case VTK_WEDGE:
            return &kWedge;
        case VTK_HEXAHEDRON:
            return &kHexahedron;
        case VTK_VOXEL:
            return &kVoxel;
        default:
            return nullptr;
    }
}

/// The face, begun with its smallest corner where no other is the same.
OuterFace turned(const OuterFace& face)
{
    const auto [a, b, c, d] = face;  // None counts as the largest, so triangles are turned among three.
    const std::uint32_t least = std::min(std::min(a, b), std::min(c, d));
    if (a == least || (b == least) + (c == least) + (d == least) != 1) return face;
    const bool triangle = d == OuterFaces::kNone;
    if (b == least) return triangle ? OuterFace{b, c, a, d} : OuterFace{b, c, d, a};
    if (c == least) return triangle ? OuterFace{c, a, b, d} : OuterFace{c, d, a, b};
    return {d, a, b, c};
}

/// Two faces that begin with the same corner and run opposite ways around become one and the same.
OuterFace undirected(OuterFace face)
{
    const std::size_t last = face[3] == OuterFaces::kNone ? 2 : 3;
    if (face[last] < face[1]) std::swap(face[1], face[last]);
    return face;
}

/// Tells faces apart, all but surely.
std::uint64_t markOf(const OuterFace& face)
{
    std::uint64_t mark = 0;
    for (const std::uint32_t corner : undirected(face)) {
        mark = (mark ^ corner) * 0x9E3779B97F4A7C15u;
        mark ^= mark >> 29;
    }
    return mark;
}

/// A face of a cell, turned.
struct FaceOfCell {
    OuterFace face;
    std::uint32_t cell, number;

    bool operator<(const FaceOfCell& other) const
    {
        return std::tie(face[0], cell, number) < std::tie(other.face[0], other.cell, other.number);
    }
};

template <class Id>
class FacesOfCells {
public:
    FacesOfCells(vtkUnstructuredGrid& grid, const Id* offsets, const Id* corners)
        : points_(std::size_t(grid.GetNumberOfPoints())),
          cells_(std::size_t(grid.GetNumberOfCells())),
          offsets_(offsets),
          corners_(corners),
          types_(grid.GetCellTypesArray()->GetPointer(0))
    {
        if (vtkUnsignedCharArray* ghosts = grid.GetCellGhostArray()) ghosts_ = ghosts->GetPointer(0);
    }

    /// Whether all cells are of kinds that are known.
    bool areKnown() const
    {
        return holdsForAll(cells_, kCellsAtOnce, [&](std::size_t begin, std::size_t end) {
            for (std::size_t cell = begin; cell < end; ++cell) {
                const CellKind* kind = kindOfCell(types_[cell]);
                const bool fits = kind && (kind->corners == 0 || kind->corners == offsets_[cell + 1] - offsets_[cell]);
                if (!fits) return false;
            }
            return true;
        });
    }

    OuterFaces outer() const
    {
        std::vector<FaceOfCell> all = candidates();
        std::sort(all.begin(), all.end());
        OuterFaces outer;
        std::vector<std::pair<OuterFace, std::size_t>> atPoint;
        std::vector<char> once(all.size(), 1);
        for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
            atPoint.clear();
            for (end = begin; end < all.size() && all[end].face[0] == all[begin].face[0]; ++end)
                atPoint.emplace_back(undirected(all[end].face), end);
            std::sort(atPoint.begin(), atPoint.end());
            for (std::size_t k = 1; k < atPoint.size(); ++k)
                if (atPoint[k].first == atPoint[k - 1].first) once[atPoint[k].second] = once[atPoint[k - 1].second] = 0;
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!once[i]) continue;
            outer.corners.push_back(all[i].face);
            outer.cells.push_back(all[i].cell);
        }
        return outer;
    }

private:
    /// Calls visit(face, number) for every face of a cell, turned.
    template <class Visit>
    void forEachFace(std::size_t cell, const Visit& visit) const
    {
        if (ghosts_ && (ghosts_[cell] & vtkDataSetAttributes::HIDDENCELL)) return;
        const Id* own = corners_ + offsets_[cell];
        const CellKind& kind = *kindOfCell(types_[cell]);
        for (int number = 0; number < kind.count; ++number) {
            const std::array<int, 4>& corners = kind.faces[std::size_t(number)];
            OuterFace face;
            for (std::size_t k = 0; k < 4; ++k)
                face[k] = corners[k] < 0 ? OuterFaces::kNone : std::uint32_t(own[corners[k]]);
            visit(turned(face), std::uint32_t(number));
        }
    }

    template <class Test>
    bool anyCorner(std::size_t cell, const Test& test) const
    {
        return std::any_of(corners_ + offsets_[cell], corners_ + offsets_[cell + 1], test);
    }

    /// All faces at points where some face is alone. The marks of two that are the same cancel out, so at most points
    /// of a volume nothing is left. Where marks of different faces did so by a chance of 1 in 2^64, a face would be
    /// lost.
    std::vector<FaceOfCell> candidates() const
    {
        LargeVector<std::uint64_t> marks(points_, 0);
        parallelRanges(cells_, kCellsAtOnce, [&](std::size_t begin, std::size_t end) {
            for (std::size_t cell = begin; cell < end; ++cell)
                forEachFace(cell, [&](const OuterFace& face, std::uint32_t) {
                    std::atomic_ref(marks[face[0]]).fetch_xor(markOf(face), std::memory_order_relaxed);
                });
        });
        std::vector<FaceOfCell> all;
        std::mutex joining;
        parallelRanges(cells_, kCellsAtOnce, [&](std::size_t begin, std::size_t end) {
            std::vector<FaceOfCell> some;
            for (std::size_t cell = begin; cell < end; ++cell)
                if (anyCorner(cell, [&](Id corner) { return marks[std::size_t(corner)] != 0; }))
                    forEachFace(cell, [&](const OuterFace& face, std::uint32_t number) {
                        if (marks[face[0]] != 0) some.push_back({face, std::uint32_t(cell), number});
                    });
            const std::lock_guard lock(joining);
            all.insert(all.end(), some.begin(), some.end());
        });
        return all;
    }

    std::size_t points_, cells_;
    const Id *offsets_, *corners_;
    const unsigned char *types_, *ghosts_ = nullptr;
};

template <class Array>
std::optional<OuterFaces> outerFacesBy(vtkUnstructuredGrid& grid, Array& offsets, Array& corners)
{
    const FacesOfCells faces(grid, offsets.GetPointer(0), corners.GetPointer(0));
    if (!faces.areKnown()) return std::nullopt;
    return faces.outer();
}

}  // namespace

std::optional<OuterFaces> outerFacesOf(vtkUnstructuredGrid& grid)
{
    const bool countable = std::uint64_t(grid.GetNumberOfPoints()) < OuterFaces::kNone &&
                           std::uint64_t(grid.GetNumberOfCells()) < OuterFaces::kNone;
    if (!countable || grid.GetNumberOfCells() == 0 || !grid.GetCellTypesArray() || grid.GetPointGhostArray())
        return std::nullopt;
    vtkCellArray& cells = *grid.GetCells();
    return cells.IsStorage64Bit() ? outerFacesBy(grid, *cells.GetOffsetsArray64(), *cells.GetConnectivityArray64())
                                  : outerFacesBy(grid, *cells.GetOffsetsArray32(), *cells.GetConnectivityArray32());
}

}  // namespace aeolic
