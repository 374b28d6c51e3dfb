#include "data/color_map/color_spaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aeolic {
namespace {

using Triple = ColorTriple;

constexpr double kWhite[3] = {0.9505, 1, 1.089};  // D65, Y = 1.

Triple labOf(const Triple& rgb)
{
    constexpr double xyzFromRgb[3][3] = {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    const Triple xyz = times(xyzFromRgb, {linearOfSrgb(rgb[0]), linearOfSrgb(rgb[1]), linearOfSrgb(rgb[2])});
    const double x = f(xyz[0] / kWhite[0]), y = f(xyz[1] / kWhite[1]), z = f(xyz[2] / kWhite[2]);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Triple rgbOfLab(const Triple& lab)
{
    constexpr double rgbFromXyz[3][3] = {
        {3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
    const auto inverse = [](double t) {
        return t * t * t > 216.0 / 24389 ? t * t * t : (116 * t - 16) / (24389.0 / 27);
    };
    const double y = (lab[0] + 16) / 116;
    Triple rgb = times(rgbFromXyz, {kWhite[0] * inverse(y + lab[1] / 500), kWhite[1] * inverse(y),
                                    kWhite[2] * inverse(y - lab[2] / 200)});
    for (double& v : rgb) v = srgbOfLinear(v);
    return rgb;
}

/// Lab in polar coordinates: magnitude, saturation, hue.
Triple mshOf(const Triple& lab)
{
    const double m = std::hypot(lab[0], lab[1], lab[2]);
    return {m, m > 0.001 ? std::acos(std::clamp(lab[0] / m, -1.0, 1.0)) : 0, std::atan2(lab[2], lab[1])};
}
Triple labOfMsh(const Triple& msh)
{
    return {msh[0] * std::cos(msh[1]), msh[0] * std::sin(msh[1]) * std::cos(msh[2]),
            msh[0] * std::sin(msh[1]) * std::sin(msh[2])};
}

/// The hue by which a saturated colour and one without a hue of its own are interpolated.
double adjustedHue(const Triple& saturated, double otherMagnitude)
{
    if (saturated[0] >= otherMagnitude - 0.1) return saturated[2];
    const double spin = saturated[1] * std::sqrt(otherMagnitude * otherMagnitude - saturated[0] * saturated[0]) /
                        (saturated[0] * std::sin(saturated[1]));
    return saturated[2] > -std::numbers::pi / 3 ? saturated[2] + spin : saturated[2] - spin;
}

Triple mix(const Triple& a, const Triple& b, double t)
{
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

Triple divergingBetween(const Triple& from, const Triple& to, double t)
{
    constexpr double grayish = 0.05;  // Saturation below which a colour has no hue.
    constexpr double whiteMagnitude = 88;
    Triple a = mshOf(labOf(from)), b = mshOf(labOf(to));
    double apart = std::abs(a[2] - b[2]);
    if (apart > std::numbers::pi) apart = 2 * std::numbers::pi - apart;
    if (a[1] > grayish && b[1] > grayish && apart > std::numbers::pi / 3) {  // White between unlike colours.
        const double middle = std::max({a[0], b[0], whiteMagnitude});
        if (t < 0.5) {
            b = {middle, 0, 0};
            t *= 2;
        } else {
            a = {middle, 0, 0};
            t = 2 * t - 1;
        }
    }
    if (a[1] < grayish && b[1] > grayish)
        a[2] = adjustedHue(b, a[0]);
    else if (b[1] < grayish && a[1] > grayish)
        b[2] = adjustedHue(a, b[0]);
    return rgbOfLab(labOfMsh(mix(a, b, t)));
}

Triple hsvOf(const Triple& rgb)
{
    const double most = std::max({rgb[0], rgb[1], rgb[2]}), spread = most - std::min({rgb[0], rgb[1], rgb[2]});
    if (spread == 0) return {0, 0, most};
    const double turn = most == rgb[0]   ? (rgb[1] - rgb[2]) / spread
                        : most == rgb[1] ? 2 + (rgb[2] - rgb[0]) / spread
                                         : 4 + (rgb[0] - rgb[1]) / spread;
    return {(turn < 0 ? turn + 6 : turn) / 6, spread / most, most};
}
Triple rgbOfHsv(const Triple& hsv)
{
    const auto part = [&](double shift) {
        const double k = std::fmod(shift + 6 * (hsv[0] - std::floor(hsv[0])), 6);
        return hsv[2] * (1 - hsv[1] * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
    };
    return {part(5), part(3), part(1)};
}

Triple hsvBetween(const Triple& from, const Triple& to, double t, bool wrapped)
{
    Triple a = hsvOf(from), b = hsvOf(to);
    if (wrapped && std::abs(a[0] - b[0]) > 0.5) (a[0] > b[0] ? a : b)[0] -= 1;
    return rgbOfHsv(mix(a, b, t));
}

}  // namespace

double linearOfSrgb(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
double srgbOfLinear(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

ColorTriple times(const double (&m)[3][3], const ColorTriple& v)
{
    ColorTriple out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return out;
}

Color between(const Triple& from, const Triple& to, double t, ColorSpace space)
{
    Triple rgb = from;
    if (t >= 1)
        rgb = to;
    else if (t > 0 && space == ColorSpace::rgb)
        rgb = mix(from, to, t);
    else if (t > 0 && space == ColorSpace::lab)
        rgb = rgbOfLab(mix(labOf(from), labOf(to), t));
    else if (t > 0 && space == ColorSpace::diverging)
        rgb = divergingBetween(from, to, t);
    else if (t > 0)
        rgb = hsvBetween(from, to, t, space == ColorSpace::hsvWrapped);
    Color color{};
    for (std::size_t c = 0; c < 3; ++c) color[c] = std::uint8_t(std::lround(255 * std::clamp(rgb[c], 0.0, 1.0)));
    return color;
}

}  // namespace aeolic
