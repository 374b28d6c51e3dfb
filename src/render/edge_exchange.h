#pragma once

#include <cstdint>
#include <vector>

#include "render/antialias.h"
#include "render/edge_mask.h"

namespace aeolic {

/// What one rank's piece of the surface shows at a sample of an edge pixel.
struct EdgeSample {
    std::uint64_t order = 0;  ///< SurfaceMesh::order: of equally near triangles the least shows.
    std::uint32_t depth = 0;  ///< Bits of 1/depth, by which triangles hide each other; 0: nothing.
    std::uint32_t unused = 0;
    float invDepth = 0, gradX = 0, gradY = 0, light = 0;  ///< As GBuffer has them.

    /// Whether this shows, not `other`.
    bool hides(const EdgeSample& other) const
    {
        return depth > other.depth || (depth == other.depth && depth != 0 && order < other.order);
    }
};

/// An edge pixel in which something of a piece shows.
struct EdgePixelSeen {
    std::int32_t x = 0, y = 0;
    EdgeSample samples[antialias::kSamples];
};

/// Where the surface is in pieces: brings what edges are smoothed from to the ranks whose rows they lie in.
class EdgeExchange {
public:
    virtual ~EdgeExchange() = default;

    /// Collective. The edges in all rows of the picture, from those in each rank's own. Cost: a bit a pixel to all.
    virtual EdgeMask gather(const EdgeMask& mine) = 0;

    /// Collective. Sends what this rank's piece shows to the ranks whose rows the pixels lie in. Returns what all have
    /// sent for this rank's rows, one after the other.
    virtual std::vector<EdgePixelSeen> exchange(const std::vector<EdgePixelSeen>& mine) = 0;
};

}  // namespace aeolic
