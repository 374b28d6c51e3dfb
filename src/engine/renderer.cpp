#include "aeolic/renderer.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "aeolic/error.h"
#include "base/moved_from.h"
#include "cluster/comm/communicator.h"
#include "cluster/comm/hosts.h"
#include "cluster/comm/mpi_communicator.h"
#include "cluster/comm/together.h"
#include "description/option_table.h"
#include "description/overlays.h"
#include "description/scene_json.h"
#include "description/scene_text.h"
#include "description/validate.h"
#include "engine/flow_lines.h"
#include "engine/picture_buffers.h"
#include "engine/renderer_internals.h"
#include "engine/renderer_state.h"
#include "engine/surface_pick.h"
#include "engine/tile_picture.h"
#include "render/view.h"
#include "version.h"

namespace aeolic {
namespace {

/// What the data of all ranks have in common, a line for each array.
std::string arraysIn(const Data& data)
{
    std::string text;
    const auto add = [&](const char* what, const std::vector<NamedArray>& arrays) {
        text += std::string(what) + "\n";
        for (const NamedArray& array : arrays)
            text += array.name + " of " + std::to_string(array.values.components) + "\n";
    };
    if (data.surface) {
        add("a surface with arrays on points:", data.surface->pointArrays);
        add("on cells:", data.surface->cellArrays);
    }
    if (data.grid) {
        for (std::size_t i = 0; i < 3; ++i)
            text += fmt::format("{} samples from {} by {}\n", data.grid->dims[i], data.grid->origin[i],
                                data.grid->spacing[i]);
        add("a grid with arrays on points:", data.grid->pointArrays);
        add("on cells:", data.grid->cellArrays);
    }
    if (data.volume) {
        text += fmt::format("{} cells between {} points\n", data.volume->types.count, data.volume->points.count);
        for (const std::int64_t count : data.volume->dims) text += fmt::format("{} points along an axis\n", count);
        add("a volume with arrays on points:", data.volume->pointArrays);
        add("on cells:", data.volume->cellArrays);
    }
    return text;
}

std::string switchesText(const std::vector<bool>& switches)
{
    std::string text;
    for (const bool isOn : switches) text += std::string(text.empty() ? "" : ", ") + (isOn ? "on" : "off");
    return text;
}

/// What all ranks have in common of the scene. Each has threads of its own: nodes may differ, and the picture does not.
std::string commonOf(SceneDescription description)
{
    description.run.threads = 0;
    return sceneToJson(description);
}

/// What `find` finds in the whole scene. Collective: `call` is what all ranks ask for.
template <class State, class Find>
auto ofWholeScene(State& state, const char* call, const Find& find)
{
    callTogether(
        state.group.communicator(), call, [] { return std::string(); },
        [&] { requireRoomForWhole(state.scene(), state.ranksOnHost, call); });
    return state.arena.execute([&] {
        WholeScene whole = state.whole();
        return find(whole);
    });
}

}  // namespace

Renderer::Renderer(SceneDescription description, ProgressFunction progress)
    : Renderer(std::move(description), makeSerialCommunicator(), std::move(progress))
{
}

Renderer::Renderer(SceneDescription description, std::shared_ptr<Communicator> ranks, ProgressFunction progress)
    : Renderer(std::move(description), Data{}, std::move(ranks), std::move(progress))
{
}

Renderer::Renderer(SceneDescription description, const Data& data, ProgressFunction progress)
    : Renderer(std::move(description), data, makeSerialCommunicator(), std::move(progress))
{
}

Renderer::Renderer(SceneDescription description, const Data& data, std::shared_ptr<Communicator> ranks,
                   ProgressFunction progress)
    : Renderer(std::move(description), data, std::move(ranks), std::move(progress), nullptr)
{
}

Renderer::Renderer(SceneDescription description, const Data& data, std::shared_ptr<Communicator> ranks,
                   ProgressFunction progress, const State* before)
{
    if (!ranks) throw InputError("ranks", "found none", "a communicator, as joinRanks() gives it");
    Communicator& communicator = *ranks;
    nameMemory(description, data);
    callTogether(
        communicator, before ? "reload" : "Renderer", [] { return std::string(); },
        [&] {
            validate(description);
            if (data.grid && data.volume)
                throw InputError("data in memory", "found a grid and a volume", "one or the other");
        });
    requireSame(communicator, "aeolic's version", versionText);
    requireSame(communicator, "the scene", commonOf(description));
    requireSame(communicator, "the data in memory", arraysIn(data));
    const HostShare host = hostShare(communicator);
    runTogether(communicator, [&] {
        checkImageMemory(description.output.width, description.output.height);
        state_ = std::make_unique<State>(std::move(description), std::move(ranks), host.cores);
    });
    if (before) {  // Names of files and of colour maps mean what they meant before.
        state_->folder = before->folder;
        state_->colorMaps = before->colorMaps;
    }
    state_->colorMap();  // Before the data: a fault in it shows at once.
    for (const SurfaceItem& item : state_->description.surfaces)
        if (item.colormap) state_->colorMap(*item.colormap);
    state_->ranksOnHost = host.ranks;
    state_->load(data, std::move(progress));
}

std::shared_ptr<Communicator> joinRanks()
{
    return makeCommunicator();
}

std::shared_ptr<Communicator> joinRanks(const void* mpiCommunicator)
{
    if (!mpiCommunicator) throw InputError("joinRanks", "found a null pointer", "the address of an MPI_Comm");
    return makeMpiCommunicator(kMpiChunkBytes, mpiCommunicator);
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Renderer::State& Renderer::held() const
{
    return heldBy(state_, "Renderer");
}

int Renderer::framesInFlight() const
{
    return held().backend->framesInFlight();
}

void Renderer::start(const FrameSpec& spec)
{
    held().start(spec);
}

DrawnFrame Renderer::finish(Picture kept)
{
    const StartedFrame& done = held().finish();
    const FrameTiles& tiles = done.frame.tiles;
    Communicator& ranks = held().group.communicator();
    if (tiles.gather && !ranks.isRoot()) return {};
    const auto sumOfRanks = [&](std::vector<std::int64_t>& covered) {
        ranks.allReduce(std::span(covered), Reduction::sum);
    };
    return pictureOf(tiles, done.height, done.figure, done.legendCorner, sumOfRanks, std::move(kept));
}

DrawnFrame Renderer::render(const FrameSpec& spec, Picture kept)
{
    start(spec);
    return finish(std::move(kept));
}

void Renderer::setTime(double moment)
{
    SceneDescription changed = held().description;
    const bool isAnimated = changed.time.range.has_value();
    changed.time = {moment, std::nullopt};
    callTogether(
        held().group.communicator(), "setTime", [&] { return groupText(changed, options::time.key); },
        [&] { validate(changed); });
    const double next = moment + (moment - held().info.time);  // Whoever scrubs or plays goes on as far.
    // The animation's range stays, and its legend goes by its own first moment.
    if (!isAnimated) std::swap(held().description, changed);
    try {
        held().moveTo(moment, next);
    } catch (...) {
        if (!isAnimated) held().description = std::move(changed);
        throw;
    }
    held().info.time = held().now;
    ++held().revision;
    if (isAnimated) return;
    held().legend.reset();
}

void Renderer::setShown(const std::vector<bool>& shown)
{
    std::vector<SurfaceItem>& surfaces = held().description.surfaces;
    callTogether(
        held().group.communicator(), "setShown", [&] { return switchesText(shown); },
        [&] {
            if (shown.size() != surfaces.size())
                throw InputError("surfaces", "found " + std::to_string(shown.size()) + " switches",
                                 surfaces.empty()
                                     ? "none: there is one surface, which is always drawn"
                                     : std::to_string(surfaces.size()) + ", one for each of several surfaces");
        });
    for (std::size_t i = 0; i < shown.size(); ++i) surfaces[i].shown = shown[i];
    held().setShown(shown);
}

void Renderer::reload(SceneDescription description, ProgressFunction progress)
{
    *this = Renderer(std::move(description), {}, held().group.shared(), std::move(progress), &held());
}

void Renderer::setData(const Data& data, ProgressFunction progress)
{
    callTogether(
        held().group.communicator(), "setData", [&] { return arraysIn(data); }, [] {});
    held().setData(data, std::move(progress));
}

void Renderer::setLic(const LicOptions& lic)
{
    SceneDescription changed = held().description;
    changed.lic = lic;
    held().setGroup(std::move(changed), options::lic.key, "setLic");
}

void Renderer::setShading(const ShadingOptions& shading)
{
    SceneDescription changed = held().description;
    changed.shading = shading;
    held().setGroup(std::move(changed), options::shading.key, "setShading");
}

FlowTopology Renderer::topology()
{
    State& state = held();
    return ofWholeScene(state, "topology", [&](WholeScene& whole) {
        return flowTopology(whole.scene(), state.description.shading.persistence, whole.lookUp());
    });
}

FlowTopology Renderer::separation()
{
    State& state = held();
    return ofWholeScene(state, "separation", [&](WholeScene& whole) {
        return openLines(whole.scene(), state.description.shading.persistence, whole.lookUp());
    });
}

EvenSurfaceLines Renderer::streamlines()
{
    State& state = held();
    const double asked = overlaysOf(state.description.shading.overlay).streamlinesPx;
    const View view = makeView(state.cameraOf(state.viewOfFrame(0)), state.scene(), state.description.lic);
    return ofWholeScene(state, "streamlines", [&](WholeScene& whole) {
        return surfaceStreamlines(whole.scene(), view, asked > 0 ? asked : Overlays::kUsualSpacingPx, whole.lookUp());
    });
}

std::optional<PickedPlace> Renderer::pick(int x, int y, const std::optional<CameraOptions>& camera)
{
    State& state = held();
    const OutputOptions& size = state.description.output;
    callTogether(
        state.group.communicator(), "pick",
        [&] {
            SceneDescription changed = state.description;
            if (camera) changed.camera = *camera;
            return fmt::format("{},{} {}", x, y, groupText(changed, options::camera.key));
        },
        [&] {
            if (x < 0 || y < 0 || x >= size.width || y >= size.height)
                throw InputError("pick", fmt::format("pixel {},{}", x, y),
                                 fmt::format("0,0 to {},{}", size.width - 1, size.height - 1));
        });
    const Camera view = state.cameraOf(camera ? *camera : state.viewOfFrame(0));
    return state.arena.execute([&] { return state.whole().pick(view, x, y); });
}

PictureBuffers Renderer::buffers(const std::optional<CameraOptions>& camera)
{
    State& state = held();
    if (state.frames.any()) throw std::logic_error("buffers() while a frame is started and not finished");
    const DrawnFrame rows = render(camera ? FrameSpec{*camera, false} : FrameSpec{AnimationFrame{}, false});
    const View view =
        makeView(state.cameraOf(camera ? *camera : state.viewOfFrame(0)), state.scene(), state.description.lic);
    const Extent own{0, rows.firstRow, state.description.output.width, rows.firstRow + rows.height};
    PictureBuffers mine;
    runTogether(state.group.communicator(), [&] {
        mine = state.arena.execute([&] { return buffersOf(*state.backend, view, state.scene(), own); });
    });
    return gathered(mine, state.group.communicator());
}

void Renderer::setSize(int width, int height)
{
    SceneDescription changed = held().description;
    changed.output.width = width;
    changed.output.height = height;
    const OutputOptions& now = held().description.output;
    const bool isNew = width != now.width || height != now.height;
    callTogether(
        held().group.communicator(), "setSize", [&] { return groupText(changed, options::output.key); },
        [&] {
            validate(changed);
            if (isNew) checkImageMemory(width, height);  // Asks the system. A view sets its size with each frame.
        });
    if (isNew) held().setLookOf(std::move(changed));
}

const SceneInfo& Renderer::info() const
{
    return held().info;
}
const FrameStats& Renderer::lastFrame() const
{
    return held().last;
}
const SceneDescription& Renderer::description() const
{
    return held().description;
}

const Scene& RendererInternals::scene(const Renderer& renderer)
{
    return renderer.held().scene();
}
const ColorMap& RendererInternals::colorMap(const Renderer& renderer)
{
    const Renderer::State& state = renderer.held();
    return *state.colorMaps.at(state.description.shading.colormap);
}
const std::shared_ptr<Communicator>& RendererInternals::ranks(const Renderer& renderer)
{
    return renderer.held().group.shared();
}
std::uint64_t RendererInternals::revision(const Renderer& renderer)
{
    return renderer.held().revision;
}

}  // namespace aeolic
