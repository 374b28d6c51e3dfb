#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reader/parts/part_source.h"

namespace aeolic {

/// Polygons, one after the other.
template <class Number>
struct PolygonList {
    std::vector<Number> corners;
    std::vector<std::size_t> ends;  ///< [count()] Behind the corners of each.

    std::size_t count() const { return ends.size(); }
    std::span<const Number> face(std::size_t i) const
    {
        const std::size_t begin = i == 0 ? 0 : ends[i - 1];
        return std::span(corners).subspan(begin, ends[i] - begin);
    }
    void add(std::span<const Number> face)
    {
        corners.insert(corners.end(), face.begin(), face.end());
        ends.push_back(corners.size());
    }

    /// The faces as a part's cells: polygons. All must have three corners or more.
    PartCells asPolygons() const
    {
        PartCells cells{CellShape::polygon, count(), {corners.begin(), corners.end()}, {}, {}};
        cells.sizes.reserve(count());
        for (std::size_t i = 0; i < count(); ++i) cells.sizes.push_back(std::int64_t(face(i).size()));
        return cells;
    }
};

/// Polygons with 64-bit numbers. One of size 0 stands for no polygon.
using FaceList = PolygonList<std::int64_t>;

/// Faces, and which cells of a volume they belong to.
struct CellFaces {
    FaceList faces;
    std::vector<std::int64_t> cells;  ///< [faces.count()] Numbers over all lists; -1: none.
};

/// Which cell each face belongs to: the first that has a face of the same corners. Those of `faces` are not negative,
/// and memory is taken for as many points as the largest says.
std::vector<std::int64_t> cellsBehind(const FaceList& faces, const std::vector<PartCells>& volume);

/// The faces of cells that no other cell has, and of which all corners are `chosen`.
CellFaces outerFacesOf(const std::vector<PartCells>& volume, const std::vector<bool>& chosen);

}  // namespace aeolic
