#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "base/extent.h"
#include "base/large_memory.h"

namespace aeolic {

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
    void resize(const Extent& valid)
    {
        const bool sameColumns = capacity_ > 0 && valid.width() == valid_.width();
        int zeroedHeight = sameColumns ? valid_.height() : kNotZeroed;
        valid_ = valid;
        stride_ = std::ptrdiff_t(kApron + (valid.width() + kApron - 1) / kApron * kApron + kApron);
        const std::size_t count = std::size_t(stride_) * std::size_t(valid.height() + 2 * kApronRows) + kTail;
        if (count > capacity_) {
            // A stripe that grows from frame to frame takes new memory only now and then: its first touch is slow.
            const std::size_t grown = capacity_ > 0 ? std::max(count, capacity_ + capacity_ / 4) : count;
            capacity_ = 0;
            memory_.reset();  // The old memory goes before new memory is taken.
            memory_ = makeLargeArray<T>(grown);
            capacity_ = grown;
            zeroedHeight = kNotZeroed;
        }
        origin_ = memory_.get() + kApronRows * stride_ + kApron;
        clearApron(zeroedHeight);
    }

    /// Makes `valid` the extent of a window that goes down a picture. Rows from `keepFrom` on stay, where they are in
    /// the extent before and in this one, and both have the same columns. Other pixels are unspecified. Throws
    /// std::bad_alloc. Cost: copies those rows.
    void roll(const Extent& valid, int keepFrom)
    {
        const Extent old = valid_;
        const int first = std::max({keepFrom, old.y0, valid.y0}), end = std::min(old.y1, valid.y1);
        const bool keeps = first < end && valid.x0 == old.x0 && valid.x1 == old.x1;
        if (!keeps) return resize(valid);
        if (valid.height() > old.height()) {
            Image before;
            std::swap(before, *this);
            resize(valid);
            std::memcpy(start(first), before.start(first), rowBytes() * std::size_t(end - first));
            return;
        }
        const void* from = start(first);
        valid_ = valid;
        std::memmove(start(first), from, rowBytes() * std::size_t(end - first));
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

    std::size_t bytes() const { return capacity_ * sizeof(T); }

private:
    static constexpr std::size_t kTail =
        64;  // Bytes past the last pixel that a wide gather of a narrow type may touch.

    static constexpr int kNotZeroed = -1;

    // A row with its apron.
    void* start(int y) { return origin_ + (y - valid_.y0) * stride_ - kApron; }
    std::size_t rowBytes() const { return std::size_t(stride_) * sizeof(T); }

    // `zeroedHeight`: the apron was last zeroed for so many rows of the same columns.
    void clearApron(int zeroedHeight)
    {
        const int height = valid_.height(),
                  fresh = zeroedHeight == kNotZeroed ? -kApronRows : zeroedHeight + kApronRows;
        // Rows that were apron are zeroed already. Above them lie old pixels, below them unknown memory.
        if (zeroedHeight == kNotZeroed) clearRows(-kApronRows, 0);
        if (height < zeroedHeight) clearRows(height, std::min(height + kApronRows, zeroedHeight));
        for (int y = std::max(fresh, 0); y < height; ++y) {
            T* start = origin_ + y * stride_ - kApron;
            std::memset(static_cast<void*>(start), 0, kApron * sizeof(T));
            std::memset(static_cast<void*>(start + kApron + valid_.width()), 0,
                        std::size_t(stride_ - kApron - valid_.width()) * sizeof(T));
        }
        clearRows(std::max(height, fresh), height + kApronRows);
        std::memset(static_cast<void*>(origin_ - kApron + (height + kApronRows) * stride_), 0, kTail * sizeof(T));
    }

    void clearRows(int begin, int end)
    {
        if (begin >= end) return;
        std::memset(static_cast<void*>(origin_ - kApron + begin * stride_), 0,
                    std::size_t(end - begin) * std::size_t(stride_) * sizeof(T));
    }

    Extent valid_;
    std::ptrdiff_t stride_ = 0;
    LargeArray<T> memory_;
    T* origin_ = nullptr;
    std::size_t capacity_ = 0;
};

}  // namespace aeolic
