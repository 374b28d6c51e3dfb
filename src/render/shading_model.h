#pragma once

#include <array>
#include <cstdint>

/// The blending stage's formulas and constants, shared by every backend and the reference.
///
///   facing = normal . direction to the eye
///   light  = ambient + diffuse * |facing|                              two-sided headlight
///            + soft * (1 + clamp(8 facing, -1, 1) * normal . soft light) / 2
///                                                                      a soft light from the upper left, on the side
///                                                                      that is seen; where the side changes it is even
///   tone   = (1 + erf(contrast * z / sqrt 2)) / 2                      z: the LIC, unit variance; tone: even histogram
///                                                                      0 … 1
///   m      = 2 * tone - 1                                              mean 0, evenly spread over [-1, 1]
///   shown  = mix(base, bright, (m - knee) / (1 - knee)) for m >= knee, mix(base, dark, (knee - m) / (knee + 1) below
///   colour = light * shown
///
/// Where the vector is shorter than the user wants to see streaks, m is the knee: the base alone shows. The LIC stage
/// knows nothing of that, so streaks beside such places stay as they are. The projection, which has the vector, tells
/// it by the light's sign: that costs no memory, and ranks that exchange light exchange it, too.
///
/// On a colour-mapped surface dark and bright differ from the base in Oklab's lightness (palette.h), and the knee makes
/// the mean of all tones the base: from a small area one reads the colour of the value there. The plain surface's three
/// grays are plainSurface(), its knee 0. It is white without LIC and looks like a drawing in ink with the default
/// blend. With blend 1 and no lighting the pixel is the tone itself.
namespace aeolic::shading {

inline constexpr float kAmbient = 0.5f, kDiffuse = 0.32f, kSoft = 0.18f;
/// Where the soft light comes from: parts to the right, upwards, and forwards from the eye; unit length.
inline constexpr float kSoftRight = -0.45f, kSoftUp = 0.65f, kSoftForward = -0.6124f;
/// How fast the soft light goes over to the other side's.
inline constexpr float kSoftTurn = 8;

/// The plain surface's grays, 0 to 1: without a streak, the darkest streak, the brightest.
struct PlainSurface {
    float base, dark, bright;
};
inline constexpr PlainSurface plainSurface(float blend)
{
    return {1 - 0.5f * blend * blend * blend, 1 - blend * blend, 1 - 0.25f * blend * (1 - blend)};
}

/// A plain surface without streaks, for orientation, beside others that have them.
inline constexpr float kContext = 0.87f;

/// With blend 1 streaks are so much lighter and darker than a colour-mapped surface, in Oklab's lightness. There
/// chroma has faded by this share at most.
inline constexpr double kStreakLightness = 0.38, kStreakFade = 0.5;
/// Some tones are left on either side of the knee: bright streaks on black, dark ones on white.
inline constexpr double kMostKnee = 0.5;
/// A knee is kept as a byte: 0 to 254 are -1 to 1.
inline constexpr std::uint32_t kKneeZero = 127;

/// Gray where the scalar is masked.
inline constexpr std::array<std::uint8_t, 3> kMaskedColor{153, 153, 153};

/// erf by Abramowitz & Stegun 7.1.27 for x >= 0: 1 - 1 / (1 + a1 x + a2 x^2 + a3 x^3 + a4 x^4)^4, error below 5e-4:
/// only multiplications and one division, hence the same bits everywhere.
inline constexpr float kErf[4] = {0.278393f, 0.230389f, 0.000972f, 0.078108f};

}  // namespace aeolic::shading
