#include "render/cpu/visibility.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/parallel.h"

namespace aeolic::cpu {
namespace {

constexpr std::size_t kMaxChunks = 64;  // Enough to keep many cores busy, few enough that per-tile counts stay small.
constexpr std::size_t kMinChunkTriangles = 2048;

}  // namespace

Extent Visibility::tileExtent(int tile) const
{
    const int x0 = scissor_.x0 + tile % tilesX_ * TileKeys::kSize, y0 = scissor_.y0 + tile / tilesX_ * TileKeys::kSize;
    return {x0, y0, std::min(x0 + TileKeys::kSize, scissor_.x1), std::min(y0 + TileKeys::kSize, scissor_.y1)};
}

template <class Visit>
void Visibility::forEachTile(const TriangleBox& box, Visit visit) const
{
    const int tx0 = (box.x0 - scissor_.x0) / TileKeys::kSize, tx1 = (box.x1 - 1 - scissor_.x0) / TileKeys::kSize;
    const int ty0 = (box.y0 - scissor_.y0) / TileKeys::kSize, ty1 = (box.y1 - 1 - scissor_.y0) / TileKeys::kSize;
    for (int ty = ty0; ty <= ty1; ++ty)
        for (int tx = tx0; tx <= tx1; ++tx) visit(std::size_t(ty * tilesX_ + tx));
}

void Visibility::clipUnsafe(Chunk& chunk)
{
    const SurfaceMesh& mesh = arrays_->scene->surface;
    for (const std::uint32_t id : chunk.unsafe) {
        for (const ClippedTriangle& piece : clippedPieces(mesh, view_, id)) {
            TriangleBox box = boxOf(piece, scissor_);
            if (box.x0 >= box.x1 || box.y0 >= box.y1) continue;
            box.id = std::uint32_t(mesh.triangles.size() + clipped_.size());
            clipped_.push_back(piece);
            chunk.boxes.push_back(box);
        }
    }
}

void Visibility::bin(const SceneArrays& arrays, const View& view, const Extent& scissor)
{
    arrays_ = &arrays;
    view_ = view;
    scissor_ = scissor;
    tilesX_ = (scissor.width() + TileKeys::kSize - 1) / TileKeys::kSize;
    tilesY_ = (scissor.height() + TileKeys::kSize - 1) / TileKeys::kSize;
    const std::size_t tiles = std::size_t(tilesX_) * std::size_t(tilesY_);
    transformVertices(arrays, view, screen_);

    const std::size_t count = arrays.scene->surface.triangles.size();
    const std::size_t chunks = std::clamp<std::size_t>(count / kMinChunkTriangles, 1, kMaxChunks);
    chunks_.resize(std::max(chunks_.size(), chunks));
    parallelFor(chunks, [&](std::size_t i) {
        Chunk& chunk = chunks_[i];
        chunk.boxes.clear();
        chunk.unsafe.clear();
        setUpTriangles(arrays, screen_, count * i / chunks, count * (i + 1) / chunks, scissor, chunk.boxes,
                       chunk.unsafe);
    });
    clipped_.clear();
    for (std::size_t i = 0; i < chunks; ++i)
        clipUnsafe(chunks_[i]);  // Rare and short: only what straddles the near plane.

    // A counting sort by tile; chunk after chunk within a tile, so the order is the triangles'.
    parallelFor(chunks, [&](std::size_t i) {
        chunks_[i].tileCount.assign(tiles, 0);
        for (const TriangleBox& box : chunks_[i].boxes)
            forEachTile(box, [&](std::size_t tile) { ++chunks_[i].tileCount[tile]; });
    });
    tileStart_.resize(tiles + 1);
    std::uint32_t total = 0;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        tileStart_[tile] = total;
        for (std::size_t i = 0; i < chunks; ++i) total += std::exchange(chunks_[i].tileCount[tile], total);
    }
    tileStart_[tiles] = total;
    if (tileTriangles_.size() < total) tileTriangles_.resize(total);
    parallelFor(chunks, [&](std::size_t i) {
        for (const TriangleBox& box : chunks_[i].boxes)
            forEachTile(box, [&](std::size_t tile) { tileTriangles_[chunks_[i].tileCount[tile]++] = box.id; });
    });
}

bool Visibility::draw(int tile, TileKeys& keys) const
{
    const std::uint32_t begin = tileStart_[std::size_t(tile)], end = tileStart_[std::size_t(tile) + 1];
    if (begin == end) return false;
    const Extent extent = tileExtent(tile);
    std::memset(&keys, 0, sizeof keys);
    const SurfaceMesh& mesh = arrays_->scene->surface;
    const std::size_t count = mesh.triangles.size();
    for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t id = tileTriangles_[i];
        if (id < count) {
            const auto& t = mesh.triangles[id];
            const auto corner = [&](std::size_t k) {
                return Corner{screen_.x[t[k]], screen_.y[t[k]], screen_.invDepth[t[k]]};
            };
            drawTriangle(corner(0), corner(1), corner(2), id, extent, view_.farInvDepth, keys);
        } else {
            const ClippedTriangle& t = clipped_[id - count];
            const auto corner = [&](int k) { return Corner{t.x[k], t.y[k], t.invDepth[k]}; };
            drawTriangle(corner(0), corner(1), corner(2), t.original, extent, view_.farInvDepth, keys);
        }
    }
    return true;
}

}  // namespace aeolic::cpu
