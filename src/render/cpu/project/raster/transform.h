#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/extent.h"
#include "render/cpu/project/scene_arrays.h"
#include "render/view.h"

namespace aeolic::cpu {

/// Fixed-point image coordinates: 1/256 pixel. Integer edge functions of these are exact, so shared edges neither gap
/// nor overlap and no result depends on tile, stripe or thread.
inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixels = 1 << kSubpixelBits;
/// x of a vertex that needs clipping first: behind the near plane, or too far off the image for exact arithmetic.
inline constexpr std::int32_t kUnsafe = INT32_MIN;
/// Farthest safe distance from the image's origin, in pixels.
inline constexpr float kGuardBandPx = float(1 << 21);

/// A surface point on the image. Triangles have their points anywhere, so all of one lies in one line of the cache.
struct alignas(16) ScreenVertex {
    std::int32_t x, y;  ///< Sub-pixels, origin top left of the whole image; x may be kUnsafe.
    float invDepth;     ///< 1 / eye depth.
    std::uint32_t unused = 0;
};
/// By point index. Memory is kept between frames.
using ScreenVertices = std::vector<ScreenVertex>;

/// Projects the points of groups that may show; of others `out` keeps what it held. Local. Cost: about 1 ns per point
/// and core.
void transformVertices(const SceneArrays& arrays, const View& view, const VisibleGroups& visible, ScreenVertices& out);

/// Pixel bounds of triangles that may cover a pixel centre of `scissor`, in ascending order of id.
struct TriangleBox {
    std::uint32_t id;
    std::int32_t x0, y0, x1, y1;  ///< Half-open, clipped to the scissor.
    std::int16_t facing = 0;      ///< 1: its corners run clockwise on the image. A hint: thin ones may be wrong.
    std::int16_t beside = 0;      ///< At which sides a pixel more is within the margin of setUpTriangles().

    static constexpr int kLeft = 1, kTop = 2, kRight = 4, kBottom = 8;
    /// With those pixels. A margin of a pixel reaches one more at the most.
    TriangleBox withBeside() const
    {
        const auto has = [&](int side) { return std::int32_t((beside & side) != 0); };
        return {id, x0 - has(kLeft), y0 - has(kTop), x1 + has(kRight), y1 + has(kBottom), facing, beside};
    }
};

/// What setUpTriangles() finds.
struct TriangleFinds {
    std::vector<TriangleBox>& boxes;     ///< Of triangles that cover at least one pixel centre's row and column.
    std::vector<std::uint32_t>& unsafe;  ///< Ids of those that need clipping first.
    std::uint64_t* between;              ///< A bit for each triangle of the mesh, which are 0: see `margin`.
};

/// Appends to `out` what there is of triangles [begin, end), whole groups. Triangles that cover no pixel's centre, but
/// may cover something not farther than `margin` sub-pixels from one, are marked as between.
void setUpTriangles(const SceneArrays& arrays, const ScreenVertices& screen, std::size_t begin, std::size_t end,
                    const Extent& scissor, int margin, const TriangleFinds& out);

}  // namespace aeolic::cpu
