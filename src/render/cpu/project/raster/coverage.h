#pragma once

#include "render/coverage_bits.h"
#include "render/cpu/project/visibility.h"

namespace aeolic::cpu {

/// How much of each row a surface covers. Memory is kept between frames.
class CoverageCount {
public:
    /// Local. The pixels of the view's image that the `part`-th of `parts` equal parts of the triangles (GroupPart)
    /// covers, as the rasterizer draws them. Valid until the next call. Cost: 20 ns a triangle and core.
    CoverageBits& draw(const SceneArrays& arrays, const View& view, int part = 0, int parts = 1);

private:
    Visibility visibility_;
    CoverageBits bits_;
};

}  // namespace aeolic::cpu
