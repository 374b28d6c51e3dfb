#include "render/units.h"

#include <algorithm>
#include <cmath>

namespace aeolic {
namespace {

// Powers of two. Four lengths of kLongest, or of a millionth of kShortest, multiply to floats.
constexpr int kShortest = -10, kLongest = 20;
// The squares of vectors so long, and of a millionth of them, are floats.
constexpr int kMostVector = 30;
constexpr int kFloat = 126;  // A unit and what it is one of are floats, neither of them subnormal.

}  // namespace

double lengthUnit(const Scene& scene)
{
    const double size = scene.boundsWorld.empty() ? 0 : scene.boundsWorld.diagonal();
    if (!(size > 0) || !std::isfinite(size)) return 1;
    const int exponent = std::ilogb(size);
    const bool ordinary = exponent >= kShortest && exponent < kLongest;
    return ordinary ? 1 : std::ldexp(1.0, std::clamp(exponent, -kFloat, kFloat));
}

double vectorUnit(const Scene& scene)
{
    if (!(scene.maxVector > 0) || !std::isfinite(scene.maxVector)) return 1;
    const int exponent = std::ilogb(scene.maxVector), beyond = std::clamp(exponent, -kMostVector, kMostVector);
    return std::ldexp(1.0, std::clamp(exponent - beyond, -kFloat, kFloat));
}

}  // namespace aeolic
