#pragma once

#include <cstdint>
#include <vector>

#include "render/gl/device/gpu_scene.h"
#include "render/gl/device/programs.h"
#include "render/gl/device/read_back.h"
#include "render/view.h"

namespace aeolic::gl {

/// Covered pixels of each row of an image of triangle numbers, counted while other work goes on.
class RowCounts {
public:
    /// Starts counting rows [y0, y1) of `visible`.
    void start(Programs& programs, const Texture& visible, int y0, int y1);

    /// Whether wait() would have to wait for the device.
    bool pending() const { return copy_.pending(); }
    void wait();

    /// Pixels of rows [y0, y1); rows that were not counted have none. Not while pending.
    std::int64_t get(int y0, int y1) const;

private:
    int y0_ = 0, y1_ = 0;
    GrowingBuffer counts_{0};
    ReadBack copy_;
    const std::byte* found_ = nullptr;
};

/// Counts the covered pixels of each row at a lower resolution.
class CoverageCount {
public:
    std::vector<std::int64_t> count(Programs& programs, const GpuScene& scene, const View& view);

private:
    Buffer block_;
    Texture ids_, depth_;
    Framebuffer target_;
    RowCounts counts_;
};

}  // namespace aeolic::gl
