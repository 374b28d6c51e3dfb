#include "render/cpu/cpu_backend.h"

#include <hwy/targets.h>

#include <algorithm>

#include "aeolic/error.h"
#include "base/parallel.h"
#include "base/processor.h"
#include "render/brick_image.h"
#include "render/cpu/arithmetic.h"
#include "render/cpu/background.h"
#include "render/cpu/brick_triangles.h"
#include "render/cpu/convolve.h"
#include "render/cpu/coverage.h"
#include "render/cpu/hierarchical_pass.h"
#include "render/cpu/links.h"
#include "render/cpu/noise_ahead.h"
#include "render/cpu/resolve.h"
#include "render/cpu/shade.h"
#include "render/cpu/visibility.h"

namespace aeolic::cpu {
namespace {

// 32-bit gather indices count the floats of 48-byte vertex records and the words of triangles.
constexpr std::size_t kMostPoints = (std::size_t{1} << 31) / 12, kMostTriangles = (std::size_t{1} << 31) / 3;

void requireReachable(const SurfaceMesh& mesh)
{
    if (mesh.positions.size() >= kMostPoints || mesh.triangles.size() >= kMostTriangles)
        throw InputError(
            mesh.name, std::to_string(mesh.triangles.size()) + " triangles",
            "at most " + std::to_string(kMostTriangles) + " triangles and " + std::to_string(kMostPoints) + " points");
}

class CpuBackend final : public Backend {
public:
    explicit CpuBackend(const Scene& scene) : arrays_(scene) { measurePiece(); }

    void sceneMoved(const SceneChange& change) override
    {
        if (!change.surface) return;  // The field is read where it is.
        requireReachable(arrays_.scene->surface);
        arrays_.update(change.triangles);
        brickTriangles_.forget();
        measurePiece();
    }

    std::string name() const override { return "cpu"; }
    std::string device() const override { return processorName(); }
    std::string simd() const override { return hwy::TargetName(hwy::SupportedTargets() & -hwy::SupportedTargets()); }
    std::string kind() const override { return fusesMultiplyAdds() ? "cpu" : "cpu without fused multiply-adds"; }

    TraceReach reach(const LicOptions& lic) const override
    {
        if (lic.method == LicMethod::none) return {};
        if (lic.method == LicMethod::direct) return {lic.steps, 0};
        return planJumps(lic.steps).reach();
    }

    std::vector<std::int64_t> coverage(const View& view, int factor) override
    {
        return coverage_.draw(arrays_, coarseView(view, factor)).pixelsPerRow();
    }

    CoverageBits* coverageOfPart(const View& view, int factor, int part, int parts) override
    {
        return &coverage_.draw(arrays_, coarseView(view, factor), part, parts);
    }

    void project(const View& view, const Extent& drawn, const Extent& valid) override
    {
        if (noise_.seed != view.noiseSeed) noise_ = NoisePyramid(view.noiseSeed);
        buffer_.resize(valid, arrays_.scene->hasScalar);
        buffer_.flowUnitPx = view.flowUnitPx;
        // Links need the neighbours; where these are others' they are drawn for that alone.
        const Extent neighbours{valid.x0, std::max(drawn.y0 - 1, valid.y0), valid.x1, std::min(drawn.y1 + 1, valid.y1)};
        visibility_.bin(arrays_, view, neighbours);
        seen_.assign(std::size_t(visibility_.tiles()), 0);
        const bool bricked = arrays_.scene->bricked();
        const NoiseAhead noiseAhead(noise_);
        parallelFor(seen_.size(), [&](std::size_t i) {
            TileKeys keys;
            const Extent tile = visibility_.tileExtent(int(i));
            seen_[i] = visibility_.draw(int(i), keys);
            if (!seen_[i]) return;
            if (!bricked) noiseAhead.ask();
            resolveTile(keys, tile, arrays_, view, noise_, buffer_);
        });
        findSurfaceColumns(visibility_, neighbours, seen_, buffer_);
        clearBackground(visibility_, seen_, buffer_);
        if (!bricked) linkSheets(view, drawn, buffer_);
    }

    const FieldPixels& projectBrick(const View& view) override
    {
        const Scene& scene = *arrays_.scene;
        pixels_.drawn = imageOf(*scene.field, scene.surface.originWorld, view);
        pixels_.flow.resize(pixels_.drawn);
        if (scene.scalarFromField()) pixels_.scalar.resize(pixels_.drawn);
        brickTriangles_.update(scene);
        const std::vector<std::uint32_t>& reaching = brickTriangles_.reaching();
        visibility_.bin(arrays_, view, pixels_.drawn);
        const NoiseAhead noiseAhead(noise_);
        parallelFor(std::size_t(visibility_.tiles()), [&](std::size_t i) {
            TileKeys keys;
            const Extent tile = visibility_.tileExtent(int(i));
            if (visibility_.hasAny(int(i), reaching) && visibility_.draw(int(i), keys)) {
                noiseAhead.ask();
                resolveBrickTile(keys, tile, arrays_, reaching, view, noise_, pixels_);
            } else {
                clearBrickTile(tile, pixels_);
            }
        });
        return pixels_;
    }

    const SurfacePixels& projectPiece(const View& view) override
    {
        const Scene& scene = *arrays_.scene;
        if (noise_.seed != view.noiseSeed) noise_ = NoisePyramid(view.noiseSeed);
        piece_.drawn = imageOf(pieceBounds_, scene.surface.originWorld, view);
        piece_.depth.resize(piece_.drawn);
        piece_.order.resize(piece_.drawn);
        piece_.seen.resize(piece_.drawn, scene.hasScalar);
        visibility_.bin(arrays_, view, piece_.drawn);
        const NoiseAhead noiseAhead(noise_);
        parallelFor(std::size_t(visibility_.tiles()), [&](std::size_t i) {
            TileKeys keys;
            const Extent tile = visibility_.tileExtent(int(i));
            if (visibility_.draw(int(i), keys)) {
                noiseAhead.ask();
                resolveTile(keys, tile, arrays_, view, noise_, piece_.seen);
                copyKeys(keys, tile, scene.surface.order, piece_);
            } else {
                clearKeys(tile, piece_);
            }
        });
        return piece_;
    }

    GBuffer& surfaceRows(const View& view, const Extent& valid) override
    {
        buffer_.resize(valid, arrays_.scene->hasScalar);
        buffer_.flowUnitPx = view.flowUnitPx;
        parallelRanges(std::size_t(std::max(valid.height(), 0)), 64, [&](std::size_t begin, std::size_t end) {
            clearTile({valid.x0, valid.y0 + int(begin), valid.x1, valid.y0 + int(end)}, buffer_);
        });
        return buffer_;
    }

    FieldRows fieldRows() override
    {
        return {&buffer_.flow, arrays_.scene->scalarFromField() ? &buffer_.scalar : nullptr};
    }

    void link(const View& view, const Extent& drawn) override { linkSheets(view, drawn, buffer_); }

    std::vector<RowFacts> rowFacts(const Extent& rows) override { return aeolic::rowFacts(buffer_, rows); }

    void convolve(const LicOptions& lic, const Extent& compute, GuardExchange* guards) override
    {
        lic_.resize(compute);
        if (lic.method == LicMethod::none) {
            for (int y = compute.y0; y < compute.y1; ++y) std::fill_n(&lic_.at(compute.x0, y), compute.width(), 0.0f);
        } else if (lic.method == LicMethod::hierarchical) {
            const int walked = std::min(lic.steps, planJumps(lic.steps).direct);
            const NearFlow near = receiveFlow(compute, guards, walked);
            flow_.build(buffer_, near, kHierarchicalSharpness);
            convolveHierarchical(buffer_, flow_, near, lic, compute, guards, hierarchy_, lic_);
        } else {
            flow_.build(buffer_, receiveFlow(compute, guards, lic.steps), 0);
            convolveDirect(buffer_, flow_, lic, compute, lic_);
        }
    }

    void shade(const Palette& palette, const Extent& compute, Tile& out) override
    {
        shadeRows(buffer_, lic_, palette, compute, out);
    }

    std::int64_t coveredPixels(int y0, int y1) override
    {
        std::int64_t count = 0;
        for (int y = y0; y < y1; ++y) {
            const float* depth = buffer_.invDepth.row(y);
            const ColumnSpan& columns = buffer_.surfaceColumns(y);
            for (int x = columns.x0; x < columns.x1; ++x) count += depth[x] > 0;
        }
        return count;
    }

    const GBuffer& gbuffer() override
    {
        for (int y = buffer_.valid().y0; y < buffer_.valid().y1; ++y) {
            clearBeside(y, buffer_.invDepth);
            clearBeside(y, buffer_.flow);
            clearBeside(y, buffer_.links);
        }
        return buffer_;
    }

    const Image<float>& lic() override
    {
        for (int y = lic_.valid().y0; y < lic_.valid().y1; ++y) clearBeside(y, lic_);
        return lic_;
    }

    void setLic(const Image<float>& values) override
    {
        const Extent& extent = values.valid();
        for (int y = extent.y0; y < extent.y1; ++y)
            std::copy_n(&values.at(extent.x0, y), extent.width(), &lic_.at(extent.x0, y));
    }

private:
    /// Brings vectors and links as far as traces sample them, in steps. Returns where that is.
    NearFlow receiveFlow(const Extent& compute, GuardExchange* guards, int sampled)
    {
        const Extent& valid = buffer_.valid();
        Extent rows = valid;
        if (guards) {
            guards->receive({{{imageRows(buffer_.flow), imageRows(buffer_.links)}, sampled}});
            const GuardRows guard = guards->rows(sampled);
            rows.y0 = std::max(compute.y0 - guard.above, valid.y0);
            rows.y1 = std::min(compute.y1 + guard.below, valid.y1);
        }
        std::vector<ColumnSpan> flow(std::size_t(std::max(rows.height(), 0)));
        parallelRanges(flow.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const int y = rows.y0 + int(i);
                const bool own = !guards || (y >= compute.y0 && y < compute.y1);
                const ColumnSpan& columns = buffer_.surfaceColumns(y);
                flow[i] = own ? flowColumns(buffer_.flow.row(y), columns.x0, columns.x1) : guards->flowOf(y);
            }
        });
        return {rows, flow};
    }

    /// What no stage reads or writes.
    template <class T>
    void clearBeside(int y, Image<T>& image) const
    {
        const ColumnSpan columns = buffer_.surfaceColumns(y);
        T* row = image.row(y);
        std::fill(row + image.valid().x0, row + columns.x0, T{});
        std::fill(row + columns.x1, row + image.valid().x1, T{});
    }

    void measurePiece()
    {
        if (arrays_.scene->inPieces) pieceBounds_ = arrays_.scene->surface.bounds();
    }

    SceneArrays arrays_;
    Bounds pieceBounds_;  // World, of what this rank holds of a surface in pieces.
    NoisePyramid noise_{1};
    CoverageCount coverage_;
    BrickTriangles brickTriangles_;
    Visibility visibility_;
    std::vector<char> seen_;  // [tiles]: is anything visible in it?
    GBuffer buffer_;
    FieldPixels pixels_;
    SurfacePixels piece_;
    FlowCells flow_;
    Hierarchy hierarchy_;
    LicImage lic_;
};

}  // namespace

std::unique_ptr<Backend> makeCpuBackend(const Scene& scene)
{
    requireReachable(scene.surface);
    return std::make_unique<CpuBackend>(scene);
}

}  // namespace aeolic::cpu
