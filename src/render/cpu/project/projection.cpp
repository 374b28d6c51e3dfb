#include "render/cpu/project/projection.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/parallel.h"
#include "render/brick_image.h"
#include "render/cpu/project/links.h"
#include "render/cpu/project/resolve.h"
#include "render/cpu/simd/prefetch.h"
#include "render/lic/near_flow.h"

namespace aeolic::cpu {
namespace {

/// Makes the tile background in flow and links, which are what traces look at.
void clearFlow(const Extent& tile, GBuffer& out)
{
    constexpr int kRowsAhead = 8;
    for (int y = tile.y0; y < tile.y1; ++y) {
        if (y + kRowsAhead < tile.y1) {
            prefetchRowToWrite(out.flow, tile.x0, tile.x1, y + kRowsAhead);
            prefetchRowToWrite(out.links, tile.x0, tile.x1, y + kRowsAhead);
        }
        out.flow.fill({tile.x0, y, tile.x1, y + 1}, 0);
        out.links.fill({tile.x0, y, tile.x1, y + 1}, 0);
    }
}

void clearNear(const Extent& tile, const TileSides& surface, GBuffer& out)
{
    const int left = std::min(tile.x0 + NearFlow::kColumns, tile.x1),
              right = std::max(tile.x1 - NearFlow::kColumns, tile.x0),
              upper = std::min(tile.y0 + NearFlow::kRows, tile.y1),
              lower = std::max(tile.y1 - NearFlow::kRows, tile.y0);
    if (surface.upper) clearFlow({tile.x0, tile.y0, tile.x1, upper}, out);
    if (surface.lower) clearFlow({tile.x0, lower, tile.x1, tile.y1}, out);
    if (surface.left) clearFlow({tile.x0, tile.y0, left, tile.y1}, out);
    if (surface.right) clearFlow({right, tile.y0, tile.x1, tile.y1}, out);
}

/// Where edges are looked for in some row of the tile (edgeColumns()), and a tile more on either side.
ColumnSpan columnsAround(const Extent& tile, const Extent& rows, const GBuffer& out)
{
    ColumnSpan all;
    for (const int y : {tile.y0 - 1, tile.y0, tile.y1})
        if (y >= rows.y0 && y < rows.y1) all = all.with(out.surfaceColumns(y));
    return all.empty() ? all : ColumnSpan{all.x0 - TileKeys::kSize, all.x1 + TileKeys::kSize};
}

/// Writes background over `tile`: what later stages test of pixels. The other images are never read there.
void clearTile(const Extent& tile, GBuffer& out)
{
    out.invDepth.fill(tile, 0);
    out.flow.fill(tile, 0);
}

/// Local. `out.surface` of `rows`, those of the tiles of `visibility`: from the first to the last tile of a row in
/// which anything is `seen`, [tiles].
void findSurfaceColumns(const Visibility& visibility, const Extent& rows, const std::vector<char>& seen, GBuffer& out)
{
    for (int y = rows.y0; y < rows.y1; ++y) out.surfaceColumns(y) = {rows.x1, rows.x1};
    for (std::size_t i = seen.size(); i-- > 0;) {
        if (!seen[i]) continue;
        const Extent tile = visibility.tileExtent(int(i));
        for (int y = tile.y0; y < tile.y1; ++y) {
            ColumnSpan& columns = out.surfaceColumns(y);
            if (columns.empty()) columns.x1 = tile.x1;
            columns.x0 = tile.x0;
        }
    }
}

/// Local. Writes what later stages read of the tiles in which nothing is seen: all that they test where there is
/// surface on both sides in a row; beside the surface its flow and links, as far as traces look (NearFlow), and its
/// depth, where edges are looked for. Needs `out.surface`.
void clearBackground(const Visibility& visibility, const std::vector<char>& seen, GBuffer& out)
{
    parallelFor(seen.size(), [&](std::size_t i) {
        if (seen[i]) return;
        const Extent tile = visibility.tileExtent(int(i));
        const ColumnSpan& surface = out.surfaceColumns(tile.y0);
        const auto within = [&](const ColumnSpan& columns) { return tile.x0 >= columns.x0 && tile.x1 <= columns.x1; };
        if (within(surface)) {
            clearTile(tile, out);
        } else {
            clearNear(tile, visibility.marksBeside(int(i), seen), out);
            if (within(columnsAround(tile, visibility.scissor(), out))) out.invDepth.fill(tile, 0);
        }
    });
}

/// Background, for all ranks' pieces to be put in.
void clearRows(const View& view, const Extent& valid, bool withScalar, GBuffer& out)
{
    out.resize(valid, withScalar);
    out.flowUnitPx = view.flowUnitPx;
    parallelRows(valid, 64, [&](int y) { clearTile({valid.x0, y, valid.x1, y + 1}, out); });
}

/// Gives the light of masked pixels its sign, as a rank does that holds the whole field.
void maskLight(const Image<std::uint32_t>& masked, const Extent& drawn, GBuffer& out)
{
    for (int y = drawn.y0; y < drawn.y1; ++y)
        for (int x = drawn.x0; x < drawn.x1; ++x)
            if (masked.at(x, y) != 0) out.light.at(x, y) = -out.light.at(x, y);
}

/// Pixels fetch noise from all over its 256 KB, a line after another that is not in a near cache: each thread asks for
/// all of it at once, before its first pixels of a frame. One object a frame.
class NoiseAhead {
public:
    explicit NoiseAhead(const NoisePyramid& noise) : noise_(noise)
    {
        static std::atomic<std::uint64_t> frames{0};
        frame_ = ++frames;
    }
    void ask() const
    {
        thread_local std::uint64_t asked = 0;
        if (std::exchange(asked, frame_) != frame_) prefetchBytes(noise_.cells.data(), noise_.cells.size());
    }

private:
    const NoisePyramid& noise_;
    std::uint64_t frame_;
};

}  // namespace

Projection::Projection(const Scene& scene) : arrays_(scene)
{
    measurePiece();
}

void Projection::surfaceMoved(const SceneChange& change)
{
    arrays_.update(change.triangles);
    brickTriangles_.forget();
    measurePiece();
}

void Projection::measurePiece()
{
    if (scene().inPieces) pieceBounds_ = scene().surface.bounds();
}

void Projection::takeNoise(const View& view)
{
    if (noise_.seed != view.noiseSeed || noise_.style != view.noiseStyle)
        noise_ = NoisePyramid(view.noiseSeed, view.noiseStyle);
}

template <class MayShow, class Resolve, class Clear>
void Projection::drawTiles(const MayShow& mayShow, const Resolve& resolve, const Clear& clear) const
{
    parallelFor(std::size_t(visibility_.tiles()), [&](std::size_t i) {
        TileKeys keys;
        const Extent tile = visibility_.tileExtent(int(i));
        if (mayShow(int(i)) && visibility_.draw(int(i), keys))
            resolve(int(i), keys, tile);
        else
            clear(int(i), tile);
    });
}

Share Projection::draw(const View& view, const Extent& drawn, const Extent& valid, GBuffer& out)
{
    if (scene().inPieces) {
        drawPiece(view);
        clearRows(view, valid, scene().hasScalar, out);
        return PieceShare{&piece_, &out};
    }
    drawWhole(view, drawn, valid, out);
    if (!scene().bricked()) {
        linkSheets(view, drawn, out);
        return {};
    }
    drawBrick(view);
    if (view.maskBelow > 0) {
        masked_.resize(valid);
        masked_.fill(valid, 0);
    }
    return BrickShare{
        &brick_,
        {&out.flow, scene().scalarFromField() ? &out.scalar : nullptr, view.maskBelow > 0 ? &masked_ : nullptr}};
}

void Projection::complete(const View& view, const Extent& drawn, GBuffer& out) const
{
    if (!scene().inPieces && scene().bricked() && view.maskBelow > 0)
        maskLight(masked_, withNeighbours(drawn, out.valid()), out);
    if (scene().inPieces || scene().bricked()) linkSheets(view, drawn, out);
}

void Projection::drawWhole(const View& view, const Extent& drawn, const Extent& valid, GBuffer& out)
{
    takeNoise(view);
    out.resize(valid, scene().hasScalar, !scene().surfaces.empty());
    out.flowUnitPx = view.flowUnitPx;
    const Extent neighbours = withNeighbours(drawn, valid);
    visibility_.bin(arrays_, view, neighbours);
    seen_.assign(std::size_t(visibility_.tiles()), 0);
    const bool samples = !scene().bricked() || scene().mixed();
    const NoiseAhead noiseAhead(noise_);
    drawTiles([](int) { return true; },
              [&](int i, const TileKeys& keys, const Extent& tile) {
                  seen_[std::size_t(i)] = 1;
                  if (samples) noiseAhead.ask();
                  resolveTile(keys, tile, arrays_, view, noise_, out);
              },
              [](int, const Extent&) {});
    findSurfaceColumns(visibility_, neighbours, seen_, out);
    clearBackground(visibility_, seen_, out);
}

void Projection::drawBrick(const View& view)
{
    takeNoise(view);
    brick_.drawn = imageOf(*scene().field, scene().surface.originWorld, view);
    brick_.flow.resize(brick_.drawn);
    if (scene().scalarFromField()) brick_.scalar.resize(brick_.drawn);
    if (view.maskBelow > 0) brick_.masked.resize(brick_.drawn);
    brickTriangles_.update(scene());
    const std::vector<std::uint32_t>& reaching = brickTriangles_.reaching();
    visibility_.bin(arrays_, view, brick_.drawn);
    const NoiseAhead noiseAhead(noise_);
    drawTiles([&](int i) { return visibility_.hasAny(i, reaching); },
              [&](int, const TileKeys& keys, const Extent& tile) {
                  noiseAhead.ask();
                  resolveBrickTile(keys, tile, arrays_, reaching, view, noise_, brick_);
              },
              [&](int, const Extent& tile) { clearBrickTile(tile, brick_); });
}

void Projection::drawPiece(const View& view)
{
    takeNoise(view);
    piece_.drawn = imageOf(pieceBounds_, scene().surface.originWorld, view);
    piece_.depth.resize(piece_.drawn);
    piece_.order.resize(piece_.drawn);
    piece_.seen.resize(piece_.drawn, scene().hasScalar);
    visibility_.bin(arrays_, view, piece_.drawn);
    const NoiseAhead noiseAhead(noise_);
    drawTiles([](int) { return true; },
              [&](int, const TileKeys& keys, const Extent& tile) {
                  noiseAhead.ask();
                  resolveTile(keys, tile, arrays_, view, noise_, piece_.seen);
                  copyKeys(keys, tile, scene().surface.order, piece_);
              },
              [&](int, const Extent& tile) { piece_.depth.fill(tile, 0); });
}

}  // namespace aeolic::cpu
