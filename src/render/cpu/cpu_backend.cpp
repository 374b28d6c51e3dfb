#include "render/cpu/cpu_backend.h"

#include <hwy/targets.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "aeolic/error.h"
#include "render/cpu/edges/edge_stage.h"
#include "render/cpu/lic/lic_stage.h"
#include "render/cpu/lic/phase_mixer.h"
#include "render/cpu/project/projection.h"
#include "render/cpu/project/raster/coverage.h"
#include "render/cpu/shade/cpu_occlusion.h"
#include "render/cpu/shade/shade.h"
#include "render/cpu/simd/arithmetic.h"

namespace aeolic::cpu {
namespace {

/// The processor's name as the system gives it, for people.
std::string processorName()
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown processor";
}

// 32-bit gather indices count the floats of 48-byte vertex records and the words of triangles.
constexpr std::size_t kMostPoints = (std::size_t{1} << 31) / 12, kMostTriangles = (std::size_t{1} << 31) / 3;

void requireReachable(const SurfaceMesh& mesh)
{
    if (mesh.positions.size() >= kMostPoints || mesh.triangles.size() >= kMostTriangles)
        throw InputError(
            mesh.name, std::to_string(mesh.triangles.size()) + " triangles",
            "at most " + std::to_string(kMostTriangles) + " triangles and " + std::to_string(kMostPoints) + " points");
}

class CpuBackend final : public Backend, public BackendProbe {
public:
    explicit CpuBackend(const Scene& scene) : scene_(scene), projection_(scene) {}

    void sceneMoved(const SceneChange& change) override
    {
        if (!change.surface) return;  // The field is read where it is.
        requireReachable(scene_.surface);
        projection_.surfaceMoved(change);
    }

    std::string name() const override { return "cpu"; }
    std::string device() const override { return processorName(); }
    std::string simd() const override { return hwy::TargetName(hwy::SupportedTargets() & -hwy::SupportedTargets()); }
    std::string kind() const override { return fusesMultiplyAdds() ? "cpu" : "cpu without fused multiply-adds"; }

    std::vector<std::int64_t> coverage(const View& view, int factor) override
    {
        return coverage_.draw(projection_.arrays(), coarseView(view, factor)).pixelsPerRow();
    }

    CoverageBits* coverageOfPart(const View& view, int factor, int part, int parts) override
    {
        return &coverage_.draw(projection_.arrays(), coarseView(view, factor), part, parts);
    }

    Share project(const View& view, const Extent& drawn, const Extent& valid) override
    {
        view_ = view;
        return projection_.draw(view, drawn, valid, buffer_);
    }

    void complete(const View& view, const Extent& drawn) override { projection_.complete(view, drawn, buffer_); }

    std::vector<RowFlow> rowFlow(const Extent& rows) override { return aeolic::rowFlow(buffer_, rows); }

    void convolve(const LicOptions& lic, const Extent& compute, GuardExchange* guards) override
    {
        lic_.run(buffer_, lic, compute, guards);
    }

    void smooth(const LicOptions& lic, const Extent& compute, RowExchange* beside, int more) override
    {
        lic_.smooth(buffer_, lic, compute, beside, more);
    }

    void flatten(const LicOptions& lic, const Extent& compute, RowExchange* beside, int more) override
    {
        lic_.flatten(buffer_, lic, compute, beside, more);
    }

    void keepPhase(int which) override { phases_.keep(which, lic_.values()); }
    void mixPhases(const phase_mix::Mixture& mixture) override { phases_.mix(buffer_, mixture, lic_.values()); }
    Share projectGrains(const View& view, const Extent& drawn, const Extent& valid) override
    {
        return project(view, drawn, valid);
    }
    void projectAgain(const Extent& /*drawn*/) override {}  // Everything is where it was.

    void occlude(const Palette& palette, const Extent& compute, RowExchange* beside, int more) override
    {
        if (palette.occlusion) occlusion_.run(buffer_, view_, compute, beside, more);
    }

    void shade(const Palette& palette, const Extent& compute, Tile& out, EdgeExchange* pieces) override
    {
        const EdgeScene scene{{buffer_, lic_.values(), occlusion_.open(), palette}, projection_.arrays(), view_};
        shadeRows(scene, compute, out);
        if (palette.antialias) edges_.run(scene, projection_.visibility(), compute, out, pieces);
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

    void see(const Extent& rows, SeenSurface& out) override
    {
        out.resize(rows);
        out.flowUnitPx = buffer_.flowUnitPx;
        for (int y = rows.y0; y < rows.y1; ++y) {
            const auto copy = [&](const auto& from, auto& to) {
                const ColumnSpan& columns = buffer_.surfaceColumns(y);  // Beside them anything stands.
                to.clearBeside(y, columns);
                std::copy(from.row(y) + columns.x0, from.row(y) + columns.x1, to.row(y) + columns.x0);
            };
            copy(buffer_.invDepth, out.invDepth);
            copy(buffer_.gradX, out.gradX);
            copy(buffer_.gradY, out.gradY);
            copy(buffer_.flow, out.flow);
        }
    }

    BackendProbe& probe() override { return *this; }

    const GBuffer& gbuffer() override
    {
        // Beside the surface's columns no stage writes, so anything may stand there. Whoever looks gets zeros.
        for (int y = buffer_.valid().y0; y < buffer_.valid().y1; ++y) {
            buffer_.invDepth.clearBeside(y, buffer_.surfaceColumns(y));
            buffer_.flow.clearBeside(y, buffer_.surfaceColumns(y));
            buffer_.links.clearBeside(y, buffer_.surfaceColumns(y));
        }
        return buffer_;
    }

    const Image<float>& lic() override
    {
        LicImage& values = lic_.values();
        for (int y = values.valid().y0; y < values.valid().y1; ++y) values.clearBeside(y, buffer_.surfaceColumns(y));
        return values;
    }

    void setLic(const Image<float>& values) override
    {
        const Extent& extent = values.valid();
        for (int y = extent.y0; y < extent.y1; ++y)
            std::copy_n(&values.at(extent.x0, y), extent.width(), &lic_.values().at(extent.x0, y));
    }

private:
    const Scene& scene_;
    Projection projection_;
    CoverageCount coverage_;
    GBuffer buffer_;
    LicStage lic_;
    PhaseMixer phases_;
    OcclusionStage occlusion_;
    EdgeStage edges_;
    View view_;  // Of the last projection.
};

}  // namespace

const BackendKind kind{BackendChoice::cpu, true, nullptr, nullptr,
                       [](const Scene& scene, const DeviceRequest&) -> std::unique_ptr<Backend> {
                           requireReachable(scene.surface);
                           return std::make_unique<CpuBackend>(scene);
                       }};

}  // namespace aeolic::cpu
