#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "base/extent.h"
#include "base/large_memory.h"

namespace aeolic {

/// Local. Zeros in the first `left` and the last `right` bytes of each of `count` rows, which follow each other. On all
/// threads of the current arena where the rows are large: to touch new memory takes longer than the writing.
void clearSides(void* rows, std::size_t rowBytes, std::size_t count, std::size_t left, std::size_t right);

/// Local. std::memmove. On all threads of the current arena where there is much to move, and farther than it is long.
void moveBytes(void* to, const void* from, std::size_t bytes);

/// Pixels of one band of rows, addressed by global coordinates. Around the valid extent lies an apron of zeros,
/// `kApronRows` above and below and `kApron` columns left and right, so that kernels may read neighbours, whole vectors
/// past the last column, and as far as a streamline can step, without a test. Column x0 of every row is aligned to 16
/// elements. resize() keeps the memory when it suffices: no allocation per frame. Nobody may
/// write anything but zeros into the apron.
template <class T>
class Image {
public:
    static constexpr int kApron = 16;      ///< Columns; a vector of any target fits.
    static constexpr int kApronRows = 10;  ///< The longest step (kLongestStepPx) and the taps beyond it.

    /// Makes `valid` the extent. The apron is zeroed; pixels are unspecified until written. Throws
    /// std::bad_alloc.
    void resize(const Extent& valid) { resizeFrom(valid, valid.y0); }

    /// The same, with memory for rows from `first` on alone, and the apron around those. Nobody may touch the rows
    /// before.
    void resizeFrom(const Extent& valid, int first) { hold(valid, first, 1); }

    /// Makes `valid` the extent of a window that goes down a picture, with memory for rows from `first` on alone. Those
    /// that were there stay, where the extent before had the same columns. Other pixels are unspecified. Throws
    /// std::bad_alloc. Cost: copies those rows.
    void roll(const Extent& valid, int first)
    {
        // The first window of a picture is often the smallest. Memory that nobody touches costs nothing.
        constexpr std::size_t spare = 2;
        const Extent old = held();
        const int begin = std::max({first, old.y0, valid.y0}), end = std::min(old.y1, valid.y1);
        if (begin >= end || valid.x0 != old.x0 || valid.x1 != old.x1) return hold(valid, first, spare);
        if (elementsFor(valid.y1 - std::max(first, valid.y0)) > capacity_) {
            Image before;
            std::swap(before, *this);
            hold(valid, first, spare);
            moveBytes(start(begin), before.start(begin), rowBytes() * std::size_t(end - begin));
            return;
        }
        const void* from = start(begin);
        place(valid, first);
        moveBytes(start(begin), from, rowBytes() * std::size_t(end - begin));
        clearApron(old.height());
    }

    const Extent& valid() const { return valid_; }
    std::ptrdiff_t stride() const { return stride_; }

    /// Pointer p with p[x] the pixel (x, y): x counts from the extent's x0 = 0 column in global coordinates.
    T* row(int y) { return origin_ + (y - valid_.y0) * stride_ - valid_.x0; }
    const T* row(int y) const { return origin_ + (y - valid_.y0) * stride_ - valid_.x0; }

    /// The pixel (x0, y0).
    T* origin() { return origin_; }
    const T* origin() const { return origin_; }

    T& at(int x, int y) { return row(y)[x]; }
    const T& at(int x, int y) const { return row(y)[x]; }

    /// Gives the pixels of `part` a value.
    void fill(const Extent& part, const T& value)
    {
        for (int y = part.y0; y < part.y1; ++y) std::fill(row(y) + part.x0, row(y) + part.x1, value);
    }
    /// Makes the row zero outside of `columns`.
    void clearBeside(int y, const ColumnSpan& columns)
    {
        std::fill(row(y) + valid_.x0, row(y) + columns.x0, T{});
        std::fill(row(y) + columns.x1, row(y) + valid_.x1, T{});
    }

    std::size_t bytes() const { return capacity_ * sizeof(T); }

private:
    static constexpr std::size_t kTail =
        64;  // Bytes past the last pixel that a wide gather of a narrow type may touch.

    static constexpr int kNotZeroed = -1;

    // What there is memory for.
    Extent held() const { return {valid_.x0, first_, valid_.x1, valid_.y1}; }
    std::size_t elementsFor(int height) const
    {
        return std::size_t(stride_) * std::size_t(height + 2 * kApronRows) + kTail;
    }

    void hold(const Extent& valid, int first, std::size_t spare)
    {
        const bool sameColumns = capacity_ > 0 && valid.width() == valid_.width();
        int zeroedHeight = sameColumns ? held().height() : kNotZeroed;
        stride_ = std::ptrdiff_t(kApron + (valid.width() + kApron - 1) / kApron * kApron + kApron);
        const std::size_t count = elementsFor(valid.y1 - std::max(first, valid.y0));
        if (count > capacity_) {
            // A stripe that grows from frame to frame takes new memory only now and then: its first touch is slow.
            const std::size_t grown =
                capacity_ > 0 ? std::max(count * spare, capacity_ + capacity_ / 4) : count * spare;
            capacity_ = 0;
            memory_.reset();  // The old memory goes before new memory is taken.
            memory_ = makeLargeArray<T>(grown);
            capacity_ = grown;
            zeroedHeight = kNotZeroed;
        }
        place(valid, first);
        clearApron(zeroedHeight);
    }

    void place(const Extent& valid, int first)
    {
        valid_ = valid;
        first_ = std::max(first, valid.y0);
        origin_ = memory_.get() + (kApronRows - (first_ - valid.y0)) * stride_ + kApron;
    }

    // A row with its apron.
    T* start(int y) { return origin_ + (y - valid_.y0) * stride_ - kApron; }
    std::size_t rowBytes() const { return std::size_t(stride_) * sizeof(T); }

    // `zeroedHeight`: the apron was last zeroed for so many rows of the same columns.
    void clearApron(int zeroedHeight)
    {
        const int height = held().height(),
                  fresh = zeroedHeight == kNotZeroed ? -kApronRows : zeroedHeight + kApronRows;
        // Rows that were apron are zeroed already. Above them lie old pixels, below them unknown memory.
        if (zeroedHeight == kNotZeroed) clearRows(-kApronRows, 0);
        if (height < zeroedHeight) clearRows(height, std::min(height + kApronRows, zeroedHeight));
        const int sides = std::max(fresh, 0);
        if (sides < height)
            clearSides(start(first_ + sides), rowBytes(), std::size_t(height - sides), kApron * sizeof(T),
                       rowBytes() - std::size_t(kApron + valid_.width()) * sizeof(T));
        clearRows(std::max(height, fresh), height + kApronRows);
        std::memset(static_cast<void*>(start(valid_.y1 + kApronRows)), 0, kTail * sizeof(T));
    }

    // Counted from the first row that there is memory for.
    void clearRows(int begin, int end)
    {
        if (begin >= end) return;
        std::memset(static_cast<void*>(start(first_ + begin)), 0, std::size_t(end - begin) * rowBytes());
    }

    Extent valid_;
    int first_ = 0;  // Rows before it are not in memory.
    std::ptrdiff_t stride_ = 0;
    LargeArray<T> memory_;
    T* origin_ = nullptr;
    std::size_t capacity_ = 0;
};

}  // namespace aeolic
