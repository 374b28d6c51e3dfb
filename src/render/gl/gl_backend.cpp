#include "render/gl/gl_backend.h"

#include <algorithm>
#include <limits>

#include "render/brick_image.h"
#include "render/gl/blocks.h"
#include "render/gl/context.h"
#include "render/gl/convolve.h"
#include "render/gl/copies.h"
#include "render/gl/device_errors.h"
#include "render/gl/frame_images.h"
#include "render/gl/frames_in_flight.h"
#include "render/gl/gpu_scene.h"
#include "render/gl/guard_rows.h"
#include "render/gl/near_tiles.h"
#include "render/gl/resolve.h"
#include "render/gl/scene_limits.h"
#include "render/gl/shade.h"
#include "render/gl/visibility.h"

namespace aeolic::gl {
namespace {

/// What lives in the context: destroyed while it is current.
struct GpuState {
    explicit GpuState(const Scene& loaded) : scene(loaded), view(sizeof(ViewBlock), GL_DYNAMIC_STORAGE_BIT) {}

    GpuScene scene;
    Buffer view;
    CoverageCount coverage;
    FrameImages images;
    FramesInFlight frames;
    NearTiles near;
    BrickResolve bricks;
    DirectConvolution direct;
    HierarchicalConvolution hierarchical;
    Shade shade;
    RowFactsCopy facts;
    GuardRowExchange exchange;
};

class GlBackend final : public Backend {
public:
    GlBackend(const Scene& scene, std::shared_ptr<Context> context) : scene_(scene), context_(std::move(context))
    {
        context_->bind();
        takeOver([&] {
            gpu_ = std::make_unique<GpuState>(scene);
            context_->check("loading the scene");
        });
        context_->release();
    }
    ~GlBackend() override
    {
        if (context_->tryBind())
            gpu_.reset();
        else
            static_cast<void>(gpu_.release());  // Names of a lost context are nobody's to give back.
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

    TraceReach reach(const LicOptions& lic) const override
    {
        if (lic.method == LicMethod::none) return {};
        if (lic.method == LicMethod::direct) return {lic.steps, 0};
        return {lic.steps, planJumps(lic.steps).lookups()};
    }

    std::vector<std::int64_t> coverage(const View& view, int factor) override
    {
        context_->bind();
        std::vector<std::int64_t> rows =
            gpu_->coverage.count(context_->programs(), gpu_->scene, coarseView(view, factor));
        context_->check("counting coverage");
        return rows;
    }

    void project(const View& view, const Extent& drawn, const Extent& valid) override
    {
        context_->bind();
        GpuState& gpu = *gpu_;
        gpu.images.resize(view.camera.width, view.camera.height, valid, scene_.hasScalar);
        FrameInFlight& frame = gpu.frames.begin();
        frame.timers.begin(Stage::project);
        gpu.scene.setNoise(view.noiseSeed);
        flowUnitPx_ = view.flowUnitPx;
        // Links need the neighbours; where these are others' they are drawn for that alone.
        const Extent neighbours{valid.x0, std::max(drawn.y0 - 1, valid.y0), valid.x1, std::min(drawn.y1 + 1, valid.y1)};
        draw(view, neighbours);
        frame.counts.start(context_->programs(), gpu.images.visible, drawn.y0, drawn.y1);
        resolve(context_->programs(), gpu.scene, gpu.images, neighbours);
        if (!scene_.bricked()) findLinks(view, drawn, neighbours);
        frame.timers.end();
        context_->check("projecting");
    }

    const FieldPixels& projectBrick(const View& view) override
    {
        context_->bind();
        gpu_->frames.drawn().timers.begin(Stage::project);
        pixels_.drawn = imageOf(*scene_.field, scene_.surface.originWorld, view);
        // Where this covers what project() drew, the same triangles come out again.
        if (!pixels_.drawn.empty()) draw(view, pixels_.drawn);
        gpu_->bricks.run(context_->programs(), gpu_->scene, gpu_->images, pixels_);
        gpu_->frames.drawn().timers.end();
        context_->check("projecting a brick");
        return pixels_;
    }

    FieldRows fieldRows() override
    {
        const Extent& valid = gpu_->images.valid;
        const bool withScalar = scene_.scalarFromField();
        fieldFlow_.resize(valid);
        if (withScalar) fieldScalar_.resize(valid);
        for (int y = valid.y0; y < valid.y1; ++y) {
            std::fill_n(&fieldFlow_.at(valid.x0, y), valid.width(), 0u);
            if (withScalar)
                std::fill_n(&fieldScalar_.at(valid.x0, y), valid.width(), std::numeric_limits<float>::quiet_NaN());
        }
        return {&fieldFlow_, withScalar ? &fieldScalar_ : nullptr};
    }

    void link(const View& view, const Extent& drawn) override
    {
        context_->bind();
        const Extent& valid = gpu_->images.valid;
        const Extent neighbours{valid.x0, std::max(drawn.y0 - 1, valid.y0), valid.x1, std::min(drawn.y1 + 1, valid.y1)};
        gpu_->frames.drawn().timers.begin(Stage::project);
        if (scene_.bricked()) {
            upload(gpu_->images.flow, imageRows(fieldFlow_), neighbours.y0, neighbours.y1);
            if (scene_.scalarFromField())
                upload(gpu_->images.scalar, imageRows(fieldScalar_), neighbours.y0, neighbours.y1);
        }
        findLinks(view, drawn, neighbours);
        gpu_->frames.drawn().timers.end();
        context_->check("linking");
    }

    std::vector<RowFacts> rowFacts(const Extent& rows) override
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
        const TraceReach whole = reach(lic),
                         sampled =
                             hierarchical ? TraceReach{std::min(lic.steps, planJumps(lic.steps).direct), 0} : whole;
        if (guards) receiveFlow(*guards, sampled, whole);
        const Extent& valid = gpu.images.valid;
        const int y0 = compute.y0 - valid.y0, y1 = compute.y1 - valid.y0;
        const ConvolvePass pass{context_->programs(), gpu.near, gpu.images, flowUnitPx_};
        makeTraceTexels(pass, hierarchical ? kHierarchicalSharpness : 0.0f, 0, valid.height());
        if (hierarchical)
            gpu.hierarchical.run(pass, lic, y0, y1, guards ? &gpu.exchange : nullptr);
        else
            gpu.direct.run(pass, lic, y0, y1);
        timers.end();
        context_->check("convolving");
    }

    void shade(const Palette& palette, const Extent& compute, Tile& out) override
    {
        context_->bind();
        gpu_->shade.start(context_->programs(), gpu_->images, palette, method_ != LicMethod::none, compute, out,
                          gpu_->frames.drawn());
        gpu_->frames.shaded();
        glFlush();
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
    /// Takes over (part of) the scene: more than fits is wrong input, by which `auto` goes to the processor.
    template <class Load>
    void takeOver(const Load& load)
    {
        try {
            load();
        } catch (const OutOfMemory&) {
            throwDoesNotFit(sizesOf(scene_), deviceLimits());
        }
    }

    void draw(const View& view, const Extent& area)
    {
        const ViewBlock block = makeViewBlock(view, gpu_->images.valid.y0, gpu_->images.valid.height());
        gpu_->view.write(0, sizeof block, &block);
        glBindBufferBase(GL_UNIFORM_BUFFER, kViewBinding, gpu_->view.id());
        drawVisibility(context_->programs(), gpu_->scene, view, gpu_->images.target, area);
    }

    void findLinks(const View& view, const Extent& drawn, const Extent& neighbours)
    {
        const int first = gpu_->images.valid.y0;
        gpu_->near.find(context_->programs(), gpu_->images, neighbours.y0 - first, neighbours.y1 - first);
        linkSheets(context_->programs(), gpu_->near, gpu_->images, view.focalPx, drawn.y0 - first, drawn.y1 - first);
    }

    /// Brings the vectors as far as traces sample them, the links as far as they go at all.
    void receiveFlow(GuardExchange& guards, const TraceReach& sampled, const TraceReach& whole)
    {
        const Extent& valid = gpu_->images.valid;
        GuardRowExchange& exchange = gpu_->exchange;
        exchange.begin(guards, compute_, valid, gpu_->frames.drawn().timers);
        exchange.add({{&gpu_->images.flow, 0}}, sampled);
        exchange.add({{&gpu_->images.links, 0}}, whole);
        exchange.send();
        exchange.receive();
        const GuardRows guard = guards.rows(sampled);
        gpu_->near.find(context_->programs(), gpu_->images, std::max(compute_.y0 - guard.above - valid.y0, 0),
                        std::min(compute_.y1 + guard.below, valid.y1) - valid.y0);
    }

    const Scene& scene_;
    std::shared_ptr<Context> context_;
    std::unique_ptr<GpuState> gpu_;
    float flowUnitPx_ = 1;
    Extent compute_;
    LicMethod method_ = LicMethod::none;
    std::optional<DeviceTimes> times_;

    // What crosses between the GPU and other ranks, or tests.
    FieldPixels pixels_;
    Image<std::uint32_t> fieldFlow_;
    Image<float> fieldScalar_;
    GBuffer buffer_;
    Image<float> lic_;
};

}  // namespace

std::unique_ptr<Backend> makeGlBackend(const Scene& scene, const GpuChoice& choice, bool realOnly)
{
    return std::make_unique<GlBackend>(scene, acquireContext(choice, realOnly));
}

}  // namespace aeolic::gl
