#include "aeolic/renderer.h"

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "cluster/comm/agreement.h"
#include "cluster/comm/communicator.h"
#include "cluster/comm/hosts.h"
#include "cluster/comm/mpi_communicator.h"
#include "data/load/series/time_series.h"
#include "description/scene_json.h"
#include "description/validate.h"
#include "engine/renderer_state.h"
#include "engine/scene_figure.h"
#include "engine/tile_picture.h"
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
        add("a grid with arrays on points:", data.grid->pointArrays);
        add("on cells:", data.grid->cellArrays);
    }
    if (data.volume) {
        add("a volume with arrays on points:", data.volume->pointArrays);
        add("on cells:", data.volume->cellArrays);
    }
    return text;
}

/// What all ranks have in common of the scene. Each has threads of its own: nodes may differ, and the picture does not.
std::string commonOf(SceneDescription description)
{
    description.run.threads = 0;
    return sceneToJson(description);
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
{
    if (!ranks) throw InputError("ranks", "found none", "a communicator, as joinRanks() gives it");
    Communicator& communicator = *ranks;
    nameMemory(description, data);
    runTogether(communicator, [&] {
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
    state_->colorMap();  // Before the data: a fault in it shows at once.
    state_->load(host.ranks, data, std::move(progress));
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
    state_->placeLegend();
    if (const auto& range = state_->description.time.range) {
        const int next = std::min(index + 1, output.frames - 1);
        state_->moveTo(momentOfFrame(*range, index, output.frames), momentOfFrame(*range, next, output.frames));
    }
    start(state_->viewOfFrame(index));
}

Picture Renderer::finish(Picture kept)
{
    const StartedFrame& done = state_->finish();
    if (state_->group.rank() != 0) return {};
    return pictureOf(done.frame.tiles, done.height, figureOf(done, state_->scene(), state_->info.times),
                     done.legendPlace, std::move(kept));
}

PictureStripe Renderer::finishStripe(PictureStripe kept)
{
    const StartedFrame& done = state_->finish();
    const Tile& stripe = done.frame.tiles.stripe;
    const LegendPlace place{done.legendPlace, [&](std::vector<std::int64_t>& covered) {
                                state_->group.communicator().allReduce(std::span(covered), Reduction::sum);
                            }};
    return {pictureOf(stripe, done.height, figureOf(done, state_->scene(), state_->info.times), place,
                      std::move(kept.rows)),
            stripe.extent.y0, done.height};
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
    state_->moveTo(moment, moment + (moment - state_->info.time));  // Whoever scrubs or plays goes on as far.
    state_->description.time = {moment, std::nullopt};
    state_->forgetLegend();
}

void Renderer::setShown(const std::vector<bool>& shown)
{
    std::vector<SurfaceItem>& surfaces = state_->description.surfaces;
    runTogether(state_->group.communicator(), [&] {
        if (shown.size() != surfaces.size())
            throw InputError("surfaces", "found " + std::to_string(shown.size()) + " switches",
                             surfaces.empty() ? "none: there is one surface, which is always drawn"
                                              : std::to_string(surfaces.size()) + ", one for each of several surfaces");
    });
    for (std::size_t i = 0; i < shown.size(); ++i) surfaces[i].shown = shown[i];
    state_->setShown(shown);
}

void Renderer::setData(const Data& data, ProgressFunction progress)
{
    requireSame(state_->group.communicator(), "the data in memory", arraysIn(data));
    state_->setData(data, std::move(progress));
}

void Renderer::setLic(const LicOptions& lic)
{
    SceneDescription changed = state_->description;
    changed.lic = lic;
    validate(changed);
    state_->description = std::move(changed);
}

void Renderer::setShading(const ShadingOptions& shading)
{
    SceneDescription changed = state_->description;
    changed.shading = shading;
    validate(changed);
    std::swap(state_->description, changed);
    try {
        state_->colorMap();
    } catch (...) {
        state_->description = std::move(changed);
        throw;
    }
    state_->forgetLegend();
    state_->tell();
}

void Renderer::setSize(int width, int height)
{
    SceneDescription changed = state_->description;
    changed.output.width = width;
    changed.output.height = height;
    runTogether(state_->group.communicator(), [&] {
        validate(changed);
        checkImageMemory(width, height);
    });
    state_->description = std::move(changed);
    state_->forgetLegend();
    state_->tell();
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
    return state_->scene();
}
const ColorMap& Renderer::colorMap() const
{
    return *state_->colorMaps.at(state_->description.shading.colorMap);
}
const SceneDescription& Renderer::description() const
{
    return state_->description;
}
std::uint64_t Renderer::revision() const
{
    return state_->revision;
}
const std::shared_ptr<Communicator>& Renderer::ranks() const
{
    return state_->group.shared();
}

}  // namespace aeolic
