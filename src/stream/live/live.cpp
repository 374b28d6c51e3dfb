#include "aeolic/live.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <tuple>
#include <utility>

#include "aeolic/error.h"
#include "base/moved_from.h"
#include "cluster/comm/communicator.h"
#include "cluster/comm/hosts.h"
#include "cluster/comm/together.h"
#include "description/option_table.h"
#include "description/scene_json.h"
#include "description/scene_surfaces.h"
#include "engine/renderer_internals.h"
#include "stream/job/job_frames.h"
#include "stream/job/scene_report.h"
#include "stream/live/controls.h"
#include "stream/live/program_gateway.h"
#include "stream/token.h"

namespace aeolic {
namespace {

using namespace stream;

constexpr auto kLinkPatience = std::chrono::seconds(10);  // Messages reach the ranks at different times.

}  // namespace

struct Live::State {
    State(const Renderer& renderer, LiveOptions options);

    bool serve(Renderer& renderer, std::chrono::milliseconds wait);
    void tellChanges(const Renderer& renderer, std::uint64_t revision);
    std::int64_t requests(std::chrono::milliseconds wait);
    void handle(const WireMessage& message, Renderer& renderer);
    void load(const Json& request, Renderer& renderer);
    void report(const Renderer& renderer, const Json& load);

    std::shared_ptr<Communicator> ranks;
    std::function<void(Renderer&, const SceneDescription&, const ProgressFunction&)> reload;
    Controls controls;
    std::unique_ptr<ProgramGateway> gateway;  ///< On rank 0.
    std::string address;
    std::optional<JobLink> link;
    std::optional<JobFrames> frames;
    bool isOpen = true;
    std::optional<std::string> told;  ///< The scene and the controls that the gateway knows; nothing before it asked.
    std::uint64_t toldRevision = 0;
};

namespace {

/// Collective. Where one rank's are wrong or differ all throw: one would wait for the others forever.
Controls agreedControls(Communicator& ranks, const LiveOptions& options)
{
    std::optional<Controls> controls;
    callTogether(
        ranks, "Live", [] { return std::string(); }, [&] { controls.emplace(options.title, options.controls); });
    const Json common{{"reload", bool(options.reload)}, {"program", controls->toJson()}};
    requireSame(ranks, "the options of Live", common.dump(2));
    return std::move(*controls);
}

}  // namespace

Live::State::State(const Renderer& renderer, LiveOptions options)
    : ranks(RendererInternals::ranks(renderer)),
      reload(std::move(options.reload)),
      controls(agreedControls(*ranks, options))
{
    const HostShare host = hostShare(*ranks);
    const bool onOneHost = ranks->allReduce(std::int64_t(host.ranks), Reduction::min) == ranks->size();
    std::string joinAt;
    runTogether(*ranks, [&] {
        if (!ranks->isRoot()) return;
        if (options.host.empty()) throw InputError("host", "found ''", "an address of this host");
        checkWhole("largestSide", options.largestSide, options::side);
        if (!options.token.empty()) checkToken("token", options.token);
        Hub::Options hub;
        hub.scene = sceneShown(renderer);
        hub.largestSide = options.largestSide;
        hub.maxViewers = std::size_t(std::max(1, options.maxViewers));
        hub.ofProgram = true;
        WebServerOptions web;
        web.host = options.host;
        web.port = options.port;
        web.rules.token = options.token.empty() ? makeToken() : options.token;
        web.rules.embedded = options.embedded;
        gateway = std::make_unique<ProgramGateway>(std::move(hub), std::move(web), ranks->size(), onOneHost);
        address = gateway->address();
        joinAt = addressToJson(gateway->linkAddress());
    });
    const GatewayAddress place = addressForAll(*ranks, joinAt);
    runTogether(*ranks, [&] { link.emplace(place, aboutThisRank(*ranks, nullptr), [] {}); });
    frames.emplace(ranks, *link, nullptr);
    toldRevision = RendererInternals::revision(renderer);
}

void Live::State::report(const Renderer& renderer, const Json& load)
{
    told = sceneToJson(sceneShown(renderer)) + controls.toJson().dump();
    toldRevision = RendererInternals::revision(renderer);
    if (!ranks->isRoot()) return;
    Json scene = sceneReport(renderer);
    scene["framesInFlight"] = 1;
    scene["program"] = controls.toJson();
    if (!reload) {
        Json& choices = scene["choices"];
        choices["surfaces"] = {"original"};
        choices["isosurface"] = choices["vectors"] = Json::array();
        const std::string& color = renderer.description().shading.colorBy;
        choices["colorBy"] = color.empty() ? Json::array() : Json{color};
    }
    frames->report(std::move(scene), load);
}

void Live::State::tellChanges(const Renderer& renderer, std::uint64_t revision)
{
    if (!told) return;  // The gateway will ask.
    if (*told != sceneToJson(sceneShown(renderer)) + controls.toJson().dump()) return report(renderer, nullptr);
    if (std::exchange(toldRevision, revision) == revision) return;
    if (ranks->isRoot()) link->send(emptyMessage(MessageType::renewed));
}

/// How many messages all ranks have to handle now; -1 once nothing comes any more. Rank 0 decides.
std::int64_t Live::State::requests(std::chrono::milliseconds wait)
{
    std::int64_t count = std::int64_t(link->waiting(wait, 1));
    if (link->hasEnded()) count = -1;
    if (ranks->size() == 1) return count;
    Bytes decided(sizeof count);
    std::memcpy(decided.data(), &count, sizeof count);
    ranks->broadcast(decided);
    std::memcpy(&count, decided.data(), sizeof count);
    if (count <= 0) return count;
    const bool here = link->waiting(kLinkPatience, std::size_t(count)) >= std::size_t(count);
    return ranks->allReduce(std::int64_t(here), Reduction::min) ? count : -1;
}

bool Live::State::serve(Renderer& renderer, std::chrono::milliseconds wait)
{
    const std::uint64_t revision = RendererInternals::revision(renderer);
    callTogether(
        *ranks, "serve", [] { return std::string(); }, [] {});  // Rank 0's patience counts.
    if (!isOpen) return false;
    tellChanges(renderer, revision);
    const std::int64_t count = requests(wait);
    isOpen = count >= 0;
    for (std::int64_t i = 0; i < count; ++i) handle(link->receive(), renderer);
    return isOpen;
}

void Live::State::handle(const WireMessage& message, Renderer& renderer)
{
    const MessageView view = parseMessage(*message, Sender::gatewayToRank);
    if (view.type == MessageType::load) load(parseJson(view.payload), renderer);
    if (view.type != MessageType::draw && view.type != MessageType::probe) return;
    // Views of viewers stand in the place of the program's own options only while they are drawn.
    const SceneDescription own = renderer.description();
    if (view.type == MessageType::probe)
        frames->probe(&renderer, probeFrom(parseJson(view.payload)));
    else
        frames->start(&renderer, drawFrom(parseJson(view.payload)));
    if (frames->started() > 0) frames->finish(renderer);
    renderer.setLic(own.lic);
    renderer.setShading(own.shading);
    renderer.setSize(own.output.width, own.output.height);
}

/// A viewer asks for another moment, for controls, or for what only the program can load.
void Live::State::load(const Json& request, Renderer& renderer)
{
    const Json number = request.at("load");
    frames->tryOrTell("load", number, [&] {
        const SceneDescription asked = sceneFromJson(request.at("scene").dump(), "");
        if (request.contains("steer")) controls.apply(request["steer"]);
        if (told) {
            SceneDescription next = renderer.description();
            const auto wanted = [](const SceneDescription& of) {
                return std::tuple(surfacesText(of), of.field.vectors, of.shading.colorBy);
            };
            const bool other = wanted(asked) != wanted(next);
            if (other && !reload)
                throw InputError("change", "found another surface, vectors or colours",
                                 "those of the program, which shows what it has");
            next.surface = asked.surface;
            next.surfaces = asked.surfaces;
            next.field.vectors = asked.field.vectors;
            if (next.shading.colorBy != asked.shading.colorBy) next.shading.colorRange.reset();
            next.shading.colorBy = asked.shading.colorBy;
            const bool isAnimated = next.time.range.has_value();
            const double moment = asked.time.moment.value_or(renderer.info().time);
            if (asked.time.moment && !isAnimated) next.time = asked.time;
            if (!other) {
                show(asked, renderer);
            } else {
                reload(renderer, next, [&](const char* what, double fraction) {
                    frames->say(MessageType::progress, {{"load", number}, {"what", what}, {"fraction", fraction}});
                });
                if (isAnimated && moment != renderer.info().time) renderer.setTime(moment);  // It began with its range.
            }
        }
        report(renderer, number);
    });
}

Live::Live(const Renderer& renderer, LiveOptions options)
    : state_(std::make_unique<State>(renderer, std::move(options)))
{
}

Live::~Live() = default;
Live::Live(Live&&) noexcept = default;
Live& Live::operator=(Live&&) noexcept = default;

Live::State& Live::held() const
{
    return heldBy(state_, "Live");
}

const std::string& Live::address() const
{
    return held().address;
}

bool Live::serve(Renderer& renderer, std::chrono::milliseconds wait)
{
    return held().serve(renderer, wait);
}

double Live::value(const std::string& control) const
{
    return held().controls.value(control);
}

void Live::setValue(const std::string& control, double value)
{
    callTogether(
        *held().ranks, "setValue", [&] { return control + " = " + numberText(value); }, [] {});
    held().controls.set(control, value);
}

bool Live::waitForRequest(std::chrono::milliseconds time)
{
    return held().link->waiting(time, 1) > 0 || held().link->hasEnded();
}

}  // namespace aeolic
