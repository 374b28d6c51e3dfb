#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/coverage_bits.h"
#include "render/cpu/project/scene_arrays.h"
#include "render/cpu/project/transform.h"

namespace aeolic::cpu {

/// Sets the bits of pixels whose centre lies inside or on an edge of one of triangles [begin, end), a vector of them at
/// a time. `bits`: of the whole image `whole`; several threads may set some at once. Appends the boxes of those larger
/// than a few pixels, and the ids of those that need clipping first: what these cover is the caller's to find. Local.
/// Cost: 4 to 8 ns a triangle of a pixel or two.
void coverSmall(const SceneArrays& arrays, const ScreenVertices& screen, std::size_t begin, std::size_t end,
                const Extent& whole, CoverageBits& bits, std::vector<TriangleBox>& large,
                std::vector<std::uint32_t>& unsafe);

}  // namespace aeolic::cpu
