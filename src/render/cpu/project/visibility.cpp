#include "render/cpu/project/visibility.h"

#include <algorithm>

#include <cstring>
#include <optional>
#include <span>
#include <utility>

#include "base/parallel.h"
#include "render/cpu/project/raster/draw_triangles.h"
#include "render/cpu/project/raster/triangle_rows.h"
#include "render/cpu/simd/prefetch.h"

namespace aeolic::cpu {
namespace {

/// Asks for what resolving reads of triangles that may be visible.
AEOLIC_PREFETCH void prefetchCorners(std::span<const std::uint32_t> triangles, const SceneArrays& arrays)
{
    for (const std::uint32_t id : triangles) {
        __builtin_prefetch(&arrays.corners[id]);
        for (const std::uint32_t point : arrays.scene->surface.triangles[id])
            __builtin_prefetch(&arrays.vertices[point]);
    }
}

}  // namespace

Extent Visibility::tileExtent(int tile) const
{
    const int x0 = scissor_.x0 + tile % tilesX_ * TileKeys::kSize, y0 = scissor_.y0 + tile / tilesX_ * TileKeys::kSize;
    return {x0, y0, std::min(x0 + TileKeys::kSize, scissor_.x1), std::min(y0 + TileKeys::kSize, scissor_.y1)};
}

int Visibility::tileAt(int x, int y) const
{
    return (y - scissor_.y0) / TileKeys::kSize * tilesX_ + (x - scissor_.x0) / TileKeys::kSize;
}

TileSides Visibility::marksBeside(int tile, const std::vector<char>& tiles) const
{
    const int column = tile % tilesX_, row = tile / tilesX_;
    const auto anyMarked = [&](int y, int x0, int x1) {
        if (y < 0 || y >= tilesY_) return false;
        const auto first = tiles.begin() + std::ptrdiff_t(y) * tilesX_;
        return std::find(first + std::max(x0, 0), first + std::min(x1, tilesX_), 1) != first + std::min(x1, tilesX_);
    };
    return {column > 0 && anyMarked(row, column - 1, column),
            column + 1 < tilesX_ && anyMarked(row, column + 1, column + 2), anyMarked(row - 1, column - 1, column + 2),
            anyMarked(row + 1, column - 1, column + 2)};
}

std::int32_t Visibility::nearerFacing() const
{
    // Where a surface is closed and all its triangles are oriented alike, one kind is in front of the other. Some tell
    // which; where there is no such order neither kind is the better one to begin with.
    constexpr std::size_t kSamples = 64;
    double sum[2] = {}, count[2] = {};
    const auto& triangles = arrays_->scene->surface.triangles;
    const ScreenVertices& screen = found_.screen();
    for (std::size_t c = 0; c < found_.chunks(); ++c) {
        const std::vector<TriangleBox>& boxes = found_.boxes(c);
        for (std::size_t i = 0; i < boxes.size(); i += boxes.size() / kSamples + 1) {
            sum[boxes[i].facing] += double(screen[triangles[boxes[i].id][0]].invDepth);
            ++count[boxes[i].facing];
        }
    }
    return sum[1] * count[0] > sum[0] * count[1];
}

template <class Visit>
void Visibility::forEachList(const TriangleBox& box, Visit visit) const
{
    const auto tileOf = [](int pixel, int first) { return unsigned(pixel - first) / unsigned(TileKeys::kSize); };
    const unsigned tx0 = tileOf(box.x0, scissor_.x0), tx1 = tileOf(box.x1 - 1, scissor_.x0);
    const unsigned ty0 = tileOf(box.y0, scissor_.y0), ty1 = tileOf(box.y1 - 1, scissor_.y0);
    const auto listOf = [&](unsigned tx, unsigned ty) {
        return 2 * (ty * unsigned(tilesX_) + tx) + unsigned(box.facing != nearer_);
    };
    if (tx0 == tx1 && ty0 == ty1) return visit(listOf(tx0, ty0));  // Most of small ones.
    for (unsigned ty = ty0; ty <= ty1; ++ty)
        for (unsigned tx = tx0; tx <= tx1; ++tx) visit(listOf(tx, ty));
}

void Visibility::clipUnsafe(int margin)
{
    const SurfaceMesh& mesh = arrays_->scene->surface;
    clipped_.clear();
    clippedBoxes_.clear();
    for (std::size_t i = 0; i < found_.chunks(); ++i)  // Rare and short: only what straddles the near plane.
        for (const std::uint32_t id : found_.unsafe(i)) {
            for (const ClippedTriangle& piece : clippedPieces(mesh, view_, id)) {
                const auto& [a, b, c] = piece.corners;
                const Extent box = pixelsOver(a, b, c, margin, scissor_);
                if (box.empty()) continue;
                const auto number = std::uint32_t(mesh.triangles.size() + clipped_.size());
                clippedBoxes_.push_back({number, box.x0, box.y0, box.x1, box.y1});
                clipped_.push_back(piece);
            }
        }
}

void Visibility::layTiles(const Extent& scissor)
{
    scissor_ = scissor;
    tilesX_ = (scissor.width() + TileKeys::kSize - 1) / TileKeys::kSize;
    tilesY_ = (scissor.height() + TileKeys::kSize - 1) / TileKeys::kSize;
}

void Visibility::bin(const SceneArrays& arrays, const View& view, const Extent& scissor, const GroupPart& part)
{
    arrays_ = &arrays;
    view_ = view;
    layTiles(scissor);
    found_.find(arrays, view, scissor, part);
    nearer_ = nearerFacing();
    clipUnsafe(0);
    sortIntoTiles([&](std::size_t i) -> const std::vector<TriangleBox>& { return found_.boxes(i); });
}

void Visibility::binEdges(const SceneArrays& arrays, const View& view, const Extent& scissor, const EdgeMask& edges)
{
    if (!found_.has(arrays, view, scissor)) bin(arrays, view, scissor);
    arrays_ = &arrays;
    view_ = view;
    layTiles(scissor);
    chunks_.resize(std::max(chunks_.size(), found_.chunks()));
    const MarkedBoxes marked(edges);
    parallelFor(found_.chunks(), [&](std::size_t i) {
        chunks_[i].atEdges.clear();
        found_.findMarked(i, marked, scissor, chunks_[i].atEdges);
    });
    clipUnsafe(kSampleMargin);
    sortIntoTiles([&](std::size_t i) -> const std::vector<TriangleBox>& { return chunks_[i].atEdges; });
}

template <class BoxesOf>
void Visibility::sortIntoTiles(const BoxesOf& boxesOf)
{
    // A counting sort by list; chunk after chunk within a list, so the order is the triangles'. What is clipped is the
    // last chunk.
    const std::size_t lists = 2 * std::size_t(tilesX_) * std::size_t(tilesY_), chunks = found_.chunks() + 1;
    const auto boxes = [&](std::size_t i) -> const std::vector<TriangleBox>& {
        return i < found_.chunks() ? boxesOf(i) : clippedBoxes_;
    };
    chunks_.resize(std::max(chunks_.size(), chunks));
    parallelFor(chunks, [&](std::size_t i) {
        chunks_[i].count.assign(lists, 0);
        for (const TriangleBox& box : boxes(i)) forEachList(box, [&](std::size_t list) { ++chunks_[i].count[list]; });
    });
    listStart_.resize(lists + 1);
    std::uint32_t total = 0;
    for (std::size_t list = 0; list < lists; ++list) {
        listStart_[list] = total;
        for (std::size_t i = 0; i < chunks; ++i) total += std::exchange(chunks_[i].count[list], total);
    }
    listStart_[lists] = total;
    if (tileTriangles_.size() < total) tileTriangles_.resize(total);
    parallelFor(chunks, [&](std::size_t i) {
        for (const TriangleBox& box : boxes(i))
            forEachList(box, [&](std::size_t list) { tileTriangles_[chunks_[i].count[list]++] = box.id; });
    });
}

bool Visibility::hasAny(int tile, const std::vector<std::uint32_t>& marks) const
{
    const std::uint32_t* list = &listStart_[2 * std::size_t(tile)];
    return std::any_of(tileTriangles_.begin() + list[0], tileTriangles_.begin() + list[2], [&](std::uint32_t id) {
        return marks[id < marks.size() ? id : clipped_[id - marks.size()].original] != 0;
    });
}

template <class Whole, class Piece>
void Visibility::forEachOf(std::uint32_t begin, std::uint32_t end, const Whole& whole, const Piece& piece) const
{
    const std::size_t count = arrays_->scene->surface.triangles.size();
    const auto last = tileTriangles_.begin() + end;
    const auto isWhole = [&](std::uint32_t id) { return id < count; };
    for (auto at = tileTriangles_.begin() + begin; at != last;) {
        const auto clipped = std::find_if_not(at, last, isWhole);
        if (at != clipped) whole(std::span<const std::uint32_t>{at, clipped});
        at = std::find_if(clipped, last, isWhole);
        for (auto i = clipped; i != at; ++i) piece(clipped_[*i - count]);
    }
}

bool Visibility::draw(int tile, TileKeys& keys) const
{
    constexpr std::uint32_t kWorthTesting = 64;  // Triangles; with fewer, finding the depths costs more than it saves.
    const std::uint32_t* list = &listStart_[2 * std::size_t(tile)];
    if (list[0] == list[2]) return false;
    const Extent extent = tileExtent(tile);
    const auto drawList = [&](std::uint32_t begin, std::uint32_t end, const TileDepths* drawn) {
        forEachOf(
            begin, end,
            [&](std::span<const std::uint32_t> ids) {
                drawTriangles(arrays_->scene->surface, found_.screen(), ids, extent, rule(), drawn, keys);
                if (!drawn) prefetchCorners(ids, *arrays_);
            },
            [&](const ClippedTriangle& piece) {
                const auto& [a, b, c] = piece.corners;
                drawTriangle(a, b, c, piece.original, extent, rule(), drawn, keys);
            });
    };
    std::memset(&keys, 0, sizeof keys);
    drawList(list[0], list[1], nullptr);
    std::optional<TileDepths> drawn;
    if (list[2] - list[1] >= kWorthTesting) drawn = farthestDepths(keys);
    drawList(list[1], list[2], drawn ? &*drawn : nullptr);
    return true;
}

void Visibility::drawEdges(int tile, SampleKeys& out) const
{
    const auto drawList = [&](std::uint32_t begin, std::uint32_t end) {
        forEachOf(
            begin, end,
            [&](std::span<const std::uint32_t> ids) {
                sampleTriangles(arrays_->scene->surface, found_.screen(), ids, rule(), out);
            },
            [&](const ClippedTriangle& piece) {
                const auto& [a, b, c] = piece.corners;
                sampleTriangle(a, b, c, piece.original, rule(), out);
            });
    };
    const std::uint32_t* list = &listStart_[2 * std::size_t(tile)];
    constexpr std::uint32_t kOften = 200;  // Triangles; finding the depths costs as much as drawing some ten.
    for (std::uint32_t at = list[0]; at < list[2]; at += kOften) {
        if (at != list[0]) out.findFarthest();
        drawList(at, std::min(at + kOften, list[2]));
    }
}

}  // namespace aeolic::cpu
