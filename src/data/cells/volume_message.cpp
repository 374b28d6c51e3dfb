#include "data/cells/volume_message.h"

#include <stdexcept>

#include "base/append.h"
#include "base/byte_message.h"

namespace aeolic {

template <PerhapsConst<VolumeCells> Cells, class Visit>
void withMembers(Cells& cells, const Visit& visit)
{
    visit(cells.points, cells.shapes, cells.first, cells.corners, cells.vectors, cells.scalars);
}

Bytes messageOf(const VolumeCells& cells)
{
    return byteMessage(cells);
}

void appendCells(std::span<const std::byte> message, VolumeCells& cells)
{
    VolumeCells more;
    ByteReader reader(message);
    reader.read(more);
    const bool sound = more.first.size() == more.shapes.size() + 1 && more.vectors.size() == more.points.size() &&
                       more.first.back() == more.corners.size();
    if (!sound || !reader.atEnd()) throw std::runtime_error("a message of cells is malformed");
    const auto points = std::uint32_t(cells.points.size());
    const std::uint64_t corners = cells.corners.size();
    for (std::size_t cell = 0; cell < more.count(); ++cell)
        more.forEachCorner(cell, [&](std::uint64_t i) {
            if (more.corners[i] >= more.points.size()) throw std::runtime_error("a message of cells is malformed");
            more.corners[i] += points;
        });
    if (cells.first.empty()) cells.first.push_back(0);
    appendAll(cells.points, more.points);
    appendAll(cells.shapes, more.shapes);
    appendAll(cells.corners, more.corners);
    appendAll(cells.vectors, more.vectors);
    appendAll(cells.scalars, more.scalars);
    for (std::size_t cell = 1; cell < more.first.size(); ++cell) cells.first.push_back(corners + more.first[cell]);
}

}  // namespace aeolic
