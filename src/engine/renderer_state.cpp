#include "engine/renderer_state.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "aeolic/error.h"
#include "base/memory.h"
#include "base/text.h"
#include "base/timing.h"
#include "cluster/comm/hosts.h"
#include "cluster/comm/together.h"
#include "data/color_map/color_map_file.h"
#include "data/load/series/time_series.h"
#include "data/reading/reader_pool.h"
#include "description/option_table.h"
#include "description/overlays.h"
#include "description/scene_json.h"
#include "description/scene_text.h"
#include "description/validate.h"
#include "engine/legend_place.h"
#include "engine/picture_warnings.h"
#include "engine/scene_figure.h"
#include "engine/scene_view.h"
#include "render/picture_memory.h"

namespace aeolic {
namespace {

/// More threads than that on each core only wait for each other.
constexpr int mostThreadsOfCore = 8;

int threadsOf(const RunOptions& run, int cores)
{
    if (run.threads == 0) return cores;
    return std::min(run.threads, mostThreadsOfCore * tbb::info::default_concurrency());
}

ProgressReport reportTo(ProgressFunction& progress)
{
    const auto report = [](const char* what, double fraction, void* context) {
        (*static_cast<ProgressFunction*>(context))(what, fraction);
    };
    return {progress ? +report : nullptr, &progress};
}

/// The description with names of files that hold in the folder where the process is now.
SceneDescription foundFromHere(SceneDescription description, const StartFolder& folder)
{
    if (StartFolder() != folder)
        renameFiles(description, [&](const std::string& name) { return folder.absolute(name); });
    return description;
}

}  // namespace

void checkImageMemory(int width, int height)
{
    const std::uint64_t needed = pictureBytes(width, height), available = availableMemoryBytes();
    if (needed > available)
        throw InputError(
            "--size",
            std::to_string(width) + "x" + std::to_string(height) + " needs " + std::to_string(needed >> 20) + " MB",
            "at most the " + std::to_string(available >> 20) + " MB of memory available");
}

Renderer::State::State(SceneDescription d, std::shared_ptr<Communicator> ranks, int cores)
    : description(std::move(d)),
      arena(threadsOf(description.run, cores)),
      group(std::move(ranks), description.run),
      agreement(group.communicator())
{
    if (arena.max_concurrency() > tbb::info::default_concurrency())
        allowed.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(arena.max_concurrency()));
}

void Renderer::State::load(const Data& memory, ProgressFunction progress)
{
    Communicator& ranks = group.communicator();
    StopWatch watch;
    const KeptReaders readers;  // Files are looked at before they are loaded.
    const SceneDescription found = foundFromHere(description, folder);
    arena.execute([&] {
        namingAsGiven([&] {
            const Split split = splitOf(found, agreement, ranksOnHost, memory);
            plan = planBackend(ranks, found, split, {description.run.device, indexOnHost(ranks)});
            loaded.emplace(found, split, agreement, reportTo(progress), memory);
            makeBackend();
        });
        requireSame(ranks, "the backend", backend->kind());  // A picture must not show who drew what.
    });
    info.threads = arena.max_concurrency();
    if (info.threads < description.run.threads)
        loaded->warn(fmt::format("{} threads are used, not {}: {} for each of {} cores", info.threads,
                                 description.run.threads, mostThreadsOfCore, tbb::info::default_concurrency()));
    const auto threads = ranks.allGatherValue(info.threads);
    info.threadsOfRank.assign(threads.begin(), threads.end());
    info.ranks = ranks.size();
    info.loadMs = watch.lapMs();
    info.fieldBytes = scene().field ? scene().field->bytes() : 0;
    info.fieldBytesOfRank = ranks.allGatherValue(std::int64_t(info.fieldBytes));
    info.times = loaded->times();
    info.time = now = loaded->shownFor(startOf(description, info.times));
    requireRoomForOverlay();
    tell();
}

void Renderer::State::tell()
{
    StartedFrame frame;
    setLook(frame);
    const OutputOptions& output = description.output;
    std::vector<std::string> warnings = sceneWarnings();
    if (const std::string ofMoment = momentWarning(description, loaded->span()); !ofMoment.empty())
        warnings.push_back(ofMoment);
    if (const std::string ofRest = restWarning(description, scene(), now, info.times); !ofRest.empty())
        warnings.push_back(ofRest);
    const auto more = pictureWarnings(frame, scene(), info.times, output.width, output.height);
    const std::size_t ofData = warnings.size();
    warnings.insert(warnings.end(), more.begin(), more.end());
    info.dataWarnings = ofData;
    info.warnings = std::move(warnings);
    info.triangles = scene().allTriangles;
}

/// What is laid over the surface is found once, and kept.
void Renderer::State::requireRoomForOverlay()
{
    if (overlaysOf(description.shading.overlay).any() && !overlay.any())
        runTogether(
            group.communicator(), [&] { requireRoomForWhole(scene(), ranksOnHost, "--overlay"); }, false);
}

void Renderer::State::setLookOf(SceneDescription changed)
{
    std::swap(description, changed);
    try {
        requireRoomForOverlay();
        tell();
    } catch (...) {
        description = std::move(changed);
        throw;
    }
}

void Renderer::State::setGroup(SceneDescription changed, const char* key, const char* call)
{
    std::string text = groupText(changed, key);
    callTogether(
        group.communicator(), call, [&] { return text; }, [&] { validate(changed); });
    if (text != groupText(description, key)) setLookOf(std::move(changed));
}

void Renderer::State::setLook(StartedFrame& frame)
{
    frame.request.shading = description.shading;
    frame.request.lic = description.lic;
    frame.request.colorMap = colorMap();
    frame.request.colorMaps = surfaceColorMaps();
    frame.height = description.output.height;
    frame.time = now;
    frame.timeRange = description.time.range;
    if (frame.timeRange)
        for (double& end : *frame.timeRange) end = loaded->shownFor(end);
}

/// By the plan, which may have changed.
void Renderer::State::makeBackend()
{
    group.cycle().forget();
    backend = aeolic::makeBackend(group.communicator(), plan, scene());
    if (plan.missed) loaded->warn("the GPU is not used: " + plan.unusedGpu);
    info.unusedGpu = plan.unusedGpu;
    info.backend = backend->name();
    info.device = backend->device();
    info.simd = backend->simd();
}

/// The scene has moved on, perhaps to where the backend has no room for it. What is in flight comes first then.
void Renderer::State::moveBackend(const SceneChange& change)
{
    overlay.forget();
    group.cycle().forget();
    if (aeolic::moveBackend(group.communicator(), plan, change, *backend)) return;
    frames.finishAll(*backend, group);
    makeBackend();
}

/// Files are read from the folder where the first ones were, whatever folder the process is in by then.
void Renderer::State::namingAsGiven(const std::function<void()>& action)
{
    retelling(action, [&](std::string message) { return folder.asGiven(std::move(message)); });
}

std::vector<std::string> Renderer::State::sceneWarnings() const
{
    std::vector<std::string> warnings;
    for (const std::string& warning : scene().warnings) warnings.push_back(withoutControls(folder.asGiven(warning)));
    return warnings;
}

void Renderer::State::moveTo(double moment, double next)
{
    StopWatch watch;
    arena.execute([&] {
        SceneChange change;
        namingAsGiven([&] { change = loaded->moveTo(moment); });
        if (change.any()) moveBackend(change);
        loaded->readAhead(next);
    });
    stepMs += watch.lapMs();
    now = loaded->shownFor(moment);
    tell();
}

void Renderer::State::setShown(const std::vector<bool>& shown)
{
    arena.execute([&] {
        const SceneChange change = loaded->setShown(shown);
        if (change.any()) moveBackend(change);
    });
    ++revision;
    legend.reset();
    tell();
}

void Renderer::State::setData(const Data& memory, ProgressFunction progress)
{
    StopWatch watch;
    arena.execute([&] {
        SceneChange change;
        namingAsGiven([&] { change = loaded->replace(memory, now, reportTo(progress)); });
        if (change.any()) moveBackend(change);
    });
    stepMs += watch.lapMs();
    ++revision;
    info.fieldBytes = scene().field ? scene().field->bytes() : 0;
    info.fieldBytesOfRank = group.communicator().allGatherValue(std::int64_t(info.fieldBytes));
    legend.reset();
    tell();
}

std::vector<std::shared_ptr<const ColorMap>> Renderer::State::surfaceColorMaps()
{
    std::vector<std::shared_ptr<const ColorMap>> maps;
    for (const SceneColors& colors : scene().colors)
        maps.push_back(colorMap(colors.colorMap.value_or(description.shading.colormap)));
    return maps;
}

std::shared_ptr<const ColorMap> Renderer::State::colorMap(const std::string& name)
{
    std::shared_ptr<const ColorMap>& known = colorMaps[name];
    if (known) return known;
    auto map = std::make_shared<ColorMap>();
    runTogether(group.communicator(), [&] { *map = loadColorMap(name); });
    std::string bytes;
    for (const Color& color : map->colors) bytes.append(color.begin(), color.end());
    requireSame(group.communicator(), "the colour map " + name, bytes);
    return known = std::move(map);
}

Camera Renderer::State::cameraOf(const CameraOptions& options) const
{
    const OutputOptions& output = description.output;
    return makeCamera(sceneView(options, scene(), output.width, output.height), scene().boundsWorld, scene().fitRadius,
                      output.width, output.height, scene().reach);
}

CameraOptions Renderer::State::viewOfFrame(int index) const
{
    const OutputOptions& output = description.output;
    const double turn = output.frames > 1 ? orbitDegOf(description) * index / output.frames : 0.0;
    return orbited(sceneView(description.camera, scene(), output.width, output.height), turn, scene().boundsWorld);
}

double Renderer::State::phaseOfFrame(int index) const
{
    const LicOptions& lic = description.lic;
    if (lic.flow == FlowMotion::off) return lic.phase;
    return lic.phase + 2 * std::numbers::pi * index / description.output.frames;
}

std::optional<Corner> Renderer::State::steadyCorner(double next)
{
    const OutputOptions& output = description.output;
    if (output.frames == 1) return std::nullopt;
    const double first = description.time.range ? loaded->shownFor((*description.time.range)[0]) : info.time;
    StartedFrame frame;
    setLook(frame);
    frame.time = first;
    const FigureLayout layout(figureOf(frame, scene(), info.times), output.width, output.height);
    if (layout.barCorners.size() < 2) return layout.barCorners.empty() ? Corner::upperRight : layout.barCorners.front();
    const auto isFor = [&](const SteadyLegend& known) {
        return known.places == layout.barPlaces && known.width == output.width && known.height == output.height;
    };
    if (legend && isFor(*legend)) return legend->corner;
    if (now != first) moveTo(first, next);
    std::vector<View> views;
    for (const int index : sampledFrames(orbitDegOf(description) == 0 ? 1 : output.frames))
        views.push_back(makeView(cameraOf(viewOfFrame(index)), scene(), description.lic));
    const std::size_t place = arena.execute(
        [&] { return steadyLegendPlace(layout.barPlaces, views, scene(), *backend, group.communicator()); });
    legend = {layout.barCorners[place], layout.barPlaces, output.width, output.height};
    return legend->corner;
}

void Renderer::State::requireFrame(const FrameSpec& spec)
{
    SceneDescription asked;
    const auto* camera = std::get_if<CameraOptions>(&spec.view);
    if (camera) asked.camera = *camera;
    const auto text = [&] {
        const std::string view = camera ? groupText(asked, options::camera.key)
                                        : fmt::format("frame = {}\n", std::get<AnimationFrame>(spec.view).index);
        return fmt::format("gather = {}\n{}", spec.gather ? "on" : "off", view);
    };
    callTogether(group.communicator(), "start", text, [&] {
        if (camera) return validate(asked);
        const int index = std::get<AnimationFrame>(spec.view).index, ofAll = description.output.frames;
        if (index < 0 || index >= ofAll)
            throw InputError("frame", "found " + std::to_string(index),
                             "0 to " + std::to_string(ofAll - 1) + ", those of the animation");
    });
}

void Renderer::State::start(const FrameSpec& spec)
{
    requireFrame(spec);
    if (const auto* camera = std::get_if<CameraOptions>(&spec.view))
        return startView(*camera, description.lic.phase, spec.gather, info.time, std::nullopt);
    const int index = std::get<AnimationFrame>(spec.view).index, ofAll = description.output.frames;
    const auto& range = description.time.range;
    const double moment = range ? momentOfFrame(*range, index, ofAll) : info.time;
    const std::optional<Corner> corner = steadyCorner(moment);
    if (range) moveTo(moment, momentOfFrame(*range, std::min(index + 1, ofAll - 1), ofAll));
    startView(viewOfFrame(index), phaseOfFrame(index), spec.gather, range ? now : moment, corner);
}

void Renderer::State::startView(const CameraOptions& camera, double phase, bool gather, double moment,
                                std::optional<Corner> corner)
{
    if (now != moment) moveTo(moment, now);  // Whoever draws an animation and other views in turn comes back.
    StartedFrame& frame = frames.next(*backend);
    setLook(frame);
    FrameRequest& request = frame.request;
    request.camera = cameraOf(camera);
    request.lic.phase = phase;
    request.inCycle =
        description.lic.flow == FlowMotion::loop && orbitDegOf(description) == 0 && !description.time.range;
    frame.legendCorner = corner;
    frame.figure = figureOf(frame, scene(), info.times);
    frame.stepMs = std::exchange(stepMs, 0.0);
    frame.frame.tiles.gather = gather;
    arena.execute([&] {
        request.overlay = overlay.of(request.shading, whole());
        aeolic::startFrame(request, scene(), *backend, group, frame.frame);
    });
    frames.started();
}

const StartedFrame& Renderer::State::finish()
{
    callTogether(
        group.communicator(), "finish", [] { return std::string(); }, [] {});
    const StartedFrame& oldest = *arena.execute([&] { return &frames.finish(*backend, group); });
    last = oldest.frame.stats;
    last.time = oldest.time;
    last.stepMs = oldest.stepMs;
    return oldest;
}

}  // namespace aeolic
