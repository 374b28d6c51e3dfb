#pragma once

#include <algorithm>
#include <cstdint>

/// Ambient occlusion: where the surface rises around a place, less of the light from all around gets there. It is found
/// from the depths in the picture. Each pixel looks at a few places around it, its fifteen neighbours at others, and
/// what they find is averaged over 4 x 4 pixels of one sheet. So there is no noise, and nothing swims.
///
///   offset  = the tap's place, in pixels from the pixel's
///   toEye   = (invDepth there - invDepth) focal length / invDepth     how much nearer it is, in pixels of that depth
///   above   = (invDepth there - what the pixel's facet predicts there) focal length / invDepth
///             / length of (1, the facet's slope)                      its height over the facet
///   far     = offset^2 + toEye^2
///   hides   = above^2 / far * max(0, 1 - far / (2 radius)^2) where above > 0, else 0
///   hidden  = mean of hides over the pixel's taps
///   open    = 1 / (1 + strength * mean of hidden)                     the share of the light that gets there
///
/// The last mean goes over those of the 4 x 4 pixels from two to the left and above to one to the right and below whose
/// depth the pixel's facet predicts to within kSlackPx pixels of that depth. above^2 / far is the squared sine of the
/// angle at which the tap stands above the facet. What is much nearer than the radius hides nothing: a body far in
/// front of a wall has no halo. The light of shading_model.h is multiplied by `open`. Sources: Miller, Efficient
/// Algorithms for Local and Global Accessibility Shading (1994); Mittring, Finding Next Gen: CryEngine 2 (2007), for
/// depths in the picture; Segovia et al., Non-interleaved Deferred Shading of Interleaved Sample Patterns (2006).
namespace aeolic::occlusion {

/// Pixels look at one of 4 x 4 patterns, by their place in the picture.
inline constexpr int kTile = 4, kPatterns = kTile * kTile, kTaps = 16;
inline int patternOf(int x, int y)
{
    return (y & (kTile - 1)) * kTile + (x & (kTile - 1));
}
/// The mean goes over so many pixels to the left and above, and one less to the right and below.
inline constexpr int kBefore = kTile / 2;
inline constexpr float kSlackPx = 2;

/// Where taps lie, to the right and downwards, in 1024ths of the radius, [patterns][taps]. All patterns together are a
/// spiral by the golden angle, denser towards the pixel. Whole numbers, so that all machines look at the same pixels.
inline constexpr int kUnit = 1024;
inline constexpr std::int32_t kRight[kPatterns * kTaps] = {
    53,   87,   30,   -119, -279, -334, -204,  90,   419,  600,  497,  108,  -409, -800, -840, -455, 78,   72,   -37,
    -205, -327, -294, -72,  262,  539,  588,   332,  -149, -637, -874, -697, -140, 5,    86,   182,  198,  76,   -158,
    -388, -468, -306, 65,   483,  728,  635,   197,  -411, -895, 39,   138,  205,  155,  -32,  -283, -455, -418, -139,
    282,  640,  729,  452,  -103, -687, -1002, -85,  -54,  77,   245,  336,  255,  -7,   -344, -578, -552, -226, 281,
    729,  871,  587,  -35,  -67,  -83,  1,     162,  307,  320,  143,  -176, -485, -604, -423, 18,   529,  850,  782,
    305,  -61,  -162, -206, -120, 94,   339,   469,  370,  40,   -386, -694, -694, -332, 258,  802,  1011, -20,  -112,
    -197, -181, -25,  222,  427,  451,  228,   -173, -569, -740, -554, -50,  555,  962,  39,   -6,   -126, -245, -258,
    -107, 170,  438,  536,  363,  -44,  -508,  -790, -708, -248, 403,  28,   -60,  -193, -270, -203, 22,   315,  517,
    484,  180,  -284, -686, -800, -518, 71,    705,  -42,  -118, -141, -50,  141,  335,  400,  253,  -80,  -453, -665,
    -565, -150, 412,  849,  914,  -81,  -141,  -111, 37,   246,  391,  355,  103,  -274, -591, -658, -390, 129,  664,
    938,  772,  -14,  92,   221,  269,  160,   -95,  -381, -535, -432, -72,  400,  749,  766,  391,  -238, -832, -37,
    31,   160,  262,  236,  46,   -244, -484,  -519, -278, 164,  605,  807,  624,  93,   -561, 100,  145,  84,   -88,
    -293, -402, -311, -14,  367,  637,  622,   277,  -272, -767, -941, -659, 61,   132,  130,  9,    -194, -368, -385,
    -183, 178,  529,  672,  487,  14,   -545,  -907, -857};
inline constexpr std::int32_t kDown[kPatterns * kTaps] = {
    0,    73,   172,  203,  99,   -126, -365, -470, -340, 12,   436,  714,  667,  266,  -335, -851, 29,   125,  202,
    169,  -3,   -253, -443, -437, -185, 228,  607,  737,  506,  -26,  -623, -986, -60,  -86,  -15,  141,  294,  329,
    175,  -133, -454, -604, -462, -46,  470,  828,  814,  382,  -83,  -64,  56,   225,  333,  276,  33,   -303, -561,
    -573, -281, 215,  685,  875,  645,  54,   -49,  -150, -207, -139, 63,   312,  463,  396,  91,   -335, -670, -714,
    -394, 180,  747,  1010, -12,  -99,  -190, -191, -51,  190,  409,  461,  269,  -119, -528, -737, -597, -125, 484,
    932,  87,   43,   -98,  -263, -337, -231, 48,   382,  591,  527,  169,  -346, -767, -859, -524, 124,  73,   78,
    -18,  -184, -318, -309, -108, 219,  514,  598,  380,  -83,  -585, -865, -742, -224, 51,   125,  137,  31,   -168,
    -353, -394, -220, 129,  493,  671,  528,  83,   -480, -881, -889, 91,   144,  99,   -62,  -270, -398, -334, -59,
    322,  616,  643,  335,  -201, -718, -943, -719, 38,   5,    -109, -234, -265, -134, 132,  411,  537,  399,  15,
    -455, -772, -740, -322, 321,  33,   -45,  -177, -267, -221, -12,  280,  502,  504,  231,  -224, -648, -807, -574,
    -11,  635,  -109, -144, -68,  114,  315,  403,  283,  -33,  -411, -653, -596, -215, 343,  811,  931,  594,  -71,
    -137, -122, 13,   220,  381,  372,  144,  -226, -562, -668, -441, 57,   606,  926,  818,  -22,  76,   208,  271,
    183,  -58,  -349, -528, -460, -127, 343,  720,  786,  457,  -155, -771, -39,  18,   143,  254,  248,  77,   -207,
    -463, -530, -322, 104,  558,  802,  669,  172,  -483};

inline constexpr float kStrength = 6;

/// A larger radius would bring more rows from other ranks, and its places would be too few for it.
inline constexpr int kMostRadiusPx = 96;

/// How far from a pixel it looks, in pixels: a sixteenth of the picture's height.
inline int radiusPx(int height)
{
    return std::clamp(height / 16, 4, kMostRadiusPx);
}

/// A tap's place in pixels, along either axis: `part` is kRight or kDown of it.
inline int tapPx(std::int32_t part, int radius)
{
    return (part * radius + kUnit / 2) >> 10;
}

}  // namespace aeolic::occlusion
