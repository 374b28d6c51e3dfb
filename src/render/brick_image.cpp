#include "render/brick_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aeolic {
namespace {

constexpr double kMarginCells = 0.01;  // The rim belongs to the outermost cells (cpu/project/field_sampling-inl.h).
constexpr double kMarginPx = 2;        // Rounding of vertices and of the view.

}  // namespace

Extent imageOf(const Bounds& boxWorld, const glm::dvec3& originWorld, const View& view)
{
    const Extent whole{0, 0, view.camera.width, view.camera.height};
    if (boxWorld.empty()) return {};
    double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        glm::dvec3 world;
        for (int c = 0; c < 3; ++c) world[c] = corner >> c & 1u ? boxWorld.hi[c] : boxWorld.lo[c];
        const glm::dvec3 fromEye = (world - originWorld) / view.unitWorld - glm::dvec3(view.eyeLocal);
        const double depth = glm::dot(fromEye, glm::dvec3(view.forward));
        if (!(depth > 0.5 * view.nearDepth)) return whole;
        const double x = view.centerX + view.focalPx * glm::dot(fromEye, glm::dvec3(view.right)) / depth;
        const double y = view.centerY - view.focalPx * glm::dot(fromEye, glm::dvec3(view.up)) / depth;
        x0 = std::min(x0, x), x1 = std::max(x1, x);
        y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
    const auto pixel = [](double v, int highest) { return int(std::clamp(v, 0.0, double(highest))); };
    const Extent seen{pixel(std::floor(x0 - kMarginPx), whole.x1), pixel(std::floor(y0 - kMarginPx), whole.y1),
                      pixel(std::ceil(x1 + kMarginPx), whole.x1), pixel(std::ceil(y1 + kMarginPx), whole.y1)};
    return seen.empty() ? Extent{} : seen;
}

Bounds brickBounds(const GridField& field, double marginCells)
{
    Bounds box;
    for (int c = 0; c < 3; ++c) {
        const auto a = std::size_t(c);
        const auto world = [&](double cell) { return field.originWorld[c] + cell * field.spacingWorld[c]; };
        box.lo[c] = world(double(field.brick->cellLo[a]) - marginCells);
        box.hi[c] = world(double(field.brick->cellHi[a]) + marginCells);
    }
    return box;
}

Extent imageOf(const GridField& field, const glm::dvec3& originWorld, const View& view)
{
    if (!field.brick) return {0, 0, view.camera.width, view.camera.height};
    if (field.brick->empty()) return {};
    return imageOf(brickBounds(field, kMarginCells), originWorld, view);
}

}  // namespace aeolic
