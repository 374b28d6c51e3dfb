#include "engine/surface_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/parallel.h"
#include "engine/ray_hit.h"

namespace aeolic {
namespace {

constexpr int kBandRows = 64;
/// What is seen may be farther from its triangle's plane by this share of its depth. Pictures round corners to parts of
/// a pixel, so a pixel at an open border may also lie beside its triangle.
constexpr double kMostError = 1e-2;
constexpr int kNeighbours = 4;  // So many pixels to either side such a pixel asks whose number it takes.

/// A surface's point on the image, in pixels. Behind the near plane it is nowhere.
struct OnImage {
    double x = 0, y = 0, depth = 0;
    bool isInFront = false;
};

OnImage onImage(const glm::dvec3& fromEye, const Camera& camera)
{
    const double depth = glm::dot(fromEye, camera.forward);
    if (!(depth >= camera.nearDepth)) return {0, 0, depth, false};
    return {0.5 * camera.width + camera.focalPx * glm::dot(fromEye, camera.right) / depth,
            0.5 * camera.height - camera.focalPx * glm::dot(fromEye, camera.up) / depth, depth, true};
}

std::vector<OnImage> pointsOnImage(const SurfaceMesh& mesh, const Camera& camera)
{
    std::vector<OnImage> points(mesh.positions.size());
    const glm::dvec3 eye = camera.positionWorld - mesh.originWorld;
    parallelFor(points.size(),
                [&](std::size_t i) { points[i] = onImage(glm::dvec3(mesh.positions[i]) - eye, camera); });
    return points;
}

/// The pixels of some rows that a triangle may show in: those around it, cut at the near plane.
class PixelBox {
public:
    void add(const OnImage& p)
    {
        left_ = std::min(left_, p.x), right_ = std::max(right_, p.x);
        top_ = std::min(top_, p.y), bottom_ = std::max(bottom_, p.y);
    }
    bool meetsRows(const Extent& within) const { return bottom_ + 2 >= within.y0 && top_ - 1 <= within.y1; }
    Extent within(const Extent& all) const
    {
        const auto pixel = [](double at, int lowest, int highest) {
            return int(std::clamp(std::floor(at), double(lowest), double(highest)));
        };
        return {pixel(left_ - 1, all.x0, all.x1), pixel(top_ - 1, all.y0, all.y1), pixel(right_ + 2, all.x0, all.x1),
                pixel(bottom_ + 2, all.y0, all.y1)};
    }

private:
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double left_ = kInfinity, right_ = -kInfinity, top_ = kInfinity, bottom_ = -kInfinity;
};

PixelBox boxOf(const SurfaceMesh& mesh, const Camera& camera, const std::vector<OnImage>& points, std::size_t triangle)
{
    const auto& t = mesh.triangles[triangle];
    const glm::dvec3 eye = camera.positionWorld - mesh.originWorld;
    PixelBox box;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t i = t[k], j = t[(k + 1) % 3];
        const OnImage &a = points[i], &b = points[j];
        if (a.isInFront) box.add(a);
        if (a.isInFront == b.isInFront) continue;
        const glm::dvec3 from = glm::dvec3(mesh.positions[i]) - eye, to = glm::dvec3(mesh.positions[j]) - eye;
        // A little in front of the plane, so that rounding does not lose it.
        const double share = (camera.nearDepth * (1 + 1e-9) - a.depth) / (b.depth - a.depth);
        box.add(onImage(from + share * (to - from), camera));
    }
    return box;
}

/// The best for a pixel so far.
struct Shown {
    double error = std::numeric_limits<double>::infinity();  // Of its depth, as a share.
    RayHit hit;
    std::uint64_t order = 0;
};

/// Gives pixels of a row that no triangle fits the number of the pixel beside them that is nearest in depth. Only the
/// row's own pixels count, so it does not matter which rank has the rows above and below.
void takeNeighbours(std::span<const Shown> shown, const SeenSurface& seen, const View& view, int y,
                    std::span<std::int32_t> numbers)
{
    const int width = int(numbers.size());
    const auto fits = [&](int x) { return shown[std::size_t(x)].error <= kMostError; };
    for (int x = 0; x < width; ++x) {
        if (fits(x) || !seen.covered(x, y)) continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (int other = std::max(x - kNeighbours, 0); other <= std::min(x + kNeighbours, width - 1); ++other) {
            if (!fits(other)) continue;
            const double apart = std::abs(seen.depth(view, other, y) - seen.depth(view, x, y));
            if (apart < nearest) nearest = apart, numbers[std::size_t(x)] = numbers[std::size_t(other)];
        }
    }
}

void findInBand(const Scene& scene, const View& view, const std::vector<OnImage>& points, const Extent& band,
                const SeenSurface& seen, std::int32_t* numbers)
{
    const SurfaceMesh& mesh = scene.surface;
    const Camera& camera = view.camera;
    const std::size_t width = std::size_t(band.width());
    std::vector<Shown> shown(width * std::size_t(band.height()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        const PixelBox around = boxOf(mesh, camera, points, i);
        if (!around.meetsRows(band)) continue;
        const Extent box = around.within(band);
        const std::array<glm::dvec3, 3> corners{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
        const std::uint64_t order = mesh.order.empty() ? i : mesh.order[i];
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x) {
                if (!seen.covered(x, y)) continue;
                const double right = (x + 0.5 - 0.5 * camera.width) / camera.focalPx,
                             down = (y + 0.5 - 0.5 * camera.height) / camera.focalPx;
                const Ray ray{camera.positionWorld - mesh.originWorld,
                              camera.forward + right * camera.right - down * camera.up};
                const auto hit = meet(ray, corners);
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
    for (int y = band.y0; y < band.y1; ++y) {
        const auto first = shown.begin() + std::ptrdiff_t(width) * (y - band.y0);
        takeNeighbours({first, first + std::ptrdiff_t(width)}, seen, view, y,
                       {numbers + width * std::size_t(y - band.y0), width});
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
