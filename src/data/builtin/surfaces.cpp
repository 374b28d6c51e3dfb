#include "data/builtin/surfaces.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

#include "aeolic/error.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "data/builtin/teapot.h"

namespace aeolic {
namespace {

constexpr std::int64_t maxTriangles = 50'000'000;
constexpr double torusMajorRadius = 1.0, torusMinorRadius = 0.4;
constexpr double waveHeight = 0.1, wavePeriod = 5;
constexpr std::size_t rowGrain = 8;

/// cos and sin of `count` angles that divide a full turn evenly, starting at 0. With `count` a multiple of four the
/// axes are met, so the mesh is as wide as the exact shape.
std::vector<glm::dvec2> unitCircle(std::int64_t count)
{
    std::vector<glm::dvec2> points(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / double(count);
        points[std::size_t(i)] = {std::cos(angle), std::sin(angle)};
    }
    return points;
}

std::int64_t ceilDivide(std::int64_t a, std::int64_t b)
{
    return (a + b - 1) / b;
}

void resize(SurfaceMesh& mesh, std::int64_t points, std::int64_t triangles)
{
    mesh.positions.resize(std::size_t(points));
    mesh.normals.resize(std::size_t(points));
    mesh.triangles.resize(std::size_t(triangles));
}

/// Two triangles for the cell with corners a (u, v), b (u+1, v), c (u, v+1), d (u+1, v+1).
void addCell(SurfaceMesh& mesh, std::size_t at, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    mesh.triangles[at] = {a, b, d};
    mesh.triangles[at + 1] = {a, d, c};
}

/// Latitude and longitude: `bands` from pole to pole, `columns` around; one point at each pole.
/// 2 columns (bands - 1) triangles.
SurfaceMesh makeSphere(std::int64_t triangles)
{
    const std::int64_t bands = 2 * std::max<std::int64_t>(1, std::llround(std::sqrt(double(triangles) / 4) / 2));
    const std::int64_t columns = 4 * std::max<std::int64_t>(1, ceilDivide(triangles, 8 * (bands - 1)));
    const std::int64_t rings = bands - 1;

    SurfaceMesh mesh;
    resize(mesh, columns * rings + 2, 2 * columns * rings);
    const auto southPole = std::uint32_t(columns * rings), northPole = southPole + 1;
    mesh.positions[southPole] = {0, 0, -1};
    mesh.positions[northPole] = {0, 0, 1};
    const std::vector<glm::dvec2> around = unitCircle(columns);

    parallelRanges(std::size_t(rings), rowGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t ring = begin; ring < end; ++ring) {
            const double polar = std::numbers::pi * double(ring + 1) / double(bands);
            const double radius = std::sin(polar), z = -std::cos(polar);
            const auto first = std::uint32_t(ring * around.size());
            for (std::uint32_t i = 0; i < around.size(); ++i) {
                mesh.positions[first + i] = glm::vec3(glm::dvec3(radius * around[i], z));
            }
        }
    });
    // Cap, bands between neighbouring rings, cap: n + 2 n (rings - 1) + n triangles.
    const auto n = std::uint32_t(columns);
    parallelRanges(std::size_t(bands), rowGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t band = begin; band < end; ++band) {
            const std::uint32_t upper = std::uint32_t(band) * n, lower = upper - n;
            std::size_t at = band == 0 ? 0 : n + 2 * n * (band - 1);
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t next = (i + 1) % n;
                if (band == 0) {
                    mesh.triangles[at++] = {southPole, next, i};
                } else if (band + 1 == std::size_t(bands)) {
                    mesh.triangles[at++] = {lower + i, lower + next, northPole};
                } else {
                    addCell(mesh, at, lower + i, lower + next, upper + i, upper + next);
                    at += 2;
                }
            }
        }
    });
    mesh.normals = mesh.positions;  // Radius 1 about the origin.
    return mesh;
}

/// `columns` around the z axis, `rows` around the tube; cells about as long as wide. 2 columns rows triangles.
SurfaceMesh makeTorus(std::int64_t triangles)
{
    const double columnsPerRow = torusMajorRadius / torusMinorRadius;
    const double idealRows = std::sqrt(double(triangles) / (2 * columnsPerRow));
    const std::int64_t rows = 4 * std::max<std::int64_t>(1, std::llround(idealRows / 4));
    const std::int64_t columns = 4 * std::max<std::int64_t>(1, ceilDivide(triangles, 8 * rows));

    SurfaceMesh mesh;
    resize(mesh, columns * rows, 2 * columns * rows);
    const std::vector<glm::dvec2> around = unitCircle(columns), tube = unitCircle(rows);
    const auto n = std::uint32_t(columns);
    parallelRanges(tube.size(), rowGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const auto first = std::uint32_t(row) * n, above = std::uint32_t((row + 1) % tube.size()) * n;
            const double radius = torusMajorRadius + torusMinorRadius * tube[row].x;
            const double z = torusMinorRadius * tube[row].y;
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t next = (i + 1) % n;
                mesh.positions[first + i] = glm::vec3(glm::dvec3(radius * around[i], z));
                mesh.normals[first + i] = glm::vec3(glm::dvec3(tube[row].x * around[i], tube[row].y));
                addCell(mesh, 2 * (std::size_t(first) + i), first + i, first + next, above + i, above + next);
            }
        }
    });
    return mesh;
}

/// A sheet over [-1, 1] x [-1, 1]; place(x) gives its height there and the height's slope along x.
template <class Place>
SurfaceMesh makeSheet(std::int64_t triangles, const Place& place)
{
    const auto cells = std::uint32_t(std::ceil(std::sqrt(double(triangles) / 2)));
    const std::uint32_t points = cells + 1;
    SurfaceMesh mesh;
    resize(mesh, std::int64_t(points) * points, 2 * std::int64_t(cells) * cells);
    const auto coordinate = [&](std::size_t i) { return float(-1 + 2 * double(i) / double(cells)); };
    parallelRanges(points, rowGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j) {
            const auto first = std::uint32_t(j) * points;
            for (std::uint32_t i = 0; i < points; ++i) {
                const auto [height, slope] = place(-1 + 2 * double(i) / double(cells));
                mesh.positions[first + i] = {coordinate(i), coordinate(j), float(height)};
                mesh.normals[first + i] = glm::vec3(glm::normalize(glm::dvec3(0.0 - slope, 0, 1)));
                if (i == cells || j == cells) continue;
                const std::uint32_t a = first + i, c = a + points;
                addCell(mesh, 2 * (j * cells + i), a, a + 1, c, c + 1);
            }
        }
    });
    return mesh;
}

struct Place {
    double height, slope;
};

SurfaceMesh makePlane(std::int64_t triangles)
{
    return makeSheet(triangles, [](double) { return Place{0, 0}; });
}

/// A wave of length 1 that travels along x.
SurfaceMesh makeWave(std::int64_t triangles, double time)
{
    const double turns = std::fmod(time, wavePeriod) / wavePeriod;  // The sine of 1e30 could be anything.
    return makeSheet(triangles, [turns](double x) {
        const double phase = 2 * std::numbers::pi * (x - turns);
        return Place{waveHeight * std::sin(phase), waveHeight * 2 * std::numbers::pi * std::cos(phase)};
    });
}

template <SurfaceMesh (*make)(std::int64_t)>
SurfaceMesh still(std::int64_t triangles, double)
{
    return make(triangles);
}

struct BuiltinSurface {
    std::string_view name;
    std::int64_t defaultTriangles;
    SurfaceMesh (*make)(std::int64_t triangles, double time);
    double period = 0;  ///< 0: it stands still.
};
constexpr int waveMomentsPerPeriod = 20;
constexpr std::array<BuiltinSurface, 5> builtinSurfaces{{{"teapot", 25'000, still<makeTeapot>},
                                                         {"sphere", 25'000, still<makeSphere>},
                                                         {"torus", 25'000, still<makeTorus>},
                                                         {"plane", 512, still<makePlane>},
                                                         {"wave", 25'000, makeWave, wavePeriod}}};
static_assert(std::ranges::equal(builtinSurfaces, builtinSurfaceNames, {}, &BuiltinSurface::name));

const BuiltinSurface* findSurface(const std::string& spec)
{
    const auto found = std::ranges::find(builtinSurfaces, nameInSpec(spec), &BuiltinSurface::name);
    return found == builtinSurfaces.end() ? nullptr : &*found;
}

const BuiltinSurface& requireSurface(const std::string& spec)
{
    const BuiltinSurface* const surface = findSurface(spec);
    if (!surface) throw InputError("--surface", "'" + spec + "'", "teapot, sphere, torus, plane or wave");
    return *surface;
}

std::int64_t parseTriangles(const std::string& spec, const BuiltinSurface& surface)
{
    const std::size_t colon = spec.find(':');
    if (colon == std::string::npos) return surface.defaultTriangles;
    std::int64_t triangles = 0;
    const char* const end = spec.data() + spec.size();
    const auto [stop, error] = std::from_chars(spec.data() + colon + 1, end, triangles);
    if (error != std::errc() || stop != end || triangles < 2 || triangles > maxTriangles) {
        throw InputError(
            "--surface", "'" + spec + "'",
            std::string(surface.name) + "[:TRIANGLES] with 2 to " + std::to_string(maxTriangles) + " triangles");
    }
    return triangles;
}

}  // namespace

std::vector<double> builtinSurfaceTimes(const std::string& spec)
{
    const BuiltinSurface* const surface = findSurface(spec);
    const double period = surface ? surface->period : 0;
    std::vector<double> times;
    for (int i = 0; period > 0 && i <= waveMomentsPerPeriod; ++i) times.push_back(period * i / waveMomentsPerPeriod);
    return times;
}

Bounds builtinSurfaceBounds(const std::string& spec, const SurfaceMesh& mesh)
{
    Bounds bounds = mesh.bounds();
    if (const BuiltinSurface* const surface = findSurface(spec); surface && surface->make == makeWave) {
        bounds.lo.z = float(-waveHeight);  // Rounded in the mesh's way.
        bounds.hi.z = float(waveHeight);
    }
    return bounds;
}

std::uint64_t builtinSurfaceTriangles(const std::string& spec)
{
    return std::uint64_t(parseTriangles(spec, requireSurface(spec)));
}

SurfaceMesh makeBuiltinSurface(const std::string& spec, double time)
{
    const BuiltinSurface& surface = requireSurface(spec);
    const std::int64_t triangles = parseTriangles(spec, surface);
    // Half as many points as triangles; a quarter more for the teapot's doubled patch edges and rounding up.
    const std::uint64_t bytesPerTriangle = sizeof(SurfaceMesh::triangles[0]) + sizeof(glm::vec3);
    requireMemory("--surface", "'" + spec + "'", std::uint64_t(triangles) * bytesPerTriangle * 5 / 4);
    SurfaceMesh mesh = surface.make(triangles, time);
    mesh.name = surface.name;
    return mesh;
}

}  // namespace aeolic
