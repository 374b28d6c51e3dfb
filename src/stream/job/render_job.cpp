#include "stream/job/render_job.h"

#include <unistd.h>

#include <istream>
#include <optional>

#include "base/timing.h"
#include "cluster/comm/communicator.h"
#include "description/scene_json.h"
#include "stream/job/job_frames.h"
#include "stream/job/job_link.h"
#include "stream/job/scene_report.h"
#include "stream/job/tile_server.h"

namespace aeolic::stream {
namespace {

class RenderJob {
public:
    RenderJob(std::shared_ptr<Communicator> ranks, const GatewayAddress& address)
        : ranks_(std::move(ranks)),
          tiles_(address.direct ? std::make_unique<TileServer>(address.everywhere, address.directPorts,
                                                               TileLimits{.bytes = address.directBytes})
                                : nullptr),
          // Other ranks may be waiting for this one, so there is no way to leave together.
          link_(
              address, aboutThisRank(*ranks_, tiles_.get()), [] { _exit(1); },
              [this](const MessageView& message) { invite(parseJson(message.payload)); }),
          frames_(ranks_, link_, tiles_.get())
    {
    }

    void run()
    {
        for (;;) {
            const WireMessage message = link_.receive();
            const MessageView view = parseMessage(*message, Sender::gatewayToRank);
            if (view.type == MessageType::quit) break;
            if (view.type == MessageType::load) load(parseJson(view.payload));
            if (view.type == MessageType::draw) drawAll(message);
            if (view.type == MessageType::probe)
                frames_.probe(renderer_ ? &*renderer_ : nullptr, probeFrom(parseJson(view.payload)));
        }
        link_.close();
    }

private:
    void load(const Json& request)
    {
        const Json number = request.at("load");
        frames_.tryOrTell("load", number, [&] {
            const SceneDescription scene = sceneFromJson(request.at("scene").dump(), "");
            if (renderer_ && differInWhatIsShown(scene, loaded_) && (scene.time.moment || !loaded_.time.moment)) {
                show(scene, *renderer_);
                loaded_ = scene;
                return report(number);
            }
            StopWatch since;
            double lastMs = -1e9, passedMs = 0;
            const auto progress = [&](const char* stage, double fraction) {
                passedMs += since.lapMs();
                if (passedMs - lastMs < 100) return;  // Ten a second are enough to look at.
                lastMs = passedMs;
                frames_.say(MessageType::progress, {{"load", number}, {"what", stage}, {"fraction", fraction}});
            };
            renderer_.emplace(Renderer(scene, ranks_, progress));
            loaded_ = scene;
            report(number);
        });
    }

    void report(const Json& number)
    {
        Json report = sceneReport(*renderer_);
        report["framesInFlight"] = renderer_->framesInFlight();
        report["scene"] = Json::parse(sceneToJson(loaded_));  // Views may have changed the renderer's options since.
        frames_.report(std::move(report), number);
    }

    /// Draws this frame, and those that are asked for meanwhile: a GPU draws the next one while the frame before is
    /// packed and sent.
    void drawAll(WireMessage message)
    {
        for (;;) {
            if (message)
                frames_.start(renderer_ ? &*renderer_ : nullptr,
                              drawFrom(parseJson(parseMessage(*message, Sender::gatewayToRank).payload)));
            if (frames_.started() == 0) return;
            message = roomForAnother() && anotherIsAskedFor() ? link_.receive() : nullptr;
            if (!message) frames_.finish(*renderer_);
        }
    }

    bool roomForAnother() const { return int(frames_.started()) < renderer_->framesInFlight(); }

    /// Collective. Requests reach the ranks at different times, and all ranks have to do the same: rank 0 decides.
    bool anotherIsAskedFor()
    {
        const bool here = link_.isNext(MessageType::draw);
        if (ranks_->size() == 1) return here;
        Bytes answer(1, std::byte(here));
        ranks_->broadcast(answer, 0);
        return answer[0] != std::byte(0);
    }

    void invite(const Json& invitation)
    {
        if (tiles_) tiles_->invite(invitation.at("viewer"), invitation.at("token"));
    }

    std::shared_ptr<Communicator> ranks_;
    std::unique_ptr<TileServer> tiles_;  ///< With --direct.
    JobLink link_;
    JobFrames frames_;
    std::optional<Renderer> renderer_;
    SceneDescription loaded_;  ///< The scene as the gateway asked for it.
};

}  // namespace

void runRenderJob(const std::shared_ptr<Communicator>& ranks, std::istream& addressLine)
{
    std::string line;
    if (ranks->isRoot()) std::getline(addressLine, line);
    RenderJob(ranks, addressForAll(*ranks, line)).run();
}

}  // namespace aeolic::stream
