#pragma once

#include <vector>

#include "render/backend.h"
#include "render/gl/device/objects.h"

namespace aeolic::gl {

enum class Stage { project, convolve, shade, readBack };

/// What the stages of a frame take the device, by its own clock. A stage may consist of several intervals; waiting for
/// other ranks lies between them.
class StageTimers {
public:
    void startFrame() { used_ = 0; }
    void begin(Stage stage);
    void end();

    /// The times of the frame that began at startFrame(), which is then over. Waits for the device.
    DeviceTimes read();

private:
    struct Interval {
        Stage stage;
        Query begin, end;
    };
    std::vector<Interval> intervals_;
    std::size_t used_ = 0;
};

}  // namespace aeolic::gl
