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
/// elements. resize() keeps the memory when it suffices: no allocation per frame.
template <class T>
class Image {
public:
    static constexpr int kApron = 16;      ///< Columns; a vector of any target fits.
    static constexpr int kApronRows = 10;  ///< The longest step (kLongestStepPx) and the taps beyond it.

    /// Makes `valid` the extent. The apron is zeroed; what is inside is unspecified until written. Throws
    /// std::bad_alloc.
    void resize(const Extent& valid)
    {
        valid_ = valid;
        stride_ = std::ptrdiff_t(kApron + (valid.width() + kApron - 1) / kApron * kApron + kApron);
        const std::size_t count = std::size_t(stride_) * std::size_t(valid.height() + 2 * kApronRows) + kTail;
        if (count > capacity_) {
            // A stripe that grows from frame to frame takes new memory only now and then: its first touch is slow.
            const std::size_t grown = capacity_ > 0 ? std::max(count, capacity_ + capacity_ / 4) : count;
            capacity_ = 0;
            memory_.reset();  // Before the new one is taken: never both.
            memory_ = makeLargeArray<T>(grown);
            capacity_ = grown;
        }
        origin_ = memory_.get() + kApronRows * stride_ + kApron;
        clearApron();
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

    void clearApron()
    {
        const std::size_t band = std::size_t(kApronRows) * std::size_t(stride_);
        std::memset(static_cast<void*>(memory_.get()), 0, band * sizeof(T));
        for (int y = 0; y < valid_.height(); ++y) {
            T* start = memory_.get() + (kApronRows + y) * stride_;
            std::memset(static_cast<void*>(start), 0, kApron * sizeof(T));
            std::memset(static_cast<void*>(start + kApron + valid_.width()), 0,
                        std::size_t(stride_ - kApron - valid_.width()) * sizeof(T));
        }
        std::memset(static_cast<void*>(memory_.get() + (kApronRows + valid_.height()) * stride_), 0,
                    (band + kTail) * sizeof(T));
    }

    Extent valid_;
    std::ptrdiff_t stride_ = 0;
    LargeArray<T> memory_;
    T* origin_ = nullptr;
    std::size_t capacity_ = 0;
};

}  // namespace aeolic
