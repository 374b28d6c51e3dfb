#include "render/gl/lic/near_tiles.h"

#include "render/gl/device/dispatch.h"
#include "render/gl/device/gl_blocks.h"
#include "render/limits.h"

namespace aeolic::gl {
namespace {

static_assert(kNearTile >= limits::kNearPx, "neighbours of tiles with flow hold what traces look at");

/// How a TileList (tile_list.comp) begins: two dispatches' arguments and the count.
constexpr GLuint kListHead[12] = {0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 0, 0};

}  // namespace

void NearTiles::find(Programs& programs, const FrameImages& images, int y0, int y1)
{
    const int width = images.valid.width(), height = images.valid.height();
    const int tilesX = (width + kNearTile - 1) / kNearTile, tilesY = (height + kNearTile - 1) / kNearTile;
    const TilingBlock block{{width, height}, {tilesX, tilesY}, {y0, y1}, {}};
    if (tiling_.bytes() == 0) tiling_ = Buffer(sizeof block, GL_DYNAMIC_STORAGE_BIT);
    if (noTiles_.bytes() == 0) noTiles_ = Buffer(sizeof kListHead, 0, kListHead);
    tiling_.write(0, sizeof block, &block);
    const auto tiles = std::size_t(tilesX) * std::size_t(tilesY);
    flags_.reserve(tiles * 4);
    list_.reserve(sizeof kListHead + tiles * 4).begin(noTiles_);
    bindUniforms(kTilingBinding, tiling_);
    bindStorage(0, flags_.get());
    bindStorage(1, list_.get());
    if (tiles == 0) return;
    images.flow.bind(0);
    dispatch(programs.compute("tile_flags"), GLuint(tilesX), GLuint(tilesY));
    dispatch(programs.compute("tile_list"), GLuint((tiles + 63) / 64));
}

void NearTiles::run(GLuint program, int y0, int y1, int directions) const
{
    if (y0 >= y1) return;
    setInts(program, 0, y0, y1);
    bindUniforms(kTilingBinding, tiling_);
    bindStorage(1, list_.get());
    dispatchIndirect(program, list_.get(), directions == 2 ? 16 : 0);
}

}  // namespace aeolic::gl
