#include "render/cpu/project/coverage.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "render/cpu/project/clip.h"
#include "render/cpu/project/cover_small.h"
#include "render/cpu/simd/shared_bits.h"

namespace aeolic::cpu {
namespace {

constexpr std::size_t kChunkGroups = 128;
constexpr int kNext[3] = {1, 2, 0};

}  // namespace

bool CoverageCount::isMarked(int y, int x0, int x1) const
{
    const std::uint64_t* row = &bits_.words[std::size_t(y) * bits_.wordsPerRow];
    for (int x = x0; x < x1; x = (x | 63) + 1)
        if (!hasBits(row[x >> 6], bitsBetween(x & 63, std::min(x1 - (x & ~63), 64)))) return false;
    return true;
}

void CoverageCount::mark(int y, int x0, int x1)
{
    std::uint64_t* row = &bits_.words[std::size_t(y) * bits_.wordsPerRow];
    for (int x = x0; x < x1; x = (x | 63) + 1) setBits(row[x >> 6], bitsBetween(x & 63, std::min(x1 - (x & ~63), 64)));
}

/// Where a row enters and leaves the triangle, by division.
void CoverageCount::drawRows(const Corners& t, const TriangleBox& box)
{
    const std::int64_t px = std::int64_t(box.x0) * kSubpixels + kSubpixels / 2,
                       py = std::int64_t(box.y0) * kSubpixels + kSubpixels / 2;
    std::int64_t edge[3], perPixel[3], perRow[3];
    for (int k = 0; k < 3; ++k) {
        const std::int64_t dx = std::int64_t(t.x[kNext[k]]) - t.x[k], dy = std::int64_t(t.y[kNext[k]]) - t.y[k];
        edge[k] = dx * (py - t.y[k]) - dy * (px - t.x[k]);
        perPixel[k] = -dy * kSubpixels;
        perRow[k] = dx * kSubpixels;
    }
    const auto nextRow = [&] {
        for (int k = 0; k < 3; ++k) edge[k] += perRow[k];
    };
    for (int y = box.y0; y < box.y1; ++y, nextRow()) {
        if (isMarked(y, box.x0, box.x1)) continue;
        // Inside is where all three edge functions are at least 0; each is linear along the row.
        std::int64_t first = 0, last = box.x1 - box.x0 - 1;
        for (int k = 0; k < 3; ++k) {
            if (edge[k] < 0)
                first = perPixel[k] > 0 ? std::max(first, (perPixel[k] - 1 - edge[k]) / perPixel[k]) : last + 1;
            else if (perPixel[k] < 0)
                last = std::min(last, edge[k] / -perPixel[k]);
        }
        if (first <= last) mark(y, box.x0 + int(first), box.x0 + int(last) + 1);
    }
}

void CoverageCount::drawTriangle(Corners t, const TriangleBox& box)
{
    const std::int64_t dx1 = std::int64_t(t.x[1]) - t.x[0], dy1 = std::int64_t(t.y[1]) - t.y[0];
    const std::int64_t dx2 = std::int64_t(t.x[2]) - t.x[0], dy2 = std::int64_t(t.y[2]) - t.y[0];
    const std::int64_t doubleArea = dx1 * dy2 - dy1 * dx2;
    if (doubleArea == 0) return;
    if (doubleArea < 0) {
        std::swap(t.x[1], t.x[2]);
        std::swap(t.y[1], t.y[2]);
    }
    drawRows(t, box);
}

void CoverageCount::drawRange(const SceneArrays& arrays, const View& view, const Extent& whole, std::size_t begin,
                              std::size_t end, Chunk& chunk)
{
    chunk.large.clear();
    chunk.unsafe.clear();
    coverSmall(arrays, screen_, begin, end, whole, bits_, chunk.large, chunk.unsafe);
    const SurfaceMesh& mesh = arrays.scene->surface;
    for (const TriangleBox& box : chunk.large) {
        const auto& t = mesh.triangles[box.id];
        drawTriangle(
            {{screen_.x[t[0]], screen_.x[t[1]], screen_.x[t[2]]}, {screen_.y[t[0]], screen_.y[t[1]], screen_.y[t[2]]}},
            box);
    }
    for (const std::uint32_t id : chunk.unsafe)
        for (const ClippedTriangle& t : clippedPieces(mesh, view, id)) {
            const TriangleBox box = boxOf(t, whole);
            if (box.x0 < box.x1) drawTriangle({{t.x[0], t.x[1], t.x[2]}, {t.y[0], t.y[1], t.y[2]}}, box);
        }
}

CoverageBits& CoverageCount::draw(const SceneArrays& arrays, const View& view, int part, int parts)
{
    const Extent whole{0, 0, view.camera.width, view.camera.height};
    bits_.clear(whole.width(), whole.height());
    const std::size_t groups = arrays.groups.size();
    visible_.find(arrays.groups, arrays.scene->surface.triangles.size(), view, whole,
                  {std::size_t(part), std::size_t(parts)});
    transformVertices(arrays, view, visible_, screen_);
    const std::size_t chunks = (groups + kChunkGroups - 1) / kChunkGroups;
    chunks_.resize(std::max(chunks_.size(), chunks));
    parallelFor(chunks, [&](std::size_t i) {
        visible_.forEachRange(
            i * kChunkGroups, std::min((i + 1) * kChunkGroups, groups),
            [&](std::size_t begin, std::size_t end) { drawRange(arrays, view, whole, begin, end, chunks_[i]); });
    });
    return bits_;
}

}  // namespace aeolic::cpu
