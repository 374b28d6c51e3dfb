#include "stream/job/render_job.h"

#include <unistd.h>

#include <deque>
#include <istream>
#include <optional>

#include "aeolic/error.h"
#include "base/timing.h"
#include "cluster/comm/agreement.h"
#include "cluster/comm/communicator.h"
#include "cluster/comm/hosts.h"
#include "data/scene.h"
#include "description/scene_json.h"
#include "render/backend.h"
#include "stream/job/job_link.h"
#include "stream/job/scene_report.h"
#include "stream/job/stripe_sender.h"
#include "stream/job/tile_server.h"

namespace aeolic::stream {
namespace {

/// Collective. Rank 0 reads the address on its standard input and tells the others.
GatewayAddress gatewayAddress(Communicator& ranks, std::istream& line)
{
    Bytes bytes;
    if (ranks.isRoot()) {
        std::string text;
        std::getline(line, text);
        const auto all = std::as_bytes(std::span(text));
        bytes.assign(all.begin(), all.end());
    }
    ranks.broadcast(bytes, 0);
    return addressFromJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// What the gateway has to know about this rank.
Json aboutThisRank(const Communicator& ranks, const TileServer* server)
{
    return {{"rank", ranks.rank()},
            {"ranks", ranks.size()},
            {"host", placeOfThisProcess().host},
            {"pid", getpid()},
            {"direct", server ? Json(server->port()) : Json()}};
}

class RenderJob {
public:
    RenderJob(std::shared_ptr<Communicator> ranks, const GatewayAddress& address)
        : ranks_(std::move(ranks)),
          tiles_(address.direct ? std::make_unique<TileServer>(address.everywhere, address.directPorts,
                                                               TileServer::Limits{.bytes = address.directBytes})
                                : nullptr),
          // Other ranks may be waiting for this one, so there is no way to leave together.
          link_(
              address, aboutThisRank(*ranks_, tiles_.get()), [] { _exit(1); },
              [this](const MessageView& message) { invite(parseJson(message.payload)); })
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
        }
        link_.close();
    }

private:
    void say(MessageType type, const Json& json)
    {
        if (ranks_->isRoot()) link_.send(jsonMessage(type, json.dump(-1, ' ', false, Json::error_handler_t::replace)));
    }

    void complain(const std::string& message, const char* what, const Json& number)
    {
        constexpr std::size_t most = 4096;  // Bytes; names in a message may be long.
        say(MessageType::notice, {{"level", "error"}, {"message", message.substr(0, most)}, {what, number}});
    }

    /// Runs something that may fail because of the user's input. Rank 0 then says why, and the job goes on. Where a
    /// device failed the job ends, and another has to be started.
    template <class Action>
    void tryOrTell(const char* what, const Json& number, const Action& action)
    {
        try {
            action();
        } catch (const DeviceError&) {
            throw;
        } catch (const std::exception& error) {
            const bool everywhere = ranks_->size() == 1 || dynamic_cast<const Agreed*>(&error);
            if (!everywhere) throw;
            complain(error.what(), what, number);
        }
    }

    void load(const Json& request)
    {
        const Json number = request.at("load");
        tryOrTell("load", number, [&] {
            const SceneDescription scene = sceneFromJson(request.at("scene").dump(), "");
            if (renderer_ && scene.time.moment && differOnlyInTime(scene, loaded_)) {
                renderer_->setTime(*scene.time.moment);
                loaded_ = scene;
                return report(number);
            }
            StopWatch since;
            double lastMs = -1e9, passedMs = 0;
            const auto progress = [&](const char* stage, double fraction) {
                passedMs += since.lapMs();
                if (passedMs - lastMs < 100) return;  // Ten a second are enough to look at.
                lastMs = passedMs;
                say(MessageType::progress, {{"load", number}, {"what", stage}, {"fraction", fraction}});
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
        report["load"] = number;
        report["scene"] = Json::parse(sceneToJson(loaded_));  // Views may have changed the renderer's options since.
        // The gateway adds the surface, which a viewer has named in one message.
        constexpr std::size_t room = 64 << 10;
        const std::size_t bytes = report.dump(-1, ' ', false, Json::error_handler_t::replace).size() + room;
        const std::size_t most = payloadLimit(std::uint8_t(MessageType::scene), Sender::rank);
        if (bytes > most)
            return complain(
                InputError("scene", "found " + std::to_string(bytes >> 10) + " KiB of times, arrays and names",
                           "at most " + std::to_string(most >> 10) + " KiB, for viewers to choose from")
                    .what(),
                "load", number);
        say(MessageType::scene, report);
    }

    /// Draws this frame, and those that are asked for meanwhile: a GPU draws the next one while the frame before is
    /// packed and sent.
    void drawAll(WireMessage message)
    {
        for (;;) {
            if (message) start(drawFrom(parseJson(parseMessage(*message, Sender::gatewayToRank).payload)));
            if (started_.empty()) return;
            message = roomForAnother() && anotherIsAskedFor() ? link_.receive() : nullptr;
            if (!message) finish();
        }
    }

    bool roomForAnother() const { return int(started_.size()) < renderer_->framesInFlight(); }

    /// Collective. Requests reach the ranks at different times, and all ranks have to do the same: rank 0 decides.
    bool anotherIsAskedFor()
    {
        const bool here = link_.isNext(MessageType::draw);
        if (ranks_->size() == 1) return here;
        Bytes answer(1, std::byte(here));
        ranks_->broadcast(answer, 0);
        return answer[0] != std::byte(0);
    }

    void start(const DrawRequest& request)
    {
        tryOrTell("frame", request.frame, [&] {
            if (!renderer_) throw InputError("no scene is loaded");
            renderer_->setLic(request.scene.lic);
            renderer_->setShading(request.scene.shading);
            const OutputOptions& size = request.scene.output;
            renderer_->setSize(size.width, size.height);
            renderer_->startStripe(request.scene.camera);
            started_.push_back(request);
        });
    }

    void finish()
    {
        const DrawRequest request = std::move(started_.front());
        started_.pop_front();
        tryOrTell("frame", request.frame, [&] {
            stripe_ = renderer_->finishStripe(std::move(stripe_));
            StopWatch watch;
            const std::size_t bytes =
                sendStripe(stripe_, request, ranks_->rank(), [&](const WireMessage& tile) { sendTile(request, tile); });
            sayFrameEnd(request.frame, watch.lapMs(), bytes);
        });
    }

    void invite(const Json& invitation)
    {
        if (tiles_) tiles_->invite(invitation.at("viewer"), invitation.at("token"));
    }

    /// Sends a tile to the viewer itself, and tells the gateway which rows went; or sends it through the gateway.
    void sendTile(const DrawRequest& request, const WireMessage& tile)
    {
        if (!request.direct || !tiles_ || !tiles_->send(request.viewer, tile)) return link_.send(tile);
        ByteVector sent = beginMessage(MessageType::tile, kTileHeaderBytes);
        sent.insert(sent.end(), tile->begin() + kHeaderBytes, tile->begin() + kHeaderBytes + kTileHeaderBytes);
        link_.send(endMessage(std::move(sent)));
    }

    void sayFrameEnd(std::uint32_t frame, double encodeMs, std::size_t bytes)
    {
        if (!ranks_->isRoot()) return;
        const FrameStats& stats = renderer_->lastFrame();
        Json ranks = Json::array();
        for (const RankStats& rank : stats.ranks)
            ranks.push_back(
                {{"rank", rank.rank}, {"firstRow", rank.firstRow}, {"rows", rank.rows}, {"busyMs", rank.busyMs}});
        const Json end{{"totalMs", stats.totalMs},
                       {"stagesMs",
                        {{"balance", stats.balanceMs},
                         {"project", stats.projectMs},
                         {"composite", stats.compositeMs},
                         {"convolve", stats.convolveMs},
                         {"shade", stats.shadeMs}}},
                       {"encodeMs", encodeMs},
                       {"bytes", bytes},
                       {"ranks", ranks}};
        link_.send(frameEndMessage(frame, end.dump()));
    }

    std::shared_ptr<Communicator> ranks_;
    std::unique_ptr<TileServer> tiles_;  ///< With --direct.
    JobLink link_;
    std::optional<Renderer> renderer_;
    SceneDescription loaded_;          ///< The scene as the gateway asked for it.
    std::deque<DrawRequest> started_;  ///< Frames being drawn, the oldest first.
    PictureStripe stripe_;             ///< The rows of the frame finished last.
};

}  // namespace

void runRenderJob(const std::shared_ptr<Communicator>& ranks, std::istream& addressLine)
{
    RenderJob(ranks, gatewayAddress(*ranks, addressLine)).run();
}

}  // namespace aeolic::stream
