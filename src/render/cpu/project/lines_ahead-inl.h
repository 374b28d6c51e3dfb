// Per-target include (Highway compiles it once per target): cache lines of a field, asked for before they are read.

#if defined(AEOLIC_RENDER_CPU_LINES_AHEAD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef AEOLIC_RENDER_CPU_LINES_AHEAD_INL_H
#undef AEOLIC_RENDER_CPU_LINES_AHEAD_INL_H
#else
#define AEOLIC_RENDER_CPU_LINES_AHEAD_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "render/cpu/project/field_sampling-inl.h"

#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The cache lines that cells are in, asked for before their vectors are looked up. A few at a time: a core waits for a
/// dozen or so at once, and while more are asked for what it computes finds no way to its own caches.
/// (Xeon, 800x800, 76,000 pixels of one of eight bricks: found and sampled in 2.7 ms for 3.1 of 512^3 samples, in 1.8
/// for 1.9 of 128^3.)
class LinesAhead {
public:
    /// Null: asks for nothing.
    explicit LinesAhead(const FieldLookup* f)
        : samples_(static_cast<const std::byte*>(f ? f->samples : nullptr)),
          start_(std::int64_t(reinterpret_cast<std::uintptr_t>(samples_) & ((1 << kLineBits) - 1)))
    {
    }

    /// Adds the lines of cells: of kMostCells at most between one askForAll() and the next.
    HWY_INLINE void add(const FieldLookup& f, const Cell<DF>& cell)
    {
        const std::int64_t sample = f.strideBytes[0];
        if (f.tiled) {
            for (int k = 0; k < kCellRows; ++k)
                addRow(lineOf(f, cell.left[k], 0), lineOf(f, cell.right[k], 2 * sample - 1));
            return;
        }
        if (!kWorthInRows) return;
        const std::int64_t y = f.strideBytes[1], z = f.strideBytes[2];
        for (const std::int64_t row : {std::int64_t{0}, y, z, y + z})
            addRow(lineOf(cell.offset, row), lineOf(cell.offset, row + 2 * sample - 1));
    }

    HWY_INLINE void askForSome()
    {
        constexpr std::size_t kSome = 12;
        askUpTo(std::min(asked_ + kSome, found_));
    }

    HWY_INLINE void askForAll()
    {
        askUpTo(found_);
        asked_ = found_ = 0;
    }

    static constexpr std::size_t kMostCells = 64;

private:
    static constexpr int kLineBits = 6;
    // Samples in rows are most often those of small fields, which the caches nearly hold: asked for in vectors of 8
    // pixels and less they take longer to find than they spare (one rank, 128^3: projecting 15.8 ms with, 15.0
    // without).
    static constexpr bool kWorthInRows = hn::MaxLanes(DU()) > 8;

    /// The line of the byte `plus` of a sample in tiles. The samples of three lines are a power of two.
    HWY_INLINE VU lineOf(const FieldLookup& f, VU sample, std::int64_t plus) const
    {
        const DU du;
        const auto inThrees = [&](VU threes, VU samplesBefore) AEOLIC_INLINE {
            const VU bytes = hn::Mul(hn::Sub(sample, samplesBefore), hn::Set(du, std::uint32_t(f.strideBytes[0])));
            const VU at = hn::Add(bytes, hn::Set(du, std::uint32_t(start_ + plus)));
            return hn::Add(hn::Add(threes, hn::Add(threes, threes)), hn::ShiftRight<kLineBits>(at));
        };
        constexpr int kFloatBits = 4, kHalfBits = 5;
        const VU threes = f.half ? hn::ShiftRight<kHalfBits>(sample) : hn::ShiftRight<kFloatBits>(sample);
        return inThrees(threes, f.half ? hn::ShiftLeft<kHalfBits>(threes) : hn::ShiftLeft<kFloatBits>(threes));
    }

    /// The lines of bytes in rows. A brick's are counted from the whole grid's first: beyond 256 GB of that a wrong
    /// line is asked for, which does no harm.
    HWY_INLINE VU lineOf(const WideOffsets<DF>& at, std::int64_t plus) const
    {
        const WideOffsets<DF>::D64 d64;
        const auto bytes = hn::Set(d64, start_ + plus);
        const auto line = [&](auto offset) AEOLIC_INLINE {
            return hn::BitCast(DU(), hn::ShiftRight<kLineBits>(hn::Add(offset, bytes)));
        };
        return hn::ConcatEven(DU(), line(at.upper), line(at.lower));
    }

    /// Neighbouring pixels share most of theirs.
    HWY_INLINE void addRow(VU left, VU right)
    {
        const DU du;
        const MU first = hn::FirstN(du, 1);
        const auto before = hn::IndicesFromVec(du, hn::Max(hn::Iota(DI(), -1), hn::Zero(DI())));
        const auto differs = [&](VU line) AEOLIC_INLINE {
            return hn::Or(first, hn::Ne(line, hn::TableLookupLanes(line, before)));
        };
        found_ += compressStore(left, differs(left), du, lines_ + found_);
        found_ += compressStore(right, hn::And(differs(right), hn::Ne(right, left)), du, lines_ + found_);
    }

    HWY_INLINE void askUpTo(std::size_t end)
    {
        for (; asked_ < end; ++asked_)
            __builtin_prefetch(samples_ + ((std::int64_t(lines_[asked_]) << kLineBits) - start_));
    }

    const std::byte* samples_;
    std::int64_t start_;  // How many bytes of the first line come before them; lines are counted from its beginning.
    std::size_t asked_ = 0, found_ = 0;
    // Stores are of whole vectors.
    std::uint32_t lines_[kMostCells * kCellRows * 2 + hn::MaxLanes(DU())];
};

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
