// Per-target include (Highway compiles it once per target): small vectors of vectors, loads and stores.

#if defined(AEOLIC_RENDER_CPU_SIMD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_SIMD_INL_H
#undef AEOLIC_RENDER_CPU_SIMD_INL_H
#else
#define AEOLIC_RENDER_CPU_SIMD_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A pixel a lane: the widest vectors of the target, of floats, signed and unsigned words.
using DF = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<DF>;
using DU = hn::RebindToUnsigned<DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;
using MF = hn::Mask<DF>;
using MU = hn::Mask<DU>;

/// On a lambda: compile it into its caller. GCC otherwise calls large ones, with every vector through memory.
#ifndef AEOLIC_INLINE
#define AEOLIC_INLINE HWY_ATTR __attribute__((always_inline))
#endif

/// Three coordinates of as many points as there are lanes.
template <class V>
struct Vec3v {
    V x, y, z;
};

template <class D>
HWY_INLINE Vec3v<hn::Vec<D>> broadcast(D d, const glm::vec3& v)
{
    return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

template <class V>
HWY_INLINE Vec3v<V> sub(const Vec3v<V>& a, const Vec3v<V>& b)
{
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

template <class V>
HWY_INLINE V dot(const Vec3v<V>& a, const Vec3v<V>& b)
{
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

template <class V>
HWY_INLINE Vec3v<V> cross(const Vec3v<V>& a, const Vec3v<V>& b)
{
    return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
            hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}

/// base + t * step
template <class V>
HWY_INLINE Vec3v<V> mulAdd(const Vec3v<V>& step, V t, const Vec3v<V>& base)
{
    return {hn::MulAdd(step.x, t, base.x), hn::MulAdd(step.y, t, base.y), hn::MulAdd(step.z, t, base.z)};
}

template <class V>
HWY_INLINE Vec3v<V> scale(const Vec3v<V>& a, V t)
{
    return {hn::Mul(a.x, t), hn::Mul(a.y, t), hn::Mul(a.z, t)};
}

template <class V>
HWY_INLINE V lerp(V a, V b, V t)
{
    return hn::MulAdd(t, hn::Sub(b, a), a);
}

/// 1 / sqrt(x) and 1 / x in full precision: the same bits on every machine, unlike the approximations.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V inverseLength(D d, V squared)
{
    return hn::Div(hn::Set(d, 1.0f), hn::Sqrt(squared));
}

/// Stores a row's pixels from column x on, but none from column `end` on.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void storeUpTo(int end, V values, int x, D d, hn::TFromD<D>* row)
{
    if (x + int(hn::Lanes(d)) <= end) return hn::StoreU(values, d, row + x);
    HWY_ALIGN hn::TFromD<D> some[hn::MaxLanes(d)];
    hn::Store(values, d, some);
    std::copy_n(some, end - x, row + x);
}

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

/// A bit for each lane, from the lowest; 64 of them at most.
template <class D>
HWY_INLINE std::uint64_t bitsOf(D d, hn::Mask<D> mask)
{
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    std::uint64_t bits = 0;
    std::memcpy(&bits, bytes, sizeof bits);
    return bits;
}

/// 64-bit offsets for as many lanes as a 32-bit vector has, in two vectors.
template <class D32>
struct WideOffsets {
    using D64 = hn::Repartition<std::int64_t, D32>;
    hn::Vec<D64> lower, upper;
};

template <class D32, class At>
HWY_INLINE WideOffsets<D32> widen(D32, At offsets)
{
    const typename WideOffsets<D32>::D64 d64;
    const hn::Half<hn::Repartition<std::int32_t, D32>> half;
    return {hn::PromoteTo(d64, hn::LowerHalf(half, offsets)), hn::PromoteTo(d64, hn::UpperHalf(half, offsets))};
}

/// Four vectors, such as word k of a 128-bit record per lane.
template <class V>
struct Block4 {
    V a, b, c, d;
};

/// One vector of the 128-bit blocks at base + kWords * index[k], base + kWords * index[k + 4] and so on.
template <int kWords, class D32, class T, class Index>
HWY_INLINE hn::Vec<D32> joinBlocks(D32 du, const T* base, const Index* index)
{
    const hn::Full128<T> block;
    const auto load = [&](int k) AEOLIC_INLINE { return hn::LoadU(block, base + kWords * std::size_t(index[k])); };
    constexpr std::size_t kBlocks = hn::MaxLanes(du) * sizeof(T) / 16;
    if constexpr (kBlocks == 1) {
        return load(0);
    } else if constexpr (kBlocks == 2) {
        return hn::Combine(du, load(4), load(0));
    } else {
        const hn::Half<D32> half;
        return hn::Combine(du, hn::Combine(half, load(12), load(8)), hn::Combine(half, load(4), load(0)));
    }
}

/// Transposes 4x4 words within 128-bit blocks.
template <class D32, class V = hn::Vec<D32>>
HWY_INLINE Block4<V> transposeBlocks(D32 du, V p, V q, V r, V s)
{
    const hn::Repartition<std::uint64_t, D32> d64;
    const auto as64 = [&](V v) { return hn::BitCast(d64, v); };
    const auto pqLow = as64(hn::InterleaveLower(du, p, q)), pqHigh = as64(hn::InterleaveUpper(du, p, q));
    const auto rsLow = as64(hn::InterleaveLower(du, r, s)), rsHigh = as64(hn::InterleaveUpper(du, r, s));
    return {hn::BitCast(du, hn::InterleaveLower(d64, pqLow, rsLow)),
            hn::BitCast(du, hn::InterleaveUpper(d64, pqLow, rsLow)),
            hn::BitCast(du, hn::InterleaveLower(d64, pqHigh, rsHigh)),
            hn::BitCast(du, hn::InterleaveUpper(d64, pqHigh, rsHigh))};
}

/// A load's address is a register times 8 at most. Records of 16 bytes are counted in halves, all lanes at once.
template <int kWords, class T>
constexpr int blockStep()
{
    return kWords * sizeof(T) == 16 ? kWords / 2 : kWords;
}

template <int kWords, class T, class D32, class At>
HWY_INLINE void storeBlockIndices(D32, At at, std::uint32_t (&index)[hn::MaxLanes(D32())])
{
    const hn::RebindToUnsigned<D32> dIndex;
    auto steps = hn::BitCast(dIndex, at);
    if constexpr (blockStep<kWords, T>() < kWords) steps = hn::ShiftLeft<1>(steps);
    hn::Store(steps, dIndex, index);
    // Through memory for certain: lane by lane out of the register (what GCC prefers) costs a third of the whole trace.
    asm("" : "+m"(index));
}

/// joinBlocks() by indices that storeBlockIndices() has stored.
template <int kWords, class D32, class T>
HWY_INLINE hn::Vec<D32> joinIndexed(D32 du, const T* base, const std::uint32_t* index)
{
    return hn::BitCast(du, joinBlocks<blockStep<kWords, T>()>(hn::Repartition<T, D32>(), base, index));
}

/// The 128 bits at base[kWords * at], at >= 0, a lane each: a whole record of four words, or two neighbouring ones of
/// two. Plain loads and a transposition: on Zen 5 twice as fast as gather instructions of half the bits. `at` < 2^31.
template <int kWords, class D32, class T, class At>
HWY_INLINE Block4<hn::Vec<D32>> loadBlocks(D32 du, const T* base, At at)
{
    HWY_ALIGN std::uint32_t index[hn::MaxLanes(du)];
    storeBlockIndices<kWords, T>(du, at, index);
    const auto join = [&](int k) AEOLIC_INLINE { return joinIndexed<kWords>(du, base, index + k); };
    return transposeBlocks(du, join(0), join(1), join(2), join(3));
}

/// loadBlocks() from two places, `base` and `other`, each index being read once for both.
template <int kWords, class D32, class T, class At>
HWY_INLINE void loadBlocksTwice(D32 du, const T* base, const T* other, At at, Block4<hn::Vec<D32>>& first,
                                Block4<hn::Vec<D32>>& second)
{
    HWY_ALIGN std::uint32_t index[hn::MaxLanes(du)];
    storeBlockIndices<kWords, T>(du, at, index);
    hn::Vec<D32> a[4], b[4];
    for (int k = 0; k < 4; ++k) {
        a[k] = joinIndexed<kWords>(du, base, index + k);
        b[k] = joinIndexed<kWords>(du, other, index + k);
    }
    first = transposeBlocks(du, a[0], a[1], a[2], a[3]);
    second = transposeBlocks(du, b[0], b[1], b[2], b[3]);
}

/// The 128 bits at 64-bit byte offsets `at` + `plus` from `base`, a lane each.
template <class D, class Wide>
HWY_INLINE Block4<hn::Vec<D>> loadBlocksWide(D d, const void* base, const Wide& at, std::ptrdiff_t plus)
{
    HWY_ALIGN std::int64_t offset[hn::MaxLanes(d)];
    const typename WideOffsets<D>::D64 d64;
    hn::Store(at.lower, d64, offset);
    hn::Store(at.upper, d64, offset + hn::Lanes(d64));
    asm("" : "+m"(offset));
    const auto* from = static_cast<const std::uint8_t*>(base) + plus;
    const hn::Repartition<std::uint8_t, D> d8;
    const auto join = [&](int k) AEOLIC_INLINE { return hn::BitCast(d, joinBlocks<1>(d8, from, offset + k)); };
    return transposeBlocks(d, join(0), join(1), join(2), join(3));
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
