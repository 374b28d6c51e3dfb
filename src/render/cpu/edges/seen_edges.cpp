#include "render/cpu/edges/seen_edges.h"

#include "base/parallel.h"

namespace aeolic::cpu {
namespace {

EdgeSample sampleOf(const EdgeSamples& samples, std::size_t at, const std::vector<std::uint64_t>& order)
{
    EdgeSample sample;
    const std::uint64_t key = samples.drawn.key(at);
    if (key == 0) return sample;
    sample.order = order[TileKeys::triangle(key)];
    sample.depth = std::uint32_t(key >> 32);
    sample.invDepth = samples.invDepth[at];
    sample.gradX = samples.gradX[at];
    sample.gradY = samples.gradY[at];
    sample.light = samples.light[at];
    return sample;
}

}  // namespace

void drawSamples(const Visibility& visibility, int tile, const EdgePixels& pixels, const EdgeScene& scene,
                 EdgeSamples& samples)
{
    samples.drawn.clear(pixels);
    visibility.drawEdges(tile, samples.drawn);
    resolveSamples(scene.arrays, scene.view, samples);
}

std::vector<EdgePixelSeen> seenInEdges(const Visibility& visibility, const EdgeMask& all, const EdgeScene& scene)
{
    std::vector<std::vector<EdgePixelSeen>> byTile(std::size_t(visibility.tiles()));
    parallelFor(byTile.size(), [&](std::size_t i) {
        thread_local EdgePixels pixels;
        pixels.find(all, visibility.tileExtent(int(i)));
        if (pixels.count() == 0) return;
        thread_local EdgeSamples samples;
        drawSamples(visibility, int(i), pixels, scene, samples);
        for (std::size_t number = 0; number < pixels.count(); ++number) {
            EdgePixelSeen seen{pixels.x()[number], pixels.y()[number], {}};
            bool any = false;
            for (std::size_t s = 0; s < std::size_t(antialias::kSamples); ++s) {
                seen.samples[s] =
                    sampleOf(samples, number * antialias::kSamples + s, scene.arrays.scene->surface.order);
                any = any || seen.samples[s].depth != 0;
            }
            if (any) byTile[i].push_back(seen);
        }
    });
    std::vector<EdgePixelSeen> seen;
    for (const auto& tile : byTile) seen.insert(seen.end(), tile.begin(), tile.end());
    return seen;
}

}  // namespace aeolic::cpu
