#include "render/cpu/project/projection.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/parallel.h"
#include "render/brick_image.h"
#include "render/cpu/project/background.h"
#include "render/cpu/project/links.h"
#include "render/cpu/project/resolve.h"
#include "render/cpu/simd/prefetch.h"

namespace aeolic::cpu {
namespace {

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
