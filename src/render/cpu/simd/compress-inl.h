// Per-target include (Highway compiles it once per target): chosen lanes, stored side by side.

#if defined(AEOLIC_RENDER_CPU_COMPRESS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_COMPRESS_INL_H
#undef AEOLIC_RENDER_CPU_COMPRESS_INL_H
#else
#define AEOLIC_RENDER_CPU_COMPRESS_INL_H
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Which lanes are in a set, for every set of eight lanes, a bit each; the rest is 0.
struct LanesOfSets {
    std::uint8_t lane[256][8] = {};

    constexpr LanesOfSets()
    {
        for (int set = 0; set < 256; ++set)
            for (int k = 0, count = 0; k < 8; ++k)
                if (set >> k & 1) lane[set][count++] = std::uint8_t(k);
    }
};
inline constexpr LanesOfSets kLanesOfSets;

/// hn::CompressStore() of 32-bit lanes: stores the chosen ones first, and anything in the rest of a whole vector.
/// Returns how many they are. Processors up to AVX2 look up which these are; Highway's own table GCC 12 copies to the
/// stack, a kilobyte for every vector.
template <class D, class V = hn::Vec<D>>
HWY_INLINE std::size_t compressStore(V v, hn::Mask<D> chosen, D d, hn::TFromD<D>* to)
{
    static_assert(sizeof(hn::TFromD<D>) == 4);
    if constexpr (hn::MaxLanes(d) <= 8) {
        const hn::RebindToUnsigned<D> du;
        const hn::Rebind<std::uint8_t, D> d8;
        std::uint8_t set[8] = {};  // Written as a whole.
        hn::StoreMaskBits(d, chosen, set);
        const auto lanes = hn::PromoteTo(du, hn::LoadU(d8, kLanesOfSets.lane[set[0]]));
        hn::StoreU(hn::TableLookupLanes(v, hn::IndicesFromVec(d, lanes)), d, to);
        return std::size_t(std::popcount(set[0]));
    } else {
        return hn::CompressStore(v, chosen, d, to);
    }
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
