#include "data/cells/volume_shell.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "base/byte_message.h"
#include "base/parallel.h"

namespace aeolic {
namespace {

constexpr std::uint32_t kNotTaken = std::numeric_limits<std::uint32_t>::max();

/// [cells] 1 for those that are near.
std::vector<char> nearCells(const VolumeCells& cells, const NearSurface& surface)
{
    std::vector<char> near(cells.count());
    parallelRanges(near.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) {
            const Bounds box = cells.boxOf(cell);
            near[cell] = surface.isNear(box.center(), box.diagonal());
        }
    });
    return near;
}

/// Calls visit(corner) for every one of a cell's corners in VolumeCells::corners: a polyhedron's faces have their sizes
/// between them.
template <class Visit>
void forEachCorner(const VolumeCells& cells, std::size_t cell, const Visit& visit)
{
    const bool isPolyhedron = cells.shapes[cell] == VolumeCells::Shape::polyhedron;
    for (std::uint64_t i = cells.first[cell]; i < cells.first[cell + 1];) {
        std::uint64_t count = isPolyhedron ? cells.corners[i++] : cells.first[cell + 1] - i;
        for (; count > 0; --count) visit(i++);
    }
}

/// Calls visit(…) with all that a message holds.
template <class Cells, class Visit>
void withCellsMembers(Cells& cells, const Visit& visit)
{
    visit(cells.points, cells.shapes, cells.first, cells.corners, cells.vectors, cells.scalars);
}

}  // namespace

VolumeCells shellOf(const VolumeCells& cells, const NearSurface& surface)
{
    const std::vector<char> near = nearCells(cells, surface);
    VolumeCells shell;
    shell.name = cells.name;
    shell.maxVector = cells.maxVector;
    shell.meansOfCells = cells.meansOfCells;
    shell.first.push_back(0);
    std::vector<std::uint32_t> ids(cells.points.size(), kNotTaken);
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
        if (!near[cell]) continue;
        const std::size_t before = shell.corners.size();
        shell.corners.insert(shell.corners.end(), cells.corners.begin() + std::ptrdiff_t(cells.first[cell]),
                             cells.corners.begin() + std::ptrdiff_t(cells.first[cell + 1]));
        forEachCorner(cells, cell, [&](std::uint64_t i) {
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

Bytes messageOf(const VolumeCells& cells)
{
    ByteWriter writer;
    withCellsMembers(cells, [&](const auto&... members) { writer.addAll(members...); });
    return writer.take();
}

void appendCells(std::span<const std::byte> message, VolumeCells& cells)
{
    VolumeCells more;
    ByteReader reader(message);
    withCellsMembers(more, [&](auto&... members) { reader.readAll(members...); });
    const bool sound = more.first.size() == more.shapes.size() + 1 && more.vectors.size() == more.points.size() &&
                       more.first.back() == more.corners.size();
    if (!sound || !reader.atEnd()) throw std::runtime_error("a message of cells is malformed");
    const auto points = std::uint32_t(cells.points.size());
    const std::uint64_t corners = cells.corners.size();
    for (std::size_t cell = 0; cell < more.count(); ++cell)
        forEachCorner(more, cell, [&](std::uint64_t i) {
            if (more.corners[i] >= more.points.size()) throw std::runtime_error("a message of cells is malformed");
            more.corners[i] += points;
        });
    if (cells.first.empty()) cells.first.push_back(0);
    const auto append = [](auto& all, const auto& values) { all.insert(all.end(), values.begin(), values.end()); };
    append(cells.points, more.points);
    append(cells.shapes, more.shapes);
    append(cells.corners, more.corners);
    append(cells.vectors, more.vectors);
    append(cells.scalars, more.scalars);
    for (std::size_t cell = 1; cell < more.first.size(); ++cell) cells.first.push_back(corners + more.first[cell]);
}

}  // namespace aeolic
