// Per-target include (Highway compiles it once per target): where corners of triangles are on the image.

#if defined(AEOLIC_RENDER_CPU_CORNERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_CORNERS_INL_H
#undef AEOLIC_RENDER_CPU_CORNERS_INL_H
#else
#define AEOLIC_RENDER_CPU_CORNERS_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "render/cpu/project/raster/transform.h"
#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Sub-pixels of a pixel's centre.
HWY_INLINE VI centreOf(VI pixel)
{
    return hn::Add(hn::ShiftLeft<kSubpixelBits>(pixel), hn::Set(DI(), kSubpixels / 2));
}

/// The first pixel whose centre lies at or after `v` sub-pixels.
HWY_INLINE VI firstPixel(VI v)
{
    return hn::ShiftRight<kSubpixelBits>(hn::Add(v, hn::Set(DI(), kSubpixels / 2 - 1)));
}

/// The pixel after the last whose centre lies at or before `v` sub-pixels.
HWY_INLINE VI pastLastPixel(VI v)
{
    return hn::Add(hn::ShiftRight<kSubpixelBits>(hn::Sub(v, hn::Set(DI(), kSubpixels / 2))), hn::Set(DI(), 1));
}

/// A corner of each triangle.
struct Corners {
    VI x, y;
    VF invDepth;
};

HWY_INLINE Corners cornersAt(const ScreenVertices& screen, VI point)
{
    static_assert(sizeof(ScreenVertex) == 4 * sizeof(std::int32_t));
    const auto blocks = loadBlocks<4>(DU(), reinterpret_cast<const std::uint32_t*>(screen.data()), point);
    return {hn::BitCast(DI(), blocks.a), hn::BitCast(DI(), blocks.b), hn::BitCast(DF(), blocks.c)};
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
