#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/bounds.h"

namespace aeolic {

/// Cells of any shape with values on their points. Between the points values are linear in tetrahedra: each is made of
/// the cell's centre, the centre of a face and two neighbouring corners of that face. A centre has the mean of its
/// corners, so linear fields are exact, and two cells agree on the face between them.
struct VolumeCells {
    enum class Shape : std::uint8_t { tetra, pyramid, wedge, hexahedron, polyhedron };

    std::vector<glm::dvec3> points;      ///< [points] World coordinates.
    std::vector<Shape> shapes;           ///< [cells]
    std::vector<std::uint64_t> first;    ///< [cells + 1] Where a cell begins in `corners`.
    std::vector<std::uint32_t> corners;  ///< In VTK's order. A polyhedron has for each face its size and its corners.
    std::vector<glm::vec3> vectors;      ///< [points] NaN marks a masked value.
    std::vector<float> scalars;          ///< [points], or empty.
    double maxVector = 0;                ///< The longest of the vectors.
    bool meansOfCells = false;           ///< The vectors were brought to the points from cells.
    std::string name;                    ///< The file's name, for messages.

    std::size_t count() const { return shapes.size(); }

    /// Calls visit(corners) for every face of a cell, with its corners in order around it.
    template <class Visit>
    void forEachFace(std::size_t cell, const Visit& visit) const;

    /// Calls visit(i) for each place in `corners` that has a corner of the cell.
    template <class Visit>
    void forEachCorner(std::size_t cell, const Visit& visit) const;

    /// Around the corners of a cell.
    Bounds boxOf(std::size_t cell) const;
};

namespace volume_faces {

/// A face of a cell: how many corners it has, and which of the cell's.
using Face = std::array<std::uint8_t, 5>;

inline constexpr Face tetra[] = {{3, 0, 1, 3}, {3, 1, 2, 3}, {3, 2, 0, 3}, {3, 0, 2, 1}};
inline constexpr Face pyramid[] = {{4, 0, 3, 2, 1}, {3, 0, 1, 4}, {3, 1, 2, 4}, {3, 2, 3, 4}, {3, 3, 0, 4}};
inline constexpr Face wedge[] = {{3, 0, 1, 2}, {3, 3, 5, 4}, {4, 0, 3, 4, 1}, {4, 1, 4, 5, 2}, {4, 2, 5, 3, 0}};
inline constexpr Face hexahedron[] = {{4, 0, 4, 7, 3}, {4, 1, 2, 6, 5}, {4, 0, 1, 5, 4},
                                      {4, 3, 7, 6, 2}, {4, 0, 3, 2, 1}, {4, 4, 5, 6, 7}};

inline std::span<const Face> of(VolumeCells::Shape shape)
{
    switch (shape) {
        case VolumeCells::Shape::tetra:
            return tetra;
        case VolumeCells::Shape::pyramid:
            return pyramid;
        case VolumeCells::Shape::wedge:
            return wedge;
        default:
            return hexahedron;
    }
}

}  // namespace volume_faces

template <class Visit>
void VolumeCells::forEachFace(std::size_t cell, const Visit& visit) const
{
    const std::span<const std::uint32_t> own(corners.data() + first[cell], first[cell + 1] - first[cell]);
    if (shapes[cell] == Shape::polyhedron) {
        for (std::size_t i = 0; i < own.size(); i += own[i] + 1) visit(own.subspan(i + 1, own[i]));
        return;
    }
    for (const volume_faces::Face& face : volume_faces::of(shapes[cell])) {
        std::array<std::uint32_t, 4> ids{};
        for (std::size_t k = 0; k < face[0]; ++k) ids[k] = own[face[k + 1]];
        visit(std::span<const std::uint32_t>(ids.data(), face[0]));
    }
}

template <class Visit>
void VolumeCells::forEachCorner(std::size_t cell, const Visit& visit) const
{
    const bool isPolyhedron = shapes[cell] == Shape::polyhedron;
    for (std::uint64_t i = first[cell]; i < first[cell + 1];) {
        std::uint64_t count = isPolyhedron ? corners[i++] : first[cell + 1] - i;
        for (; count > 0; --count) visit(i++);
    }
}

inline Bounds VolumeCells::boxOf(std::size_t cell) const
{
    Bounds box;
    forEachFace(cell, [&](std::span<const std::uint32_t> face) {
        for (const std::uint32_t id : face) box.add(points[id]);
    });
    return box;
}

}  // namespace aeolic
