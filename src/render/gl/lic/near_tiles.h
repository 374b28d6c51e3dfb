#pragma once

#include "render/gl/device/programs.h"
#include "render/gl/project/frame_images.h"

namespace aeolic::gl {

/// The tiles of 16x16 pixels near flow: where traces may read, and all that the LIC stage computes. Background costs
/// nothing but looking.
class NearTiles {
public:
    /// Finds them among rows [y0, y1) of the rows held, where `images.flow` is right.
    void find(Programs& programs, const FrameImages& images, int y0, int y1);

    /// Runs `program` on every pixel of these tiles in rows [y0, y1) of the rows held, `directions` times.
    void run(GLuint program, int y0, int y1, int directions = 1) const;

private:
    Buffer tiling_, noTiles_;
    GrowingBuffer flags_{0}, list_{0};
};

}  // namespace aeolic::gl
