#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "data/mesh/surface_mesh.h"
#include "render/cpu/project/edge_pixels.h"
#include "render/cpu/project/raster/raster.h"
#include "render/cpu/project/raster/transform.h"

namespace aeolic::cpu {

/// What triangles are drawn into: the samples of a tile's edge pixels. Memory is kept from tile to tile.
class SampleKeys {
public:
    /// All background. `pixels` must outlive its use.
    void clear(const EdgePixels& pixels);

    const EdgePixels& pixels() const { return *pixels_; }
    /// The two halves of keys as TileKeys has them, [pixels().count()][kSamples], then a vector of anything. A vector
    /// of halves holds twice as many samples as one of keys.
    float* depths() { return depths_.data(); }
    const float* depths() const { return depths_.data(); }
    std::uint32_t* complements() { return complements_.data(); }
    const std::uint32_t* complements() const { return complements_.data(); }
    std::uint64_t key(std::size_t at) const
    {
        return std::uint64_t{std::bit_cast<std::uint32_t>(depths_[at])} << 32 | complements_[at];
    }
    /// Of each pixel: 1/depth that all of its samples show something as near as; 0 where one may show nothing.
    float* farthest() { return farthest_.data(); }
    /// Brings them up to the triangles drawn.
    void findFarthest();

private:
    const EdgePixels* pixels_ = nullptr;
    std::vector<float> depths_, farthest_;
    std::vector<std::uint32_t> complements_;
};

/// Draws triangles into samples by drawTriangle()'s rules. Local. Cost: 40 ns a triangle, and 10 ns for each edge pixel
/// that it may show in.
void sampleTriangles(const SurfaceMesh& mesh, const ScreenVertices& screen, std::span<const std::uint32_t> ids,
                     const DrawRule& rule, SampleKeys& out);

/// One triangle, of any size.
void sampleTriangle(const Corner& a, const Corner& b, const Corner& c, std::uint32_t id, const DrawRule& rule,
                    SampleKeys& out);

}  // namespace aeolic::cpu
