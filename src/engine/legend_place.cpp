#include "engine/legend_place.h"

#include <algorithm>
#include <optional>

#include "cluster/balance/row_coverage.h"
#include "render/cpu/project/raster/coverage.h"
#include "render/overlay/figure.h"

namespace aeolic {
namespace {

constexpr int mostSamples = 16;  // Of an orbit: a body turns by 22.5 degrees from one to the next.
constexpr int coarseRows = 160;

/// Pixels of [begin, end) in the coarse pixel `at`.
int overlap(int begin, int end, int at, int factor)
{
    return std::max(0, std::min(end, (at + 1) * factor) - std::max(begin, at * factor));
}

}  // namespace

std::int64_t coveredArea(const Box& box, const CoverageBits& bits, int factor)
{
    std::int64_t area = 0;
    const int y1 = std::min(bits.height, (box.bottom() - 1) / factor + 1), x1 = (box.right() - 1) / factor + 1;
    for (int y = box.y / factor; y < y1; ++y) {
        const std::uint64_t* row = &bits.words[std::size_t(y) * bits.wordsPerRow];
        std::int64_t columns = 0;
        for (int x = box.x / factor; x < x1; ++x)
            if (row[x / 64] >> (x % 64) & 1) columns += overlap(box.x, box.right(), x, factor);
        area += columns * overlap(box.y, box.bottom(), y, factor);
    }
    return area;
}

std::vector<int> sampledFrames(int frames)
{
    std::vector<int> sampled;
    const int count = std::min(frames, mostSamples);
    sampled.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i) sampled.push_back(int(std::int64_t(i) * frames / count));
    return sampled;
}

std::size_t steadyLegendPlace(const std::vector<Box>& places, const std::vector<View>& views, const Scene& scene,
                              Backend& backend, Communicator& ranks)
{
    if (places.size() < 2) return 0;
    const int part = scene.inPieces ? 0 : ranks.rank(), parts = scene.inPieces ? 1 : ranks.size();
    std::optional<cpu::SceneArrays> arrays;
    cpu::CoverageCount count;
    std::vector<std::int64_t> covered(places.size(), 0);
    for (const View& view : views) {
        const int factor = std::max(1, std::min(view.camera.width, view.camera.height) / coarseRows);
        CoverageBits* bits = backend.coverageOfPart(view, factor, part, parts);
        if (!bits) {  // A GPU counts rows alone, so the processor draws for it.
            if (!arrays) arrays.emplace(scene);
            bits = &count.draw(*arrays, coarseView(view, factor), part, parts);
        }
        uniteCoverage(ranks, *bits);
        for (std::size_t i = 0; i < places.size(); ++i) covered[i] += coveredArea(places[i], *bits, factor);
    }
    return freestPlace(covered);
}

}  // namespace aeolic
