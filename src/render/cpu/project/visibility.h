#pragma once

#include <cstdint>
#include <vector>

#include "render/cpu/project/clip.h"
#include "render/cpu/project/raster.h"
#include "render/cpu/project/scene_arrays.h"
#include "render/cpu/project/transform.h"
#include "render/view.h"

namespace aeolic::cpu {

struct TileSides {
    bool left = false, right = false, upper = false, lower = false;
};

/// Sorts triangles into tiles of the image and draws them tile by tile (visibility first, architecture.md decision 3).
/// Memory is kept between frames.
class Visibility {
public:
    /// Local. Projects the triangles of `part` and finds what falls into which tile of `scissor` (global pixels).
    void bin(const SceneArrays& arrays, const View& view, const Extent& scissor, const GroupPart& part = {});

    int tiles() const { return tilesX_ * tilesY_; }
    Extent tileExtent(int tile) const;  ///< Global pixels, clipped to the scissor.
    /// Which sides of it lie at one of its eight neighbours that are marked in `tiles`, [tiles()]; a corner counts for
    /// its upper or lower side.
    TileSides marksBeside(int tile, const std::vector<char>& tiles) const;

    /// Whether a triangle that `marks`, [triangles], is not 0 for falls into the tile.
    bool hasAny(int tile, const std::vector<std::uint32_t>& marks) const;

    /// Local. Draws one tile; any number of tiles may be drawn at once. False: nothing is visible and `keys` is
    /// unspecified.
    bool draw(int tile, TileKeys& keys) const;

private:
    struct Chunk {
        std::vector<TriangleBox> boxes;
        std::vector<std::uint32_t> unsafe;
        std::vector<std::uint32_t> count;  // Per list: first how many, then where the next goes.
    };
    void clipUnsafe(Chunk& chunk);
    /// Which triangles are the nearer ones, those that run clockwise or the others.
    std::int32_t nearerFacing(std::size_t chunks) const;
    /// Calls visit(list) for the list of each tile that the box meets.
    template <class Visit>
    void forEachList(const TriangleBox& box, Visit visit) const;
    void drawTriangles(std::uint32_t begin, std::uint32_t end, const Extent& extent, const TileDepths* drawn,
                       TileKeys& keys) const;

    const SceneArrays* arrays_ = nullptr;
    View view_;
    Extent scissor_;
    int tilesX_ = 0, tilesY_ = 0;
    VisibleGroups visible_;
    ScreenVertices screen_;
    std::vector<Chunk> chunks_;
    std::vector<ClippedTriangle> clipped_;
    std::int32_t nearer_ = 0;  // Facing of the triangles that are drawn first.
    std::vector<std::uint32_t>
        listStart_;  // [2 tiles + 1] into tileTriangles_: of each tile the nearer ones, the others.
    std::vector<std::uint32_t> tileTriangles_;
};

}  // namespace aeolic::cpu
