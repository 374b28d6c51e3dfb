#include "data/vtk/surface/isosurface.h"

#include <fmt/format.h>

#include <atomic>
#include <limits>

#include "aeolic/error.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "data/surface_range.h"

namespace aeolic {
namespace {

constexpr std::size_t kGrainLayers = 8;

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

void requireWithinRange(const SurfaceSpec& spec, const std::string& where, const std::array<double, 2>& range)
{
    // At the range's very ends there is no surface but points.
    if (!(spec.value > range[0] && spec.value < range[1]))
        throw InputError(where, fmt::format("'{}' is not within the array's range", spec.text),
                         range[0] <= range[1] ? fmt::format("a value between {:.6g} and {:.6g}", range[0], range[1])
                                              : std::string("an array with finite values"));
}

void requireIsosurface(const SurfaceSpec& spec, const std::string& where, const std::array<double, 2>& range,
                       std::size_t triangles)
{
    requireWithinRange(spec, where, range);
    if (triangles == 0)
        throw InputError(where, fmt::format("'{}' has no triangle", spec.text), "a value that a cell's points enclose");
}

void requireRoomFor(const SurfaceSpec& spec, const std::string& where, const IsosurfaceSize& size, int readers)
{
    const auto millions = [](std::uint64_t count) { return fmt::format("{:.1f} million", double(count) / 1e6); };
    if (size.points > std::numeric_limits<std::uint32_t>::max())
        throw InputError(where, fmt::format("'{}' has {} points", spec.text, millions(size.points)),
                         "fewer than 2^32: another value, or --bricks on with more ranks");
    const std::string copies = readers > 1 ? fmt::format(" on each of {} ranks of a host", readers) : "";
    requireMemory(where, fmt::format("'{}' with {} triangles{}", spec.text, millions(size.triangles), copies),
                  std::uint64_t(readers) * size.bytes());
}

IsosurfaceSize isosurfaceSize(const GridField& scalar, const Brick& cells, double value)
{
    if (cells.empty()) return {};
    const auto count = std::size_t(cells.cellHi[2] - cells.cellLo[2]);
    const MarchingCubes cubes(scalar, cells, value, boundsOf(scalar).center());
    std::atomic<std::uint64_t> points{0}, triangles{0};
    parallelRanges(count, kGrainLayers, [&](std::size_t begin, std::size_t end) {
        const IsosurfaceSize size = cubes.count(begin, end);
        points += size.points;
        triangles += size.triangles;
    });
    return {points, triangles};
}

SurfaceMesh isosurface(const GridField& scalar, const Brick& cells, double value)
{
    SurfaceMesh mesh;
    mesh.originWorld = boundsOf(scalar).center();
    if (cells.empty()) return mesh;
    const auto count = std::size_t(cells.cellHi[2] - cells.cellLo[2]);
    std::vector<CubeLayer> layers(count + 1);
    const MarchingCubes cubes(scalar, cells, value, mesh.originWorld);
    parallelRanges(count, kGrainLayers, [&](std::size_t begin, std::size_t end) { cubes.extract(begin, end, layers); });
    cubes.close(layers.back());
    for (CubeLayer& layer : layers) {
        const auto first = std::uint32_t(mesh.positions.size());
        for (auto& triangle : layer.triangles)
            for (std::uint32_t& corner : triangle) corner += first;
        append(mesh.positions, layer.positions);
        append(mesh.normals, layer.normals);
        append(mesh.triangles, layer.triangles);
        append(mesh.order, layer.order);
        layer = {};  // Layers and mesh must not both be whole in memory.
    }
    return mesh;
}

}  // namespace aeolic
