#pragma once

#include <cstdint>
#include <vector>

#include "render/cpu/project/raster/transform.h"
#include "render/cpu/project/raster/triangle_groups.h"
#include "render/cpu/project/scene_arrays.h"
#include "render/edge_mask.h"
#include "render/view.h"

namespace aeolic::cpu {

/// The triangles of a mesh that may show in a part of the image, in chunks for many processors. They are found once in
/// a frame: its edges are looked up among the same ones. Memory is kept between frames.
class FoundTriangles {
public:
    /// Local. Projects points, and finds the triangles of groups of `part` that may show in `scissor` (global pixels).
    /// Cost: 15 ns a triangle.
    void find(const SceneArrays& arrays, const View& view, const Extent& scissor, const GroupPart& part = {});
    /// Whether the call before found what shows in `scissor` for such a view of the same scene.
    bool has(const SceneArrays& arrays, const View& view, const Extent& scissor) const;

    std::size_t chunks() const { return count_; }
    /// Those that may cover the centre of a pixel.
    const std::vector<TriangleBox>& boxes(std::size_t chunk) const { return chunks_[chunk].boxes; }
    /// Those that need clipping first.
    const std::vector<std::uint32_t>& unsafe(std::size_t chunk) const { return chunks_[chunk].unsafe; }
    /// Those that may cover a sample of one of the `marked` pixels in `scissor`, none that needs clipping: some of
    /// boxes(), and triangles that lie between the centres of pixels. Cost: 15 ns a triangle.
    void findMarked(std::size_t chunk, const MarkedBoxes& marked, const Extent& scissor,
                    std::vector<TriangleBox>& out) const;

    const ScreenVertices& screen() const { return screen_; }

private:
    struct Chunk {
        std::vector<TriangleBox> boxes;
        std::vector<std::uint32_t> unsafe;
    };
    std::size_t firstGroup(std::size_t chunk) const { return visible_.groups() * chunk / count_; }

    const SceneArrays* arrays_ = nullptr;
    View view_;
    Extent scissor_;
    VisibleGroups visible_;
    ScreenVertices screen_;
    std::size_t count_ = 0;
    std::vector<Chunk> chunks_;
    std::vector<std::uint64_t> between_;  // A bit for each triangle that covers samples, but no pixel's centre.
};

}  // namespace aeolic::cpu
