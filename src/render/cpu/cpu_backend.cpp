#include "render/cpu/cpu_backend.h"

#include <hwy/targets.h>

#include <algorithm>

#include "aeolic/error.h"
#include "base/parallel.h"
#include "base/processor.h"
#include "render/cpu/convolve.h"
#include "render/cpu/hierarchical_pass.h"
#include "render/cpu/links.h"
#include "render/cpu/resolve.h"
#include "render/cpu/shade.h"
#include "render/cpu/visibility.h"

namespace aeolic::cpu {
namespace {

// 32-bit gather indices count the floats of 48-byte vertex records and the words of triangles.
constexpr std::size_t kMostPoints = (std::size_t{1} << 31) / 12, kMostTriangles = (std::size_t{1} << 31) / 3;

class CpuBackend final : public Backend {
public:
    explicit CpuBackend(const Scene& scene) : arrays_(scene) {}

    std::string name() const override { return "cpu"; }
    std::string device() const override { return processorName(); }
    std::string simd() const override { return hwy::TargetName(hwy::SupportedTargets() & -hwy::SupportedTargets()); }

    GBuffer& project(const View& view, const Extent& valid) override
    {
        if (noise_.seed != view.noiseSeed) noise_ = NoisePyramid(view.noiseSeed);
        buffer_.resize(valid, arrays_.scene->hasScalar);
        buffer_.flowUnitPx = view.flowUnitPx;
        visibility_.bin(arrays_, view, valid);
        parallelFor(std::size_t(visibility_.tilesX() * visibility_.tilesY()), [&](std::size_t i) {
            TileKeys keys;
            const Extent tile = visibility_.tileExtent(int(i));
            if (visibility_.draw(int(i), keys))
                resolveTile(keys, tile, arrays_, view, noise_, buffer_);
            else
                clearTile(tile, buffer_);
        });
        linkSheets(view, valid, buffer_);
        return buffer_;
    }

    const Image<float>& convolve(const GBuffer& buffer, const LicOptions& lic, const Extent& compute) override
    {
        lic_.resize(compute);
        if (lic.method == LicMethod::none) {
            for (int y = compute.y0; y < compute.y1; ++y) std::fill_n(&lic_.at(compute.x0, y), compute.width(), 0.0f);
        } else if (lic.method == LicMethod::hierarchical) {
            flow_.build(buffer, kHierarchicalSharpness);
            convolveHierarchical(buffer, flow_, lic, compute, hierarchy_, lic_);
        } else {
            flow_.build(buffer, 0);
            convolveDirect(buffer, flow_, lic, compute, lic_);
        }
        return lic_;
    }

    void shade(const GBuffer& buffer, const Image<float>& lic, const Palette& palette, const Extent& compute,
               Tile& out) override
    {
        shadeRows(buffer, lic, palette, compute, out);
    }

private:
    SceneArrays arrays_;
    NoisePyramid noise_{1};
    Visibility visibility_;
    GBuffer buffer_;
    FlowCells flow_;
    Hierarchy hierarchy_;
    LicImage lic_;
};

}  // namespace

std::unique_ptr<Backend> makeCpuBackend(const Scene& scene)
{
    if (scene.surface.positions.size() >= kMostPoints || scene.surface.triangles.size() >= kMostTriangles)
        throw InputError(
            scene.surface.name, std::to_string(scene.surface.triangles.size()) + " triangles",
            "at most " + std::to_string(kMostTriangles) + " triangles and " + std::to_string(kMostPoints) + " points");
    return std::make_unique<CpuBackend>(scene);
}

}  // namespace aeolic::cpu
