#include "data/cells/coarse_boxes.h"

#include <cmath>

namespace aeolic {

CoarseBoxes::CoarseBoxes(const Bounds& bounds, std::size_t places)
{
    constexpr std::size_t placesOfBox = 64;
    const double side = std::cbrt(double(places / placesOfBox));
    if (!(side > 1) || !std::isfinite(bounds.diagonal())) return;
    const glm::dvec3 size = glm::max(bounds.hi - bounds.lo, glm::dvec3(1e-6 * bounds.diagonal()));
    const double middling = std::cbrt(size.x * size.y * size.z);
    if (!(middling > 0)) return;
    lo = bounds.lo;
    count = glm::ivec3(glm::clamp(glm::ceil(side * size / middling), glm::dvec3(1), glm::dvec3(256)));
    boxesPerWorld = glm::dvec3(count) / size;
}

glm::dvec3 CoarseBoxes::middleOf(std::size_t index) const
{
    const auto across = std::size_t(count.x), layer = across * std::size_t(count.y);
    const glm::dvec3 place(double(index % across), double(index % layer / across), double(index / layer));
    return lo + (place + 0.5) / boxesPerWorld;
}

double CoarseBoxes::countIn(const Bounds& bounds) const
{
    const glm::dvec3 across(boxOf(bounds.hi) - boxOf(bounds.lo) + 1);
    return across.x * across.y * across.z;
}

}  // namespace aeolic
