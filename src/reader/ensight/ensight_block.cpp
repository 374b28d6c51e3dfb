#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "reader/ensight/ensight_geometry.h"
#include "reader/ensight/ensight_times.h"

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

/// Hexahedra, or quads where the block is one layer.
EnSightSection cellsOf(const Dims& dims)
{
    EnSightSection section;
    section.name = "block";
    section.count = 1;
    std::array<std::size_t, 3> step{1, dims[0], dims[0] * dims[1]};  // From a point to the next in x, y, z.
    std::vector<int> axes;
    for (int axis = 0; axis < 3; ++axis)
        if (dims[std::size_t(axis)] > 1) {
            axes.push_back(axis);
            section.count *= dims[std::size_t(axis)] - 1;
        }
    section.kept = axes.size() >= 2;
    section.element = findEnSightElement(axes.size() == 3 ? "hexa8" : "quad4");
    if (!section.kept) return section;
    section.corners.reserve(section.count * section.element->corners);
    const Dims cells{std::max<std::size_t>(1, dims[0] - 1), std::max<std::size_t>(1, dims[1] - 1),
                     std::max<std::size_t>(1, dims[2] - 1)};
    const std::size_t a = step[std::size_t(axes[0])], b = step[std::size_t(axes[1])],
                      up = axes.size() == 3 ? step[2] : 0;
    for (std::size_t k = 0; k < cells[2]; ++k)
        for (std::size_t j = 0; j < cells[1]; ++j)
            for (std::size_t i = 0; i < cells[0]; ++i) {
                const std::size_t first = i + step[1] * j + step[2] * k;
                for (const std::size_t base : {first, first + up}) {
                    for (const std::size_t corner : {base, base + a, base + a + b, base + b})
                        section.corners.push_back(std::int32_t(corner));
                    if (up == 0) break;
                }
            }
    return section;
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
    const std::vector<std::int32_t> numbers = stream.integers(3, "the size of a block");
    for (std::size_t axis = 0; axis < 3; ++axis) dims[axis] = numbers[axis] < 0 ? 0 : std::size_t(numbers[axis]);
    const std::size_t points = pointsOf(stream, dims);
    stream.requireRoom(fmt::format("a block of {} x {} x {} points", dims[0], dims[1], dims[2]),
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
    part.sections.push_back(cellsOf(dims));
}

}  // namespace aeolic
