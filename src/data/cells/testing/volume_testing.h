#pragma once

#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>

#include "data/cells/cell_sampler.h"
#include "data/cells/near_surface.h"
#include "data/cells/volume_cells.h"

/// Small volumes for tests.
namespace aeolic::testing_volumes {

using Shape = VolumeCells::Shape;

inline void addCell(VolumeCells& cells, Shape shape, std::initializer_list<std::uint32_t> corners)
{
    if (cells.first.empty()) cells.first.push_back(0);
    cells.shapes.push_back(shape);
    cells.corners.insert(cells.corners.end(), corners);
    cells.first.push_back(cells.corners.size());
}

/// The hexahedron `c` in cells of another shape.
inline void addHexahedron(VolumeCells& cells, Shape shape, const std::array<std::uint32_t, 8>& c)
{
    switch (shape) {
        case Shape::hexahedron:
            return addCell(cells, shape, {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]});
        case Shape::wedge:
            addCell(cells, shape, {c[0], c[1], c[2], c[4], c[5], c[6]});
            return addCell(cells, shape, {c[0], c[2], c[3], c[4], c[6], c[7]});
        case Shape::polyhedron:
            return addCell(cells, shape,
                           {4, c[0], c[4], c[7], c[3], 4, c[1], c[2], c[6], c[5], 4, c[0], c[1], c[5], c[4],
                            4, c[3], c[7], c[6], c[2], 4, c[0], c[3], c[2], c[1], 4, c[4], c[5], c[6], c[7]});
        default:
            break;
    }
    glm::dvec3 middle(0);
    for (const std::uint32_t id : c) middle += 0.125 * cells.points[id];
    const auto top = std::uint32_t(cells.points.size());
    cells.points.push_back(middle);
    for (const volume_faces::Face& f : volume_faces::hexahedron) {
        const std::uint32_t p = c[f[1]], q = c[f[2]], r = c[f[3]], s = c[f[4]];
        if (shape == Shape::pyramid) {
            addCell(cells, shape, {p, q, r, s, top});
        } else {
            addCell(cells, shape, {p, q, r, top});
            addCell(cells, shape, {p, r, s, top});
        }
    }
}

using PointOf = std::function<glm::dvec3(double, double, double)>;

/// A box of nx x ny x nz hexahedra, or of them cut into other shapes. `place`: world position of (x, y, z) in [0, 1]^3.
/// `flow`: the vector at a world position.
inline std::shared_ptr<VolumeCells> makeVolume(const glm::ivec3& n, const PointOf& place, const PointOf& flow,
                                               Shape shape = Shape::hexahedron)
{
    auto cells = std::make_shared<VolumeCells>();
    for (int z = 0; z <= n.z; ++z)
        for (int y = 0; y <= n.y; ++y)
            for (int x = 0; x <= n.x; ++x)
                cells->points.push_back(place(double(x) / n.x, double(y) / n.y, double(z) / n.z));
    const auto id = [&](int x, int y, int z) { return std::uint32_t((z * (n.y + 1) + y) * (n.x + 1) + x); };
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x)
                addHexahedron(*cells, shape,
                              {id(x, y, z), id(x + 1, y, z), id(x + 1, y + 1, z), id(x, y + 1, z), id(x, y, z + 1),
                               id(x + 1, y, z + 1), id(x + 1, y + 1, z + 1), id(x, y + 1, z + 1)});
    for (const glm::dvec3& p : cells->points) {
        cells->vectors.emplace_back(flow(p.x, p.y, p.z));
        cells->scalars.push_back(float(p.x + 2 * p.y - p.z));
        cells->maxVector = std::max(cells->maxVector, double(glm::length(cells->vectors.back())));
    }
    return cells;
}

inline glm::dvec3 unitBox(double x, double y, double z)
{
    return {x, y, z};
}

inline glm::dvec3 linearFlow(double x, double y, double z)
{
    return {1 + x - 2 * y, 3 * z - x, 0.5 + y + z};
}

/// The cells of a volume that are near a surface, with their points alone: all that a CellSampler can find at places
/// within the surface's reach. A cell is near where its middle is no farther from a triangle than the triangle's reach
/// and the cell's own diagonal. In the order of the volume.
inline VolumeCells shellOf(const VolumeCells& cells, const NearSurface& surface)
{
    VolumeCells shell;
    shell.name = cells.name;
    shell.maxVector = cells.maxVector;
    shell.meansOfCells = cells.meansOfCells;
    shell.first.push_back(0);
    constexpr std::uint32_t kNotTaken = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> ids(cells.points.size(), kNotTaken);
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
        const Bounds box = cells.boxOf(cell);
        if (!surface.isNear(box.center(), box.diagonal())) continue;
        const std::size_t before = shell.corners.size();
        shell.corners.insert(shell.corners.end(), cells.corners.begin() + std::ptrdiff_t(cells.first[cell]),
                             cells.corners.begin() + std::ptrdiff_t(cells.first[cell + 1]));
        cells.forEachCorner(cell, [&](std::uint64_t i) {
            const std::uint32_t point = cells.corners[i];
            if (ids[point] == kNotTaken) {
                ids[point] = std::uint32_t(shell.points.size());
                shell.points.push_back(cells.points[point]);
                shell.vectors.push_back(cells.vectors[point]);
                if (!cells.scalars.empty()) shell.scalars.push_back(cells.scalars[point]);
            }
            shell.corners[before + std::size_t(i - cells.first[cell])] = ids[point];
        });
        shell.shapes.push_back(cells.shapes[cell]);
        shell.first.push_back(shell.corners.size());
    }
    return shell;
}

}  // namespace aeolic::testing_volumes
