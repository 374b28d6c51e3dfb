#include "render/cpu/edges/edge_stage.h"

#include <algorithm>
#include <cstring>

#include "base/parallel.h"
#include "render/cpu/edges/find_edges.h"

namespace aeolic::cpu {

void EdgeStage::shadeBeside(const EdgeScene& scene, const Extent& compute)
{
    if (compute.empty()) return;
    const Extent& valid = scene.buffer.valid();
    const auto shadeRow = [&](int y, Tile& row) {
        if (y < valid.y0 || y >= valid.y1) return;
        row.resize({valid.x0, y, valid.x1, y + 1});
        shadeRows(scene, row.extent, row);
    };
    shadeRow(compute.y0 - 1, above_);
    shadeRow(compute.y1, below_);
}

void EdgeStage::findPixels(const Visibility& visibility)
{
    const auto tiles = std::size_t(visibility.tiles());
    pixels_.resize(std::max(pixels_.size(), tiles));
    parallelFor(tiles, [&](std::size_t i) { pixels_[i].find(mask_, visibility.tileExtent(int(i))); });
    before_.assign(tiles + 1, 0);
    for (std::size_t i = 0; i < tiles; ++i) before_[i + 1] = before_[i] + pixels_[i].count();
}

void EdgeStage::takeNearest(const Visibility& visibility, const std::vector<EdgePixelSeen>& seen)
{
    std::vector<EdgeSample> nearest(std::size_t(before_.back()) * antialias::kSamples);
    for (const EdgePixelSeen& pixel : seen) {
        const int tile = visibility.tileAt(pixel.x, pixel.y);
        const std::optional<std::uint32_t> own = pixels_[std::size_t(tile)].at(pixel.x, pixel.y);
        if (!own) continue;
        const std::size_t number = before_[std::size_t(tile)] + *own;
        for (std::size_t s = 0; s < std::size_t(antialias::kSamples); ++s) {
            EdgeSample& best = nearest[number * antialias::kSamples + s];
            if (pixel.samples[s].hides(best)) best = pixel.samples[s];
        }
    }
    nearest_.resize(before_.back());
    for (std::size_t i = 0; i < nearest.size(); ++i) {
        nearest_.invDepth[i] = nearest[i].invDepth;
        nearest_.gradX[i] = nearest[i].gradX;
        nearest_.gradY[i] = nearest[i].gradY;
        nearest_.light[i] = nearest[i].light;
    }
}

void EdgeStage::composite(const EdgeScene& scene, Visibility& visibility, const Extent& compute, EdgeExchange& pieces)
{
    const EdgeMask all = pieces.gather(mask_);
    visibility.binEdges(scene.arrays, scene.view, all.rows, all);
    const std::vector<EdgePixelSeen> seen = pieces.exchange(seenInEdges(visibility, all, scene.arrays, scene.view));
    visibility.layTiles(compute);
    findPixels(visibility);
    takeNearest(visibility, seen);
}

void EdgeStage::run(const EdgeScene& scene, Visibility& visibility, const Extent& compute, Tile& out,
                    EdgeExchange* pieces)
{
    findEdges(scene.view, scene.buffer, scene.palette.lighting, compute, mask_);
    shadeBeside(scene, compute);
    if (pieces) {
        composite(scene, visibility, compute, *pieces);
    } else {
        visibility.binEdges(scene.arrays, scene.view, compute, mask_);
        findPixels(visibility);
    }
    colors_.resize(before_.back());
    const auto forEachTile = [&](const auto& visit) {
        parallelFor(before_.size() - 1, [&](std::size_t i) {
            if (before_[i] != before_[i + 1]) visit(i, pixels_[i]);
        });
    };
    // Colours are looked up in neighbours: none may be replaced before all are found.
    const ShownRows shown{compute, &out, &above_, &below_};
    forEachTile([&](std::size_t i, const EdgePixels& pixels) {
        if (pieces) return mixEdges(pixels, nearest_, before_[i], scene, shown, &colors_[before_[i]]);
        thread_local EdgeSamples samples;
        drawSamples(visibility, int(i), pixels, scene.arrays, scene.view, samples);
        mixEdges(pixels, samples, 0, scene, shown, &colors_[before_[i]]);
    });
    forEachTile([&](std::size_t i, const EdgePixels& pixels) {
        for (std::size_t k = 0; k < pixels.count(); ++k)
            std::memcpy(out.row(pixels.y()[k]) + 4 * std::ptrdiff_t(pixels.x()[k] - out.extent.x0),
                        &colors_[before_[i] + k], 4);
    });
}

}  // namespace aeolic::cpu
