#pragma once

/// The blending stage's formulas and constants, shared by every backend and the reference.
///
///   light  = ambient + diffuse * |normal . direction to the eye|       two-sided headlight
///   tone   = (1 + erf(contrast * z / sqrt 2)) / 2                      z: the LIC, unit variance; tone: even histogram
///   0 to 1 m      = blend * (2 * tone - 1)                                    mean 0: the LIC neither darkens nor
///   brightens shown  = base * (1 + shadow * m) for m < 0, base + (1 - base) * highlight * m otherwise colour = light *
///   shown
///
/// The plain surface's base is 1 - blend / 2, its shadow and highlight 1: white without LIC; with blend 1 and no
/// lighting the pixel is the tone itself.
namespace aeolic::shading {

inline constexpr float kAmbient = 0.45f;
inline constexpr float kDiffuse = 0.55f;

/// Streaks darken and brighten a colour-mapped surface this much less, so that the colour can still be read.
inline constexpr float kColorShadow = 0.75f;
inline constexpr float kColorHighlight = 0.45f;

/// Gray where the scalar is masked.
inline constexpr float kMaskedBase = 0.6f;

/// erf by Abramowitz & Stegun 7.1.27 for x >= 0: 1 - 1 / (1 + a1 x + a2 x^2 + a3 x^3 + a4 x^4)^4, error below 5e-4:
/// only multiplications and one division, hence the same bits everywhere.
inline constexpr float kErf[4] = {0.278393f, 0.230389f, 0.000972f, 0.078108f};

}  // namespace aeolic::shading
