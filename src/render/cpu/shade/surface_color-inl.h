// Per-target include (Highway compiles it once per target): the colour of a surface (shading_model.h), a pixel a lane.

#if defined(AEOLIC_RENDER_CPU_SURFACE_COLOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_SURFACE_COLOR_INL_H
#undef AEOLIC_RENDER_CPU_SURFACE_COLOR_INL_H
#else
#define AEOLIC_RENDER_CPU_SURFACE_COLOR_INL_H
#endif

#include <hwy/highway.h>

#include "render/cpu/simd/simd-inl.h"
#include "render/palette.h"
#include "render/shading_model.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Turns LIC of unit variance into -1 to 1 with an even histogram: erf.
HWY_INLINE VF tone(VF z)
{
    const DF d;
    const VF one = hn::Set(d, 1.0f), x = hn::Abs(z);
    const VF poly =
        hn::MulAdd(x,
                   hn::MulAdd(x,
                              hn::MulAdd(x, hn::MulAdd(x, hn::Set(d, shading::kErf[3]), hn::Set(d, shading::kErf[2])),
                                         hn::Set(d, shading::kErf[1])),
                              hn::Set(d, shading::kErf[0])),
                   one);
    const VF squared = hn::Mul(poly, poly);
    return hn::CopySign(hn::Sub(one, hn::Div(one, hn::Mul(squared, squared))), z);
}

/// The palette's entry per lane.
HWY_INLINE VI paletteEntry(const Palette& palette, VF scalar)
{
    const DF d;
    const DI di;
    const VF entry = hn::Mul(hn::Sub(scalar, hn::Set(d, palette.scalarLo)), hn::Set(d, palette.entriesPerScalar));
    const auto masked = hn::IsNaN(scalar);
    const VF safe = hn::Min(hn::Max(hn::IfThenElse(masked, hn::Zero(d), entry), hn::Zero(d)), hn::Set(d, 255.0f));
    return hn::IfThenElse(hn::RebindMask(di, masked), hn::Set(di, int(Palette::kMasked)), hn::ConvertTo(di, safe));
}

/// Byte `k` of words, 0 to 255.
HWY_INLINE VF byteOf(hn::Vec<DU> word, int k)
{
    return hn::ConvertTo(DF(), hn::BitCast(DI(), hn::And(hn::ShiftRightSame(word, 8 * k), hn::Set(DU(), 0xFFu))));
}

/// RGBA, opaque. `lic`: unit variance. `light`: 1 where the palette has no lighting. `scalar`: read where the palette
/// goes by it.
HWY_INLINE VU surfaceColor(const Palette& palette, VF lic, VF light, VF scalar)
{
    const DF d;
    const DI di;
    const DU du;
    const VF one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    const VF m = tone(hn::Mul(lic, hn::Set(d, palette.contrast * 0.70710678f)));
    // `end`: the colour of the brightest or the darkest streak; `part`: of the way there.
    const auto channel = [&](VF base, VF end, VF part) {
        const VF shown = hn::MulAdd(hn::Sub(end, base), part, base);
        const VF value = hn::Min(hn::Max(hn::MulAdd(shown, light, hn::Set(d, 0.5f)), zero), hn::Set(d, 255.0f));
        return hn::BitCast(du, hn::ConvertTo(di, value));
    };
    VU surface;
    if (palette.useScalar) {
        const VI entry = paletteEntry(palette, scalar);
        const auto look = [&](const auto& table) { return hn::GatherIndex(du, table.data(), entry); };
        const auto base = look(palette.base), dark = look(palette.dark), bright = look(palette.bright);
        const VF knee = hn::MulAdd(byteOf(base, 3), hn::Set(d, 1.0f / float(shading::kKneeZero)), hn::Set(d, -1.0f));
        const auto brightens = hn::Ge(m, knee);
        const VF way = hn::Abs(hn::Sub(m, knee));
        const VF part = hn::Div(way, hn::IfThenElse(brightens, hn::Sub(one, knee), hn::Add(one, knee)));
        const auto end = hn::IfThenElse(hn::RebindMask(du, brightens), bright, dark);
        surface = channel(byteOf(base, 0), byteOf(end, 0), part);
        surface = hn::Or(surface, hn::ShiftLeft<8>(channel(byteOf(base, 1), byteOf(end, 1), part)));
        surface = hn::Or(surface, hn::ShiftLeft<16>(channel(byteOf(base, 2), byteOf(end, 2), part)));
    } else {
        const shading::PlainSurface plain = shading::plainSurface(palette.blend);
        const VF end = hn::IfThenElse(hn::Ge(m, zero), hn::Set(d, 255 * plain.bright), hn::Set(d, 255 * plain.dark));
        const auto gray = channel(hn::Set(d, 255 * plain.base), end, hn::Abs(m));
        surface = hn::Or(gray, hn::Or(hn::ShiftLeft<8>(gray), hn::ShiftLeft<16>(gray)));
    }
    return hn::Or(surface, hn::Set(du, 0xFF000000u));
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
