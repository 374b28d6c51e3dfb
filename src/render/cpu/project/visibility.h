#pragma once

#include <cstdint>
#include <vector>

#include "render/cpu/project/found_triangles.h"
#include "render/cpu/project/raster/clip.h"
#include "render/cpu/project/raster/raster.h"
#include "render/cpu/project/raster/transform.h"
#include "render/cpu/project/sample_triangles.h"
#include "render/cpu/project/scene_arrays.h"
#include "render/view.h"

namespace aeolic::cpu {

struct TileSides {
    bool left = false, right = false, upper = false, lower = false;
};

/// Sorts triangles into tiles of the image and draws them tile by tile: visibility comes first
/// (docs/decisions/0003-deferred-projection.md). Memory is kept between frames.
class Visibility {
public:
    /// Local. Projects the triangles of `part` and finds what falls into which tile of `scissor` (global pixels).
    void bin(const SceneArrays& arrays, const View& view, const Extent& scissor, const GroupPart& part = {});
    /// Local. The triangles that may cover a sample of a pixel of `edges`. Nothing is projected again that the call
    /// before has projected for the same view.
    void binEdges(const SceneArrays& arrays, const View& view, const Extent& scissor, const EdgeMask& edges);

    /// Local. The tiles of `scissor`, without any triangles.
    void layTiles(const Extent& scissor);

    const Extent& scissor() const { return scissor_; }
    int tiles() const { return tilesX_ * tilesY_; }
    Extent tileExtent(int tile) const;  ///< Global pixels, clipped to the scissor.
    int tileAt(int x, int y) const;     ///< The tile of a pixel of the scissor.
    /// Which sides of it lie at one of its eight neighbours that are marked in `tiles`, [tiles()]; a corner counts for
    /// its upper or lower side.
    TileSides marksBeside(int tile, const std::vector<char>& tiles) const;

    /// Whether a triangle that `marks`, [triangles], is not 0 for falls into the tile.
    bool hasAny(int tile, const std::vector<std::uint32_t>& marks) const;

    /// Local. Draws one tile; any number of tiles may be drawn at once. False: nothing is visible and `keys` is
    /// unspecified.
    bool draw(int tile, TileKeys& keys) const;
    /// Local. Where triangles were chosen by edges: draws the samples of a tile's edge pixels, which are all
    /// background.
    void drawEdges(int tile, SampleKeys& out) const;

private:
    struct Chunk {
        std::vector<TriangleBox> atEdges;
        std::vector<std::uint32_t> count;  // Per list: first how many, then where the next goes.
    };
    /// Clips triangles that need it. `margin`: so many sub-pixels beside a pixel's centre a piece still counts.
    void clipUnsafe(int margin);
    /// Sorts the triangles of boxesOf(chunk) of each chunk into the tiles' lists, and the clipped pieces.
    template <class BoxesOf>
    void sortIntoTiles(const BoxesOf& boxesOf);
    /// Which triangles are the nearer ones, those that run clockwise or the others.
    std::int32_t nearerFacing() const;
    /// Calls visit(list) for the list of each tile that the box meets.
    template <class Visit>
    void forEachList(const TriangleBox& box, Visit visit) const;
    DrawRule rule() const { return {view_.farInvDepth, view_.frontFacesOnly}; }
    /// Calls whole(ids) for runs of triangles [begin, end) of the lists, and piece() for clipped pieces.
    template <class Whole, class Piece>
    void forEachOf(std::uint32_t begin, std::uint32_t end, const Whole& whole, const Piece& piece) const;

    const SceneArrays* arrays_ = nullptr;
    View view_;
    Extent scissor_;
    int tilesX_ = 0, tilesY_ = 0;
    FoundTriangles found_;
    std::vector<Chunk> chunks_;
    std::vector<ClippedTriangle> clipped_;
    std::vector<TriangleBox> clippedBoxes_;
    std::int32_t nearer_ = 0;  // Facing of the triangles that are drawn first.
    std::vector<std::uint32_t>
        listStart_;  // [2 tiles + 1] into tileTriangles_: of each tile the nearer ones, the others.
    std::vector<std::uint32_t> tileTriangles_;
};

}  // namespace aeolic::cpu
