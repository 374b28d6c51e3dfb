#include "render/cpu/project/raster/coverage.h"

#include "base/parallel.h"

namespace aeolic::cpu {

CoverageBits& CoverageCount::draw(const SceneArrays& arrays, const View& view, int part, int parts)
{
    const Extent whole{0, 0, view.camera.width, view.camera.height};
    bits_.clear(whole.width(), whole.height());
    visibility_.bin(arrays, view, whole, {std::size_t(part), std::size_t(parts)});
    parallelFor(std::size_t(visibility_.tiles()), [&](std::size_t i) {
        TileKeys keys;
        if (!visibility_.draw(int(i), keys)) return;
        const Extent tile = visibility_.tileExtent(int(i));
        static_assert(TileKeys::kSize == 64, "a row of a tile is a word");
        for (int y = tile.y0; y < tile.y1; ++y) {
            std::uint64_t word = 0;
            for (int x = 0; x < tile.width(); ++x) word |= std::uint64_t(keys.key[y - tile.y0][x] != 0) << x;
            bits_.words[std::size_t(y) * bits_.wordsPerRow + std::size_t(tile.x0 / TileKeys::kSize)] = word;
        }
    });
    return bits_;
}

}  // namespace aeolic::cpu
