#include "aeolic/renderer.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <stdexcept>
#include <utility>

#include "aeolic/error.h"
#include "base/memory.h"
#include "base/timing.h"
#include "cluster/agreement.h"
#include "cluster/hosts.h"
#include "cluster/serial_communicator.h"
#include "data/scene.h"
#include "pipeline/backend_together.h"
#include "pipeline/frame.h"
#include "pipeline/load_together.h"
#include "pipeline/unify.h"
#include "render/colormap.h"
#include "render/scalar_bar.h"
#include "scene/scene_json.h"
#include "scene/validate.h"
#include "version.h"

namespace aeolic {
namespace {

// G-buffer, LIC levels, keys and picture together, per pixel; measured with the largest set of stages.
constexpr std::uint64_t kBytesPerPixel = 96;

void checkImageMemory(int width, int height)
{
    const std::uint64_t needed = std::uint64_t(width) * std::uint64_t(height) * kBytesPerPixel,
                        available = availableMemoryBytes();
    if (needed > available)
        throw InputError(
            "--size",
            std::to_string(width) + "x" + std::to_string(height) + " needs " + std::to_string(needed >> 20) + " MB",
            "at most the " + std::to_string(available >> 20) + " MB of memory available");
}

Picture pictureFromTile(const Tile& tile, bool withAlpha)
{
    Picture picture{tile.extent.width(), tile.extent.height(), withAlpha ? 4 : 3, {}};
    const std::size_t count = std::size_t(picture.width) * std::size_t(picture.height);
    if (withAlpha) {
        picture.pixels = tile.rgba;
        return picture;
    }
    picture.pixels.resize(count * 3);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 3; ++c) picture.pixels[3 * i + c] = tile.rgba[4 * i + c];
    return picture;
}

}  // namespace

struct Renderer::State {
    /// A frame from its start to its end, and what may have changed by then.
    struct InFlight {
        Frame frame;
        ShadingOptions shading;
        int height = 0;  // Of the whole picture.
        double time = 0, stepMs = 0;
        bool finished = false;  // And not yet asked for.
    };

    SceneDescription description;
    std::optional<tbb::global_control> allowed;  // More threads than cores, where asked for.
    tbb::task_arena arena;
    Scene scene;
    std::unique_ptr<SceneSteps> steps;  // Of a scene that changes in time.
    SurfaceReach reach;                 // Where the surface is at this moment.
    GpuChoice gpu;
    BackendPlan plan;
    std::unique_ptr<Backend> backend;
    SceneInfo info;
    FrameStats last;
    double stepMs = 0;  // Since the frame before, for another moment.
    FrameGroup group;
    std::deque<InFlight> frames;  // As many as the backend has in flight, by turns.
    std::size_t started = 0, finished = 0;

    State(SceneDescription d, std::shared_ptr<Communicator> ranks, int cores)
        : description(std::move(d)),
          arena(description.run.threads > 0 ? description.run.threads : cores),
          group(std::move(ranks), description.run)
    {
        if (description.run.threads > tbb::info::default_concurrency())
            allowed.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(description.run.threads));
    }

    /// By the plan, which may have changed.
    void makeBackend()
    {
        backend = aeolic::makeBackend(group.communicator(), plan, scene, gpu);
        if (plan.missed) scene.warnings.push_back("the GPU is not used: " + plan.unusedGpu);
        info.unusedGpu = plan.unusedGpu;
        info.backend = backend->name();
        info.device = backend->device();
        info.simd = backend->simd();
    }

    /// The scene has moved on, perhaps to where the backend has no room for it. What is in flight comes first then.
    void moveBackend(const SceneChange& change)
    {
        if (aeolic::moveBackend(group.communicator(), plan, change, *backend)) return;
        for (std::size_t i = finished; i < started; ++i) bringIn(frames[i % frames.size()]);
        makeBackend();
    }

    int unfinished() const
    {
        int count = 0;
        for (std::size_t i = finished; i < started; ++i) count += !frames[i % frames.size()].finished;
        return count;
    }

    void start(const CameraOptions& camera, bool gather)
    {
        if (frames.empty()) frames.resize(std::size_t(backend->framesInFlight()));
        if (started - finished == frames.size() || unfinished() == backend->framesInFlight())
            throw std::logic_error("more frames are started than can be in flight");
        const OutputOptions& output = description.output;
        const FrameRequest request{
            makeCamera(camera, scene.boundsWorld, scene.fitRadius, output.width, output.height, reach), description.lic,
            description.shading};
        InFlight& next = frames[started % frames.size()];
        next.shading = description.shading;
        next.height = output.height;
        next.time = info.time;
        next.stepMs = std::exchange(stepMs, 0.0);
        next.finished = false;
        next.frame.tiles.gather = gather;
        arena.execute([&] { aeolic::startFrame(request, scene, *backend, group, next.frame); });
        ++started;
    }

    void bringIn(InFlight& frame)
    {
        if (!std::exchange(frame.finished, true)) finishFrame(*backend, group, frame.frame);
    }

    InFlight& finish()
    {
        if (started == finished) throw std::logic_error("no frame is started");
        InFlight& oldest = frames[finished++ % frames.size()];  // Over, also where that fails.
        arena.execute([&] { bringIn(oldest); });
        last = oldest.frame.stats;
        last.time = oldest.time;
        last.stepMs = oldest.stepMs;
        return oldest;
    }

    /// A tile's pixels as the user gets them, the scalar bar on top.
    Picture pictureOf(const Tile& tile, const InFlight& of) const
    {
        Picture picture = pictureFromTile(tile, of.shading.background == "transparent");
        if (!scene.hasScalar || !of.shading.scalarBar) return picture;
        const auto range = of.shading.colorRange.value_or(scene.scalarRange);
        drawScalarBar({picture, of.height, tile.extent.y0}, colorMap(of.shading.colorMap), range[0], range[1],
                      scene.scalarName, barInksFor(of.shading.background));
        return picture;
    }
};

Renderer::Renderer(SceneDescription description, ProgressFunction progress)
    : Renderer(std::move(description), makeSerialCommunicator(), std::move(progress))
{
}

Renderer::Renderer(SceneDescription description, std::shared_ptr<Communicator> ranks, ProgressFunction progress)
{
    Communicator& communicator = *ranks;
    runTogether(communicator, [&] { validate(description); });
    requireSame(communicator, "aeolic's version", versionText);
    requireSame(communicator, "the scene", sceneToJson(description));
    const HostShare host = hostShare(communicator);
    StopWatch watch;
    runTogether(communicator, [&] {
        state_ = std::make_unique<State>(std::move(description), std::move(ranks), host.cores);
        checkImageMemory(state_->description.output.width, state_->description.output.height);
    });
    State& s = *state_;
    s.arena.execute([&] {
        const auto report = [](const char* what, double fraction, void* context) {
            (*static_cast<ProgressFunction*>(context))(what, fraction);
        };
        const Split split = splitOf(communicator, s.description, host.ranks);
        s.gpu = {s.description.run.device, indexOnHost(communicator)};
        s.plan = planBackend(communicator, s.description, split, s.gpu);
        s.scene = loadSplit(communicator, s.description, split, progress ? +report : nullptr, &progress, &s.steps);
        s.reach = reachOf(communicator, s.scene);
        s.makeBackend();
        // Processors agree about every bit; GPUs of different kinds do not, and a picture must not show who drew what.
        requireSame(communicator, "the backend",
                    s.backend->name() == "gl" ? "gl on " + s.backend->device() : s.backend->name());
    });
    s.info.threads = s.arena.max_concurrency();
    s.info.ranks = communicator.size();
    s.info.loadMs = watch.lapMs();
    s.info.fieldBytes = s.scene.field ? s.scene.field->bytes() : 0;
    s.info.fieldBytesOfRank = communicator.allGatherValue(std::int64_t(s.info.fieldBytes));
    s.info.triangles = s.scene.allTriangles;
    s.info.warnings = s.scene.warnings;
    s.info.times = s.steps->times();
    s.info.time = startOf(s.description, s.info.times);
}

std::shared_ptr<Communicator> joinRanks()
{
    return makeCommunicator();
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

int Renderer::framesInFlight() const
{
    return state_->backend->framesInFlight();
}

void Renderer::start(const CameraOptions& camera)
{
    state_->start(camera, true);
}

void Renderer::startStripe(const CameraOptions& camera)
{
    state_->start(camera, false);
}

void Renderer::startFrame(int index)
{
    const OutputOptions& output = state_->description.output;
    if (const auto& range = state_->description.time.range) {
        const int next = std::min(index + 1, output.frames - 1);
        moveTo(momentOfFrame(*range, index, output.frames), momentOfFrame(*range, next, output.frames));
    }
    const double turn = output.frames > 1 ? orbitDegOf(state_->description) * index / output.frames : 0.0;
    start(orbited(state_->description.camera, turn, state_->scene.boundsWorld));
}

Picture Renderer::finish()
{
    const State::InFlight& done = state_->finish();
    if (state_->group.rank() != 0) return {};
    return state_->pictureOf(done.frame.tiles.picture, done);
}

PictureStripe Renderer::finishStripe()
{
    const State::InFlight& done = state_->finish();
    const Tile& stripe = done.frame.tiles.stripe;
    return {state_->pictureOf(stripe, done), stripe.extent.y0, done.height};
}

Picture Renderer::render(const CameraOptions& camera)
{
    start(camera);
    return finish();
}

PictureStripe Renderer::renderStripe(const CameraOptions& camera)
{
    startStripe(camera);
    return finishStripe();
}

Picture Renderer::renderFrame(int index)
{
    startFrame(index);
    return finish();
}

void Renderer::setTime(double moment)
{
    moveTo(moment, moment + (moment - state_->info.time));  // Whoever scrubs or plays goes on as far.
    state_->description.time = {moment, std::nullopt};
}

void Renderer::moveTo(double moment, double next)
{
    State& s = *state_;
    Communicator& communicator = s.group.communicator();
    runTogether(communicator, [&] {
        if (!std::isfinite(moment)) throw InputError("--time", "found " + std::to_string(moment), "a finite number");
    });
    StopWatch watch;
    s.arena.execute([&] {
        const SceneChange change = moveTogether(communicator, *s.steps, moment, s.scene);
        if (change.surface) s.reach = reachOf(communicator, s.scene);
        if (change.any()) s.moveBackend(change);
        s.steps->readAhead(next);
    });
    s.stepMs = watch.lapMs();
    s.info.time = moment;
    s.info.triangles = s.scene.allTriangles;
    s.info.warnings = s.scene.warnings;
}

void Renderer::setLic(const LicOptions& lic)
{
    state_->description.lic = lic;
}

void Renderer::setShading(const ShadingOptions& shading)
{
    state_->description.shading = shading;
}

void Renderer::setSize(int width, int height)
{
    runTogether(state_->group.communicator(), [&] { checkImageMemory(width, height); });
    state_->description.output.width = width;
    state_->description.output.height = height;
}

const SceneInfo& Renderer::info() const
{
    return state_->info;
}
const FrameStats& Renderer::lastFrame() const
{
    return state_->last;
}
const Scene& Renderer::scene() const
{
    return state_->scene;
}
const SceneDescription& Renderer::description() const
{
    return state_->description;
}

}  // namespace aeolic
