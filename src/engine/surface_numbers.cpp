#include "engine/surface_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "engine/ray_hit.h"

namespace aeolic {
namespace {

constexpr int kBandRows = 64;
constexpr double kBesidePx = 1.0 / 64;  // So far beside a triangle a pixel may show it: corners are rounded there.
constexpr double kMostSlack = 0.5;      // Of a thin triangle's corners.

/// A surface's point on the image, in pixels. Behind the near plane it is nowhere.
struct OnImage {
    double x = 0, y = 0;
    bool isInFront = false;
};

std::vector<OnImage> pointsOnImage(const SurfaceMesh& mesh, const Camera& camera)
{
    std::vector<OnImage> points(mesh.positions.size());
    const glm::dvec3 eye = camera.positionWorld - mesh.originWorld;
    parallelFor(points.size(), [&](std::size_t i) {
        const glm::dvec3 from = glm::dvec3(mesh.positions[i]) - eye;
        const double depth = glm::dot(from, camera.forward);
        if (!(depth >= camera.nearDepth)) return;
        points[i] = {0.5 * camera.width + camera.focalPx * glm::dot(from, camera.right) / depth,
                     0.5 * camera.height - camera.focalPx * glm::dot(from, camera.up) / depth, true};
    });
    return points;
}

/// The pixels that may show a triangle, and how far below 0 its corners' weights may be there.
struct Reach {
    Extent box;
    glm::dvec3 slack{1e-9};
};

Reach reachOf(const std::array<OnImage, 3>& p, const Extent& within)
{
    if (!(p[0].isInFront && p[1].isInFront && p[2].isInFront)) return {within};
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
    const auto pixel = [](double at, int lowest, int highest) {
        return int(std::clamp(std::floor(at), double(lowest), double(highest)));
    };
    Reach reach;
    reach.box = {pixel(left - 1, within.x0, within.x1), pixel(top - 1, within.y0, within.y1),
                 pixel(right + 2, within.x0, within.x1), pixel(bottom + 2, within.y0, within.y1)};
    const double doubleArea = std::abs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x));
    for (int k = 0; k < 3; ++k) {
        const OnImage &a = p[std::size_t((k + 1) % 3)], &b = p[std::size_t((k + 2) % 3)];
        const double share = kBesidePx * std::hypot(b.x - a.x, b.y - a.y);
        reach.slack[k] = share < kMostSlack * doubleArea ? share / doubleArea : kMostSlack;
    }
    return reach;
}

/// The best for a pixel so far.
struct Shown {
    double error = std::numeric_limits<double>::infinity();  // Of its depth, as a share.
    RayHit hit;
    std::uint64_t order = 0;
};

void findInBand(const Scene& scene, const View& view, const std::vector<OnImage>& points, const Extent& band,
                const SeenSurface& seen, std::int32_t* numbers)
{
    const SurfaceMesh& mesh = scene.surface;
    const Camera& camera = view.camera;
    const std::size_t width = std::size_t(band.width());
    std::vector<Shown> shown(width * std::size_t(band.height()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        const Reach reach = reachOf({points[t[0]], points[t[1]], points[t[2]]}, band);
        const std::array<glm::dvec3, 3> corners{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
        const std::uint64_t order = mesh.order.empty() ? i : mesh.order[i];
        for (int y = reach.box.y0; y < reach.box.y1; ++y)
            for (int x = reach.box.x0; x < reach.box.x1; ++x) {
                if (!seen.covered(x, y)) continue;
                const double right = (x + 0.5 - 0.5 * camera.width) / camera.focalPx,
                             down = (y + 0.5 - 0.5 * camera.height) / camera.focalPx;
                const Ray ray{camera.positionWorld - mesh.originWorld,
                              camera.forward + right * camera.right - down * camera.up};
                const auto hit = meet(ray, corners, reach.slack);
                if (!hit || hit->depth < camera.nearDepth || (scene.frontFacesOnly && !hit->isFront)) continue;
                const double error = std::abs(hit->depth / seen.depth(view, x, y) - 1);
                const std::size_t at = std::size_t(y - band.y0) * width + std::size_t(x - band.x0);
                Shown& best = shown[at];
                const bool isBetter =
                    error < best.error - kSamePlace ||
                    (error < best.error + kSamePlace && showsBefore(*hit, order, best.hit, best.order));
                if (!isBetter) continue;
                best = {error, *hit, order};
                numbers[at] = mesh.surfaceOf[t[0]];
            }
    }
}

}  // namespace

std::vector<std::int32_t> surfaceNumbers(const Scene& scene, const View& view, const Extent& rows,
                                         const SeenSurface& seen)
{
    const std::size_t width = std::size_t(rows.width());
    std::vector<std::int32_t> numbers(width * std::size_t(rows.height()), -1);
    if (scene.surface.surfaceOf.empty()) {
        for (int y = rows.y0; y < rows.y1; ++y)
            for (int x = rows.x0; x < rows.x1; ++x)
                if (seen.covered(x, y)) numbers[std::size_t(y - rows.y0) * width + std::size_t(x - rows.x0)] = 0;
        return numbers;
    }
    const std::vector<OnImage> points = pointsOnImage(scene.surface, view.camera);
    parallelFor(std::size_t((rows.height() + kBandRows - 1) / kBandRows), [&](std::size_t i) {
        const int y0 = rows.y0 + int(i) * kBandRows;
        findInBand(scene, view, points, {rows.x0, y0, rows.x1, std::min(y0 + kBandRows, rows.y1)}, seen,
                   &numbers[i * std::size_t(kBandRows) * width]);
    });
    return numbers;
}

}  // namespace aeolic
