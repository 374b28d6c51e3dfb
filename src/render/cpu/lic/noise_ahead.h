#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

#include "render/cpu/simd/prefetch.h"
#include "render/noise.h"

namespace aeolic::cpu {

/// Pixels fetch noise from all over its 256 KB, a line after another that is not in a near cache: each thread asks for
/// all of it at once, before its first pixels of a frame. One object a frame.
class NoiseAhead {
public:
    explicit NoiseAhead(const NoisePyramid& noise) : noise_(noise)
    {
        static std::atomic<std::uint64_t> frames{0};
        frame_ = ++frames;
    }
    void ask() const
    {
        thread_local std::uint64_t asked = 0;
        if (std::exchange(asked, frame_) != frame_) prefetchAll(noise_.cells.data(), noise_.cells.size());
    }

private:
    const NoisePyramid& noise_;
    std::uint64_t frame_;
};

}  // namespace aeolic::cpu
