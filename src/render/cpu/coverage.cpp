#include "render/cpu/coverage.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <utility>

#include "base/parallel.h"
#include "render/cpu/clipped_triangle.h"

namespace aeolic::cpu {
namespace {

constexpr std::size_t kChunkTriangles = 8192;

/// Twice the signed area of a, b and (x, y); exact.
template <class Point>
std::int64_t cross(const Point& a, const Point& b, std::int64_t x, std::int64_t y)
{
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

std::int64_t floorDivide(std::int64_t a, std::int64_t positive)
{
    return a >= 0 ? a / positive : -((positive - 1 - a) / positive);
}

/// Bits [from, to) of a word, 0 <= from < to <= 64.
std::uint64_t bits(int from, int to)
{
    return (~std::uint64_t{0} >> (64 - (to - from))) << from;
}

}  // namespace

bool CoverageCount::isMarked(int y, int x0, int x1) const
{
    const std::uint64_t* row = &words_[std::size_t(y) * wordsPerRow_];
    for (int x = x0; x < x1; x = (x | 63) + 1) {
        const std::uint64_t wanted = bits(x & 63, std::min(x1 - (x & ~63), 64));
        // Other threads set bits meanwhile; whichever is seen, the bits in the end are the same.
        const std::uint64_t word =
            std::atomic_ref(const_cast<std::uint64_t&>(row[x >> 6])).load(std::memory_order_relaxed);
        if ((word & wanted) != wanted) return false;
    }
    return true;
}

void CoverageCount::mark(int y, int x0, int x1)
{
    std::uint64_t* row = &words_[std::size_t(y) * wordsPerRow_];
    for (int x = x0; x < x1; x = (x | 63) + 1)
        std::atomic_ref(row[x >> 6]).fetch_or(bits(x & 63, std::min(x1 - (x & ~63), 64)), std::memory_order_relaxed);
}

void CoverageCount::drawTriangle(Point a, Point b, Point c, const TriangleBox& box)
{
    const std::int64_t doubleArea = cross(a, b, c.x, c.y);
    if (doubleArea == 0) return;
    if (doubleArea < 0) std::swap(b, c);
    const std::int64_t px = std::int64_t(box.x0) * kSubpixels + kSubpixels / 2;
    const Point corners[3] = {a, b, c};
    for (int y = box.y0; y < box.y1; ++y) {
        if (isMarked(y, box.x0, box.x1)) continue;
        const std::int64_t py = std::int64_t(y) * kSubpixels + kSubpixels / 2;
        // Inside is where all three edge functions are at least 0; each is linear along the row.
        std::int64_t first = 0, last = box.x1 - box.x0 - 1;
        for (int k = 0; k < 3 && first <= last; ++k) {
            const Point &p = corners[k], &q = corners[(k + 1) % 3];
            const std::int64_t edge = cross(p, q, px, py), perPixel = -(q.y - p.y) * kSubpixels;
            if (edge < 0 && perPixel <= 0) last = -1;
            if (edge < 0 && perPixel > 0) first = std::max(first, -floorDivide(edge, perPixel));
            if (edge >= 0 && perPixel < 0) last = std::min(last, floorDivide(edge, -perPixel));
        }
        if (first <= last) mark(y, box.x0 + int(first), box.x0 + int(last) + 1);
    }
}

void CoverageCount::drawChunk(const SceneArrays& arrays, const View& view, const Extent& whole, std::size_t begin,
                              std::size_t end, Chunk& chunk)
{
    chunk.boxes.clear();
    chunk.unsafe.clear();
    setUpTriangles(arrays, screen_, begin, end, whole, chunk.boxes, chunk.unsafe);
    const SurfaceMesh& mesh = arrays.scene->surface;
    for (const TriangleBox& box : chunk.boxes) {
        if (box.y1 - box.y0 == 1 && isMarked(box.y0, box.x0, box.x1)) continue;
        const auto& t = mesh.triangles[box.id];
        const auto point = [&](std::size_t k) { return Point{screen_.x[t[k]], screen_.y[t[k]]}; };
        drawTriangle(point(0), point(1), point(2), box);
    }
    for (const std::uint32_t id : chunk.unsafe)
        for (const ClippedTriangle& t : clippedPieces(mesh, view, id))
            drawTriangle({t.x[0], t.y[0]}, {t.x[1], t.y[1]}, {t.x[2], t.y[2]}, boxOf(t, whole));
}

std::vector<std::int64_t> CoverageCount::count(const SceneArrays& arrays, const View& view)
{
    const Extent whole{0, 0, view.camera.width, view.camera.height};
    wordsPerRow_ = std::size_t(whole.width() + 63) / 64;
    words_.assign(std::size_t(whole.height()) * wordsPerRow_, 0);
    transformVertices(arrays, view, screen_);
    const std::size_t triangles = arrays.scene->surface.triangles.size();
    const std::size_t chunks = (triangles + kChunkTriangles - 1) / kChunkTriangles;
    chunks_.resize(std::max(chunks_.size(), chunks));
    parallelFor(chunks, [&](std::size_t i) {
        drawChunk(arrays, view, whole, i * kChunkTriangles, std::min((i + 1) * kChunkTriangles, triangles), chunks_[i]);
    });
    std::vector<std::int64_t> covered(std::size_t(whole.height()), 0);
    parallelRanges(covered.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y)
            for (std::size_t i = 0; i < wordsPerRow_; ++i) covered[y] += std::popcount(words_[y * wordsPerRow_ + i]);
    });
    return covered;
}

}  // namespace aeolic::cpu
