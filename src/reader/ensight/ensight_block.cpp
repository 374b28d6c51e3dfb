#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "base/memory.h"
#include "reader/ensight/ensight_geometry.h"

namespace aeolic {
namespace {

constexpr std::uint64_t kBytesOfPoint = 150;  // With its cell, here and in VTK.

using Dims = std::array<std::size_t, 3>;

/// The number of points, if they can be numbered in 32 bits.
std::size_t pointsOf(const EnSightStream& stream, const Dims& dims)
{
    constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
    std::size_t points = 1;
    for (const std::size_t n : dims) {
        if (n < 1 || points > most / n)
            stream.fail(fmt::format("a block has {} x {} x {} points", dims[0], dims[1], dims[2]),
                        "1 to 2147483647 in all");
        points *= n;
    }
    return points;
}

/// The points of three axes' coordinates, x fastest.
void spread(const std::array<std::vector<float>, 3>& axes, std::size_t points, EnSightPart& part)
{
    for (std::vector<float>& values : part.points) values.reserve(points);
    for (const float z : axes[2])
        for (const float y : axes[1])
            for (const float x : axes[0]) {
                part.points[0].push_back(x);
                part.points[1].push_back(y);
                part.points[2].push_back(z);
            }
}

}  // namespace

void readEnSightBlock(EnSightStream& stream, const std::string& kind, EnSightPart& part)
{
    bool uniform = false, rectilinear = false;
    for (const std::string& word : ensightWords(kind)) {
        uniform = uniform || word == "uniform";
        rectilinear = rectilinear || word == "rectilinear";
        if (word != "block" && word != "uniform" && word != "rectilinear" && word != "curvilinear")
            stream.fail(fmt::format("part {} is '{}'", part.number, kind),
                        "a block without blanked points, ghosts or a range");
    }
    Dims dims{};
    const std::vector<std::int64_t> lengths = stream.integers(3, "the size of a block");
    for (std::size_t axis = 0; axis < 3; ++axis) dims[axis] = std::size_t(std::max<std::int64_t>(lengths[axis], 0));
    const std::size_t points = pointsOf(stream, dims);
    requireMemory(stream.path(), fmt::format("a block of {} x {} x {} points", dims[0], dims[1], dims[2]),
                  points * kBytesOfPoint);
    if (uniform) {
        const std::vector<float> origin = readEnSightCoordinates(stream, 3), delta = readEnSightCoordinates(stream, 3);
        std::array<std::vector<float>, 3> axes;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t i = 0; i < dims[axis]; ++i)
                axes[axis].push_back(float(double(origin[axis]) + double(i) * double(delta[axis])));
        spread(axes, points, part);
    } else if (rectilinear) {
        std::array<std::vector<float>, 3> axes;
        for (std::size_t axis = 0; axis < 3; ++axis) axes[axis] = readEnSightCoordinates(stream, dims[axis]);
        spread(axes, points, part);
    } else {
        for (std::vector<float>& axis : part.points) axis = readEnSightCoordinates(stream, points);
    }
    part.block = true;
    std::size_t count = 1;  // A direction of one point counts as one cell.
    for (const std::size_t n : dims) count *= std::max<std::size_t>(n - 1, 1);
    PartCells cells = orderedCells(lengths);
    const bool kept = cells.count > 0;
    part.sections.push_back({"block", count, kept, std::move(cells)});
}

}  // namespace aeolic
