#include "render/gl/gl_backend.h"

#include "render/brick_image.h"
#include "render/flatten.h"
#include "render/gl/device/context.h"
#include "render/gl/device/device_errors.h"
#include "render/gl/device/dispatch.h"
#include "render/gl/device/gpu_state.h"
#include "render/gl/device/scene_limits.h"
#include "render/lic/along_flow.h"

namespace aeolic::gl {
namespace {

class GlBackend final : public Backend, public BackendProbe {
public:
    GlBackend(const Scene& scene, std::shared_ptr<Context> context) : scene_(scene), context_(std::move(context))
    {
        context_->bind();
        takeOver([&] {
            gpu_ = std::make_unique<GpuState>(scene, isSoftwareRenderer(context_->renderer()));
            context_->check("loading the scene");
        });
        context_->release();
    }
    ~GlBackend() override
    {
        if (context_->tryBind())
            gpu_.reset();
        else
            static_cast<void>(gpu_.release());  // Names of a lost context cannot be given back.
        context_->release();
    }

    void sceneMoved(const SceneChange& change) override
    {
        context_->bind();
        takeOver([&] {
            gpu_->scene.update(change);
            context_->check("loading another moment");
        });
        context_->release();
    }

    std::string name() const override { return "gl"; }
    std::string device() const override { return context_->renderer(); }
    std::string simd() const override { return ""; }
    std::string kind() const override { return "gl on " + device(); }

    std::vector<std::int64_t> coverage(const View& view, int factor) override
    {
        context_->bind();
        std::vector<std::int64_t> rows =
            gpu_->coverage.count(context_->programs(), gpu_->scene, coarseView(view, factor));
        context_->check("counting coverage");
        return rows;
    }

    Share project(const View& view, const Extent& drawn, const Extent& valid) override
    {
        context_->bind();
        GpuState& gpu = *gpu_;
        gpu.images.resize(view.camera.width, view.camera.height, valid, scene_.hasScalar, !scene_.surfaces.empty());
        gpu.frames.begin();
        return projectInFrame(view, drawn, valid);
    }

    Share projectGrains(const View& view, const Extent& drawn, const Extent& valid) override
    {
        context_->bind();
        return projectInFrame(view, drawn, valid);
    }

    Share projectInFrame(const View& view, const Extent& drawn, const Extent& valid)
    {
        GpuState& gpu = *gpu_;
        FrameInFlight& frame = gpu.frames.drawn();
        frame.timers.begin(Stage::project);
        gpu.scene.setNoise(view.noiseSeed, view.noiseStyle);
        flowUnitPx_ = view.flowUnitPx;
        view_ = view;
        const Extent neighbours = withNeighbours(drawn, valid);
        if (scene_.bricked()) startBrick(view);
        gpu.draw(context_->programs(), view, neighbours);
        frame.counts.start(context_->programs(), gpu.images.visible, drawn.y0, drawn.y1);
        resolve(context_->programs(), gpu.scene, gpu.images, neighbours);
        if (!scene_.bricked()) gpu.findLinks(context_->programs(), view, drawn, neighbours);
        frame.timers.end();
        context_->check("projecting");
        if (!scene_.bricked()) return {};
        const FieldRows into = gpu.bricks.rows(gpu.images, scene_.scalarFromField(), scene_.mixed());
        const BrickShare share{&gpu.bricks.finish(), into};
        context_->check("projecting a brick");
        return share;
    }

    void complete(const View& view, const Extent& drawn) override
    {
        if (!scene_.bricked()) return;
        context_->bind();
        const Extent neighbours = withNeighbours(drawn, gpu_->images.valid);
        gpu_->frames.drawn().timers.begin(Stage::project);
        gpu_->bricks.upload(context_->programs(), gpu_->images, neighbours.y0, neighbours.y1);
        gpu_->findLinks(context_->programs(), view, drawn, neighbours);
        gpu_->frames.drawn().timers.end();
        context_->check("linking");
    }

    std::vector<RowFlow> rowFlow(const Extent& rows) override
    {
        context_->bind();
        return gpu_->facts.get(context_->programs(), gpu_->images, rows.y0, rows.y1);
    }

    void convolve(const LicOptions& lic, const Extent& compute, GuardExchange* guards) override
    {
        context_->bind();
        GpuState& gpu = *gpu_;
        compute_ = compute;
        method_ = lic.method;
        if (lic.method == LicMethod::none) return;
        StageTimers& timers = gpu.frames.drawn().timers;
        timers.begin(Stage::convolve);
        const bool hierarchical = lic.method == LicMethod::hierarchical;
        const int sampled = hierarchical ? planJumps(lic.steps).direct : lic.steps;
        if (guards) gpu.receiveFlow(context_->programs(), *guards, compute, sampled, lic.steps);
        const Extent& valid = gpu.images.valid;
        const int y0 = compute.y0 - valid.y0, y1 = compute.y1 - valid.y0;
        const ConvolvePass pass{context_->programs(), gpu.near, gpu.images, flowUnitPx_};
        makeFlowCells(pass, hierarchical ? kHierarchicalSharpness : 0.0f, 0, valid.height());
        if (hierarchical)
            gpu.hierarchical.run(pass, lic, y0, y1, guards ? &gpu.exchange : nullptr);
        else
            gpu.direct.run(pass, lic, y0, y1);
        timers.end();
        context_->check("convolving");
    }

    void smooth(const LicOptions& lic, const Extent& compute, RowExchange* beside, int more) override
    {
        const bool again = along_flow::wanted(lic);
        if (!again && !(beside && more > 0 && lic.method != LicMethod::none)) return;
        context_->bind();
        GpuState& gpu = *gpu_;
        const ConvolvePass pass{context_->programs(), gpu.near, gpu.images, flowUnitPx_};
        if (again)
            gpu.along.run(pass, lic, compute, beside, more, gpu.frames.drawn().timers);
        else
            gpu.along.receiveValues(pass, compute, *beside, more, gpu.frames.drawn().timers);
        context_->check("smoothing");
    }

    void flatten(const LicOptions& lic, const Extent& compute, RowExchange* beside, int more) override
    {
        if (!flatten::wanted(lic)) return;
        context_->bind();
        gpu_->flatten.run(context_->programs(), gpu_->images, lic, view_.camera.height, compute, beside, more,
                          gpu_->frames.drawn().timers);
        context_->check("taking means off");
    }

    void keepPhase(int which) override
    {
        if (method_ == LicMethod::none) return;
        context_->bind();
        gpu_->phases.keep(which, gpu_->images);
        context_->check("keeping a phase");
    }

    void mixPhases(const phase_mix::Mixture& mixture) override
    {
        if (method_ == LicMethod::none) return;
        context_->bind();
        gpu_->phases.mix(context_->programs(), gpu_->images, mixture, gpu_->frames.drawn().timers);
        context_->check("mixing phases");
    }

    void projectAgain(const Extent& drawn) override
    {
        context_->bind();
        gpu_->frames.begin().counts.start(context_->programs(), gpu_->images.visible, drawn.y0, drawn.y1);
        gpu_->bindView();
        context_->check("beginning a frame");
    }

    void occlude(const Palette& palette, const Extent& compute, RowExchange* beside, int more) override
    {
        if (!palette.occlusion) return;
        context_->bind();
        gpu_->occlusion.run({context_->programs(), gpu_->images, view_, gpu_->frames.drawn().timers}, compute, beside,
                            more);
        context_->check("finding hollows");
    }

    void shade(const Palette& palette, const Extent& compute, Tile& out, EdgeExchange* /*pieces*/) override
    {
        context_->bind();
        GpuState& gpu = *gpu_;
        FrameInFlight& frame = gpu.frames.drawn();
        const Extent shown = withNeighbours(compute, gpu.images.valid, palette.antialias ? limits::kEdgeRows : 0);
        out.setBackground(palette.background);
        frame.timers.begin(Stage::shade);
        gpu.shade.draw(context_->programs(), gpu.images, palette, method_ != LicMethod::none, shown,
                       gpu.occlusion.open());
        if (palette.antialias)
            gpu.edges.run({context_->programs(), gpu.scene, view_, gpu.images, palette}, compute, shown,
                          gpu.shade.pixels(), gpu.occlusion.open());
        frame.timers.end();
        gpu.shade.send(compute, out, frame);
        gpu.frames.shaded();
        startWork();
        context_->check("shading");
        context_->release();  // The next frame may come from another thread.
    }

    void finish() override
    {
        context_->bind();
        times_ = gpu_->frames.finish().timers.read();
        context_->check("finishing a frame");
        context_->release();
    }

    int framesInFlight() const override { return FramesInFlight::kMost; }

    std::optional<DeviceTimes> deviceTimes() const override { return times_; }

    std::int64_t coveredPixels(int y0, int y1) override
    {
        RowCounts& counts = gpu_->frames.known().counts;
        if (counts.pending()) {
            context_->bind();
            counts.wait();
        }
        return counts.get(y0, y1);
    }

    void see(const Extent& rows, SeenSurface& out) override
    {
        context_->bind();
        out.flowUnitPx = flowUnitPx_;
        copySeen(gpu_->images, rows, out);
        context_->check("copying the seen surface");
    }

    BackendProbe& probe() override { return *this; }

    const GBuffer& gbuffer() override
    {
        context_->bind();
        copyGBuffer(gpu_->images, scene_.hasScalar, buffer_);
        buffer_.flowUnitPx = flowUnitPx_;
        return buffer_;
    }
    const Image<float>& lic() override
    {
        context_->bind();
        copyLic(gpu_->images, method_ != LicMethod::none, compute_, lic_);
        return lic_;
    }
    void setLic(const Image<float>& values) override
    {
        context_->bind();
        gl::setLic(gpu_->images, values);
    }

private:
    /// Has the brick's pixels drawn before this rank's rows: other ranks wait for them, and meanwhile the device draws
    /// the rows.
    void startBrick(const View& view)
    {
        const Extent drawn = imageOf(*scene_.field, scene_.surface.originWorld, view);
        if (!drawn.empty()) gpu_->draw(context_->programs(), view, drawn);
        gpu_->bricks.start(context_->programs(), gpu_->scene, gpu_->images, drawn, view.maskBelow > 0);
    }

    /// Takes over (part of) the scene. More than fits is wrong input: then `auto` draws on the processor.
    template <class Load>
    void takeOver(const Load& load)
    {
        try {
            load();
        } catch (const OutOfMemory&) {
            throwDoesNotFit(sizesOf(scene_), deviceLimits());
        }
    }

    const Scene& scene_;
    std::shared_ptr<Context> context_;
    std::unique_ptr<GpuState> gpu_;
    float flowUnitPx_ = 1;
    View view_;  // Of the last projection.
    Extent compute_;
    LicMethod method_ = LicMethod::none;
    std::optional<DeviceTimes> times_;

    // For tests.
    GBuffer buffer_;
    Image<float> lic_;
};

}  // namespace

const BackendKind kind{BackendChoice::gl, false, deviceIdentity, requireRoom,
                       [](const Scene& scene, const DeviceRequest& request) -> std::unique_ptr<Backend> {
                           return std::make_unique<GlBackend>(scene, acquireContext(request));
                       }};

}  // namespace aeolic::gl
