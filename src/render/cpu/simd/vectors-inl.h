// Per-target include (Highway compiles it once per target): passes over the vectors of pixels of a tile.

#if defined(AEOLIC_RENDER_CPU_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_VECTORS_INL_H
#undef AEOLIC_RENDER_CPU_VECTORS_INL_H
#else
#define AEOLIC_RENDER_CPU_VECTORS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "render/cpu/simd/simd-inl.h"
#include "render/gbuffer.h"
#include "render/lic/near_flow.h"
#include "render/limits.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE std::ptrdiff_t indexOf(const GBuffer& buffer, int x, int y)
{
    return (y - buffer.valid().y0) * buffer.flow.stride() + (x - buffer.valid().x0);
}

HWY_INLINE bool anyFlow(const GBuffer& buffer, std::ptrdiff_t at)
{
    return !hn::AllTrue(DU(), hn::Eq(hn::LoadU(DU(), buffer.flow.origin() + at), hn::Zero(DU())));
}

/// Where the pixels of `links` and those around, from limits::kOpenRings before to `last` after it, are linked to all
/// their neighbours.
HWY_INLINE MU openTo(const std::uint8_t* links, std::ptrdiff_t stride, int last)
{
    const hn::Rebind<std::uint8_t, DU> d8;
    auto all = hn::Set(d8, std::uint8_t{0xFF});
    for (int row = -limits::kOpenRings; row <= last; ++row)
        for (int column = -limits::kOpenRings; column <= last; ++column)
            all = hn::And(all, hn::LoadU(d8, links + row * stride + column));
    return hn::Eq(hn::PromoteTo(DU(), all), hn::Set(DU(), 0xFFu));
}

/// Where the pixel and limits::kOpenRings rings around it are linked to all their neighbours.
HWY_INLINE MU openAt(const GBuffer& buffer, std::ptrdiff_t at)
{
    return openTo(buffer.links.origin() + at, buffer.links.stride(), limits::kOpenRings);
}

/// What may have flow in a row of a tile; whole vectors but for the tile's end.
HWY_INLINE Extent surfaceOf(const GBuffer& buffer, const Extent& tile, int y)
{
    const ColumnSpan surface = buffer.surfaceColumns(y);
    return {std::max(tile.x0, surface.x0), y, std::min(tile.x1, surface.x1), y + 1};
}

/// Calls body(index, x, y) for the vectors of pixels of a tile that have any flow, empty(index, x, y) for the others.
template <class Body, class Empty>
HWY_INLINE void forEachVector(const GBuffer& buffer, const Extent& tile, const Body& body, const Empty& empty)
{
    for (int y = tile.y0; y < tile.y1; ++y) {
        const ColumnSpan surface = buffer.surfaceColumns(y);
        for (int x = tile.x0; x < tile.x1; x += int(hn::Lanes(DF()))) {
            const std::ptrdiff_t at = indexOf(buffer, x, y);
            x >= surface.x0&& x < surface.x1&& anyFlow(buffer, at) ? body(at, x, y) : empty(at, x, y);
        }
    }
}

/// Calls body and empty, as forEachVector() does, for the vectors near flow alone.
template <class Body, class Empty>
HWY_INLINE void forEachVectorNear(const GBuffer& buffer, const NearFlow& near, const Extent& tile, const Body& body,
                                  const Empty& empty)
{
    for (int y = tile.y0; y < tile.y1; ++y) {
        const ColumnSpan columns = near.at(y);
        const int x0 = std::max(tile.x0, columns.x0), x1 = std::min(tile.x1, columns.x1);
        forEachVector(buffer, {x0, y, x1, y + 1}, body, empty);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
