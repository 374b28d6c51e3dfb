#pragma once

#include <cstdint>
#include <vector>

#include "render/cpu/edges/edge_colors.h"
#include "render/cpu/edges/edge_samples.h"

namespace aeolic::cpu {

/// Anti-aliasing (antialias.h). Memory is kept between frames.
class EdgeStage {
public:
    /// Smooths the edges in the rows of `compute` of `out`, where every pixel is shaded already. The scene's images are
    /// right in these rows and the rows next to them. `visibility` is used up. Local; Collective with `pieces`.
    void run(const EdgeScene& scene, Visibility& visibility, const Extent& compute, Tile& out, EdgeExchange* pieces);

private:
    void shadeBeside(const EdgeScene& scene, const Extent& compute);
    void findPixels(const Visibility& visibility);
    /// What the triangles here show in the whole picture's edges, gathered from all ranks into those of this one.
    void composite(const EdgeScene& scene, Visibility& visibility, const Extent& compute, EdgeExchange& pieces);
    void takeNearest(const Visibility& visibility, const std::vector<EdgePixelSeen>& seen);

    EdgeMask mask_;
    Tile above_, below_;
    std::vector<EdgePixels> pixels_;     // [tiles], or more.
    std::vector<std::uint32_t> before_;  // [tiles + 1]: edge pixels in the tiles before.
    EdgeSamples nearest_;                // Of all edge pixels, where the surface is in pieces.
    std::vector<std::uint32_t> colors_;  // Of all edge pixels, tile after tile.
};

}  // namespace aeolic::cpu
