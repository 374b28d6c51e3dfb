#include "data/vtk/surface/isosurface.h"

#include <fmt/format.h>
#include <vtkMarchingCubesTriangleCases.h>

#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "aeolic/error.h"
#include "base/append.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "data/surface_range.h"

namespace aeolic {
namespace {

constexpr std::size_t kGrainLayers = 8;
constexpr int kMostTrianglesOfCell = 5;

enum : std::uint8_t { kBelow = 0, kAbove = 1, kMasked = 2 };

bool crosses(std::uint8_t a, std::uint8_t b)
{
    return a + b == kBelow + kAbove;  // A masked end makes it at least 2.
}

/// The corners of VTK's cell, and the edges between them: from which corner, along which axis.
constexpr int kCorners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
constexpr int kEdges[12][2] = {{0, 0}, {1, 1}, {3, 0}, {0, 1}, {4, 0}, {5, 1},
                               {7, 0}, {4, 1}, {0, 2}, {1, 2}, {3, 2}, {2, 2}};

/// What one layer of cells adds to an isosurface: the points on edges from its lower samples, and its triangles. These
/// count points from the first of the layer; those of the next layer follow.
struct CubeLayer {
    std::vector<glm::vec3> positions, normals;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint64_t> order;  ///< SurfaceMesh::order
};

/// Marching cubes over the layers of a grid's cells across z.
class MarchingCubes {
public:
    /// `scalar` must outlive it. Positions are relative to `originWorld`.
    MarchingCubes(const GridField& scalar, const Brick& cells, double value, const glm::dvec3& originWorld)
        : scalar_(scalar),
          cells_(cells),
          value_(value),
          toLocal_(scalar.originWorld - originWorld),
          first_(scalar.firstSample()),
          held_(scalar.heldDims()),
          width_(cells.cellHi[0] - cells.cellLo[0] + 1),
          height_(cells.cellHi[1] - cells.cellLo[1] + 1)
    {
    }

    /// Layers [begin, end) of the cells, counted from their first. Any number of ranges at once.
    void extract(std::size_t begin, std::size_t end, std::vector<CubeLayer>& layers) const
    {
        forLayers(begin, end, [&](std::size_t k, Plane& lower, const Plane& upper) {
            addPoints(std::int64_t(k), lower, upper, layers[k]);
            addTriangles(std::int64_t(k), lower, upper, layers[k]);
        });
    }

    /// The points on the uppermost samples, which are below no layer.
    void close(CubeLayer& layer) const
    {
        Plane top;
        const std::int64_t k = cells_.cellHi[2] - cells_.cellLo[2];
        classify(k, top);
        addFlatPoints(k, top, layer);
    }

    /// How much extract() would find in these layers, and close() above the last one. Takes no memory for it.
    IsosurfaceSize count(std::size_t begin, std::size_t end) const
    {
        IsosurfaceSize size;
        const auto countPoint = [&](std::int64_t, std::int64_t, int) { ++size.points; };
        const auto countTriangle = [&](const std::array<EdgePoint, 3>&, std::uint64_t) { ++size.triangles; };
        forLayers(begin, end, [&](std::size_t k, const Plane& lower, const Plane& upper) {
            forFlatEdges(lower, countPoint);
            for (std::size_t i = 0; i < lower.side.size(); ++i) size.points += crosses(lower.side[i], upper.side[i]);
            forTriangles(std::int64_t(k), lower, upper, countTriangle);
            const bool isLast = std::int64_t(k) + 1 == cells_.cellHi[2] - cells_.cellLo[2];
            if (isLast) forFlatEdges(upper, countPoint);
        });
        return size;
    }

private:
    using Index = std::array<std::int64_t, 3>;  // A sample's place.

    /// A plane of samples: which of them are above the value, and the numbers of the points on the edges that begin
    /// there.
    struct Plane {
        std::vector<std::uint8_t> side;                  // [samples]
        std::array<std::vector<std::uint32_t>, 3> edge;  // [samples] per axis, where the edge crosses.
    };

    /// A point of the surface: on the edge that begins at a sample of the lower or upper plane.
    struct EdgePoint {
        bool above;
        std::size_t axis, sample;
    };

    /// Calls visit(k, lower, upper) for each of the layers [begin, end), with the planes of samples around it.
    template <class Visit>
    void forLayers(std::size_t begin, std::size_t end, const Visit& visit) const
    {
        Plane lower, upper;
        classify(std::int64_t(begin), lower);
        for (std::size_t k = begin; k < end; ++k) {
            classify(std::int64_t(k) + 1, upper);
            visit(k, lower, upper);
            std::swap(lower, upper);
        }
    }

    double at(const Index& sample) const
    {
        return double(scalar_.floats()[((sample[2] - first_[2]) * held_[1] + sample[1] - first_[1]) * held_[0] +
                                       sample[0] - first_[0]]);
    }

    std::size_t inPlane(std::int64_t x, std::int64_t y) const { return std::size_t(y * width_ + x); }

    Index global(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        return {cells_.cellLo[0] + x, cells_.cellLo[1] + y, cells_.cellLo[2] + z};
    }

    /// Calls visit(x, y, axis) for every edge along x and y that crosses, in the order in which points are numbered.
    template <class Visit>
    void forFlatEdges(const Plane& plane, const Visit& visit) const
    {
        for (std::int64_t y = 0; y < height_; ++y)
            for (std::int64_t x = 0; x < width_; ++x) {
                const std::uint8_t side = plane.side[inPlane(x, y)];
                if (x + 1 < width_ && crosses(side, plane.side[inPlane(x + 1, y)])) visit(x, y, 0);
                if (y + 1 < height_ && crosses(side, plane.side[inPlane(x, y + 1)])) visit(x, y, 1);
            }
    }

    void classify(std::int64_t k, Plane& plane) const
    {
        const auto samples = std::size_t(width_ * height_);
        plane.side.resize(samples);
        for (auto& edge : plane.edge) edge.resize(samples);
        for (std::int64_t y = 0; y < height_; ++y)
            for (std::int64_t x = 0; x < width_; ++x) {
                const double v = at(global(x, y, k));
                plane.side[inPlane(x, y)] = v >= value_ ? kAbove : v < value_ ? kBelow : kMasked;
            }
        std::uint32_t points = 0;
        forFlatEdges(plane, [&](std::int64_t x, std::int64_t y, int axis) {
            plane.edge[std::size_t(axis)][inPlane(x, y)] = points++;
        });
    }

    void addFlatPoints(std::int64_t k, const Plane& plane, CubeLayer& layer) const
    {
        forFlatEdges(plane, [&](std::int64_t x, std::int64_t y, int axis) { addPoint(global(x, y, k), axis, layer); });
    }

    void addPoints(std::int64_t k, Plane& lower, const Plane& upper, CubeLayer& layer) const
    {
        addFlatPoints(k, lower, layer);
        for (std::int64_t y = 0; y < height_; ++y)
            for (std::int64_t x = 0; x < width_; ++x) {
                const std::size_t i = inPlane(x, y);
                if (!crosses(lower.side[i], upper.side[i])) continue;
                lower.edge[2][i] = std::uint32_t(layer.positions.size());
                addPoint(global(x, y, k), 2, layer);
            }
    }

    /// The rise per world unit, from the neighbours on either side that are not masked.
    glm::dvec3 gradient(const Index& sample) const
    {
        glm::dvec3 gradient(0);
        for (int c = 0; c < 3; ++c) {
            const auto a = std::size_t(c);
            Index lo = sample, hi = sample;
            const auto isUsable = [&](const Index& s) { return s[a] >= 0 && s[a] < scalar_.dims[a] && at(s) == at(s); };
            --lo[a], ++hi[a];
            if (!isUsable(lo)) lo = sample;
            if (!isUsable(hi)) hi = sample;
            if (hi[a] > lo[a]) gradient[c] = (at(hi) - at(lo)) / (double(hi[a] - lo[a]) * scalar_.spacingWorld[c]);
        }
        return gradient;
    }

    void addPoint(const Index& from, int axis, CubeLayer& layer) const
    {
        Index to = from;
        ++to[std::size_t(axis)];
        const double a = at(from), b = at(to), t = (value_ - a) / (b - a);
        glm::dvec3 place(from[0], from[1], from[2]);
        place[axis] += t;
        layer.positions.emplace_back(toLocal_ + place * scalar_.spacingWorld);
        const glm::dvec3 below = gradient(from), normal = below + t * (gradient(to) - below);
        const double length = glm::length(normal);
        glm::vec3 along(0);  // Where differences over two cells cancel there is still the one over this edge.
        along[axis] = b > a ? 1.0f : -1.0f;
        layer.normals.push_back(length > 0 && std::isfinite(length) ? glm::vec3(normal / length) : along);
    }

    /// Calls visit(corners, order) for every triangle of a layer; each corner is a point on an edge.
    template <class Visit>
    void forTriangles(std::int64_t k, const Plane& lower, const Plane& upper, const Visit& visit) const
    {
        const vtkMarchingCubesTriangleCases* cases = vtkMarchingCubesTriangleCases::GetCases();
        const auto side = [&](std::int64_t x, std::int64_t y, const int(&c)[3]) {
            return (c[2] ? upper : lower).side[inPlane(x + c[0], y + c[1])];
        };
        for (std::int64_t y = 0; y + 1 < height_; ++y)
            for (std::int64_t x = 0; x + 1 < width_; ++x) {
                unsigned index = 0;
                for (unsigned corner = 0; corner < 8; ++corner)
                    index |= unsigned(side(x, y, kCorners[corner]) == kAbove) << corner;
                if (index == 0 || index == 255) continue;
                const Index cell = global(x, y, k);
                std::uint64_t order =
                    std::uint64_t((cell[2] * (scalar_.dims[1] - 1) + cell[1]) * (scalar_.dims[0] - 1) + cell[0]) *
                    kMostTrianglesOfCell;
                for (const EDGE_LIST* edge = cases[index].edges; edge[0] >= 0; edge += 3, ++order) {
                    std::array<EdgePoint, 3> corners{};
                    bool whole = true;
                    for (std::size_t corner = 0; corner < 3; ++corner) {
                        const auto& [from, axis] = kEdges[edge[corner]];
                        const int(&c)[3] = kCorners[from];
                        int end[3] = {c[0], c[1], c[2]};
                        ++end[axis];
                        whole = whole && crosses(side(x, y, c), side(x, y, end));
                        if (!whole) break;
                        corners[corner] = {c[2] == 1, std::size_t(axis), inPlane(x + c[0], y + c[1])};
                    }
                    if (whole) visit(corners, order);
                }
            }
    }

    void addTriangles(std::int64_t k, const Plane& lower, const Plane& upper, CubeLayer& layer) const
    {
        const auto pointsBelow = std::uint32_t(layer.positions.size());  // The next layer's first follows.
        forTriangles(k, lower, upper, [&](const std::array<EdgePoint, 3>& corners, std::uint64_t order) {
            std::array<std::uint32_t, 3> triangle{};
            for (std::size_t i = 0; i < 3; ++i) {
                const auto& [above, axis, at] = corners[i];
                triangle[i] = above ? pointsBelow + upper.edge[axis][at] : lower.edge[axis][at];
            }
            layer.triangles.push_back(triangle);
            layer.order.push_back(order);
        });
    }

    const GridField& scalar_;
    const Brick cells_;
    const double value_;
    const glm::dvec3 toLocal_;
    const GridIndex first_, held_;
    const std::int64_t width_, height_;  // Samples of a plane.
};

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
        appendAll(mesh.positions, layer.positions);
        appendAll(mesh.normals, layer.normals);
        appendAll(mesh.triangles, layer.triangles);
        appendAll(mesh.order, layer.order);
        layer = {};  // Layers and mesh must not both be whole in memory.
    }
    return mesh;
}

}  // namespace aeolic
