#pragma once

#include <cstdint>
#include <vector>

#include "render/coverage_bits.h"
#include "render/cpu/project/scene_arrays.h"
#include "render/cpu/project/transform.h"
#include "render/view.h"

namespace aeolic::cpu {

/// How much of each row a surface covers. A bit for each pixel and no depth: what is in front does not matter. Memory
/// is kept between frames.
class CoverageCount {
public:
    /// Local. Pixels of the view's image that the `part`-th of `parts` equal parts of the triangles (GroupPart) covers:
    /// those whose centre lies inside or on an edge of one before the far plane's. Valid until the next call. Cost:
    /// 10 ns a triangle and core, less where they are smaller than pixels.
    CoverageBits& draw(const SceneArrays& arrays, const View& view, int part = 0, int parts = 1);

private:
    struct Chunk {
        std::vector<TriangleBox> large;
        std::vector<std::uint32_t> unsafe;
    };
    struct Corners {
        std::int32_t x[3], y[3];  // Sub-pixels (transform.h).
    };
    void drawRange(const SceneArrays& arrays, const View& view, const Extent& whole, std::size_t begin, std::size_t end,
                   Chunk& chunk);
    void drawTriangle(Corners t, const TriangleBox& box);
    void drawRows(const Corners& t, const TriangleBox& box);
    bool isMarked(int y, int x0, int x1) const;
    void mark(int y, int x0, int x1);

    VisibleGroups visible_;
    ScreenVertices screen_;
    std::vector<Chunk> chunks_;
    CoverageBits bits_;
};

}  // namespace aeolic::cpu
