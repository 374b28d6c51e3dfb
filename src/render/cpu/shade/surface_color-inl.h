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
#include "render/surface_mark.h"

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

/// The last entry whose edge is not above the scalar.
HWY_INLINE VI searchedEntry(const ScalarColors& table, VF scalar)
{
    const DF d;
    const DI di;
    VI entry = hn::Zero(di);
    for (int step = int(ScalarColors::kEntries) / 2; step > 0; step /= 2) {
        const VI next = hn::Add(entry, hn::Set(di, step));
        const auto reached = hn::Ge(scalar, hn::GatherIndex(d, table.edges.data(), next));
        entry = hn::IfThenElse(hn::RebindMask(di, reached), next, entry);
    }
    return entry;
}

/// The table's entry per lane.
HWY_INLINE VI tableEntry(const ScalarColors& table, VF scalar)
{
    const DF d;
    const DI di;
    const VF lo = hn::Set(d, table.scalarLo);
    const auto masked = hn::IsNaN(scalar);
    VI entry;
    if (table.searched) {
        entry = searchedEntry(table, scalar);
    } else {
        const VF place = hn::Mul(hn::Sub(scalar, lo), hn::Set(d, table.entriesPerScalar));
        const VF safe =
            hn::Min(hn::Max(hn::IfThenElse(masked, hn::Zero(d), place), hn::Zero(d)), hn::Set(d, table.lastEntry));
        entry = hn::ConvertTo(di, safe);
    }
    const auto take = [&](hn::Mask<DF> where, std::size_t other) {
        entry = hn::IfThenElse(hn::RebindMask(di, where), hn::Set(di, int(other)), entry);
    };
    take(hn::Lt(scalar, hn::Set(d, table.lowest)), ScalarColors::kBelow);
    take(hn::Gt(scalar, hn::Set(d, table.highest)), ScalarColors::kAbove);
    take(masked, ScalarColors::kMasked);
    return entry;
}

/// Byte `k` of words, 0 to 255.
HWY_INLINE VF byteOf(hn::Vec<DU> word, int k)
{
    return hn::ConvertTo(DF(), hn::BitCast(DI(), hn::And(hn::ShiftRightSame(word, 8 * k), hn::Set(DU(), 0xFFu))));
}

/// What a pixel's streaks give one colour table's or the plain surface's colour. RGB; the highest byte is zero.
struct Tone {
    VF m, light;  ///< -1 to 1; the share of the light.
    MF masked;    ///< No streaks show.

    Tone(const Palette& palette, VF lic, VF signedLight)
    {
        const DF d;
        masked = hn::Lt(signedLight, hn::Zero(d));
        light = palette.lighting ? hn::Abs(signedLight) : hn::Set(d, 1.0f);
        m = tone(hn::Mul(lic, hn::Set(d, palette.contrast * 0.70710678f)));
    }

    /// `end`: the colour of the brightest or the darkest streak; `part`: of the way there.
    HWY_INLINE VU channel(VF base, VF end, VF part) const
    {
        const DF d;
        const VF shown = hn::MulAdd(hn::Sub(end, base), part, base);
        const VF value = hn::Min(hn::Max(hn::MulAdd(shown, light, hn::Set(d, 0.5f)), hn::Zero(d)), hn::Set(d, 255.0f));
        return hn::BitCast(DU(), hn::ConvertTo(DI(), value));
    }

    HWY_INLINE VU colorOf(const ScalarColors& table, VF scalar) const
    {
        const DF d;
        const DU du;
        const VF one = hn::Set(d, 1.0f);
        const VI entry = tableEntry(table, scalar);
        const auto look = [&](const auto& words) { return hn::GatherIndex(du, words.data(), entry); };
        const auto base = look(table.base), dark = look(table.dark), bright = look(table.bright);
        const VF knee = hn::MulAdd(byteOf(base, 3), hn::Set(d, 1.0f / float(shading::kKneeZero)), hn::Set(d, -1.0f));
        const auto brightens = hn::Ge(m, knee);
        const VF way = hn::IfThenZeroElse(masked, hn::Abs(hn::Sub(m, knee)));
        const VF part = hn::Div(way, hn::IfThenElse(brightens, hn::Sub(one, knee), hn::Add(one, knee)));
        const auto end = hn::IfThenElse(hn::RebindMask(du, brightens), bright, dark);
        const auto byte = [&](int k) AEOLIC_INLINE { return channel(byteOf(base, k), byteOf(end, k), part); };
        return hn::Or(byte(0), hn::Or(hn::ShiftLeft<8>(byte(1)), hn::ShiftLeft<16>(byte(2))));
    }

    HWY_INLINE VU grayOf(float blend) const
    {
        const DF d;
        const shading::PlainSurface plain = shading::plainSurface(blend);
        const VF end =
            hn::IfThenElse(hn::Ge(m, hn::Zero(d)), hn::Set(d, 255 * plain.bright), hn::Set(d, 255 * plain.dark));
        const auto gray = channel(hn::Set(d, 255 * plain.base), end, hn::IfThenZeroElse(masked, hn::Abs(m)));
        return hn::Or(gray, hn::Or(hn::ShiftLeft<8>(gray), hn::ShiftLeft<16>(gray)));
    }
};

/// RGBA, opaque. `lic`: unit variance. `signedLight`: the G-buffer's, negative where no streaks show. `scalar`: read
/// where the palette goes by it. `kinds`: the G-buffer's colours, read where the palette has several tables.
HWY_INLINE VU surfaceColor(const Palette& palette, VF lic, VF signedLight, VF scalar, VI kinds)
{
    const DU du;
    const DI di;
    const Tone tone(palette, lic, signedLight);
    VU color = hn::Zero(du);
    if (palette.tables.empty()) {
        color = palette.useScalar ? tone.colorOf(palette, scalar) : tone.grayOf(palette.blend);
    } else {
        for (std::size_t k = 0; k < palette.tables.size(); ++k) {
            const auto some = hn::Eq(kinds, hn::Set(di, int(k)));
            if (hn::AllFalse(di, some)) continue;
            const VU own =
                k == surface_mark::kPlain ? tone.grayOf(palette.blend) : tone.colorOf(palette.tables[k], scalar);
            color = hn::IfThenElse(hn::RebindMask(du, some), own, color);
        }
    }
    return hn::Or(color, hn::Set(du, 0xFF000000u));
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
