#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "aeolic/renderer.h"
#include "stream/job/job_link.h"
#include "stream/job/tile_server.h"
#include "stream/requests.h"

namespace aeolic::stream {

/// What every job does for its gateway, whatever it draws: frames that are asked for are drawn and sent, and what
/// cannot be done is told. Each rank has one.
class JobFrames {
public:
    /// `tiles`: where viewers get tiles from this rank itself; null: through the gateway.
    JobFrames(std::shared_ptr<Communicator> ranks, JobLink& link, TileServer* tiles);

    /// Collective. Starts a frame with the options and the size that `request` has. A fault in them is told.
    void start(Renderer* renderer, const DrawRequest& request);
    /// Collective. Finishes the oldest frame that was started, and sends this rank's rows.
    void finish(Renderer& renderer);
    std::size_t started() const { return started_.size(); }
    /// Collective. Tells what the view of the probe shows at its pixel. Between frames alone.
    void probe(Renderer* renderer, const ProbeRequest& request);

    /// Rank 0's messages to the gateway. Other ranks say nothing.
    void say(MessageType type, const Json& json);
    /// Tells why the Load or the frame (`what`) with this number was not done.
    void complain(const std::string& message, const char* what, const Json& number);
    /// Sends what there is to know of the scene, as the answer to the Load with this number; null: unasked.
    void report(Json report, const Json& load);

    /// Runs something that may fail because of the user's input. Rank 0 then says why, and the job goes on. Where a
    /// device failed, or where one rank failed alone, the error goes on.
    void tryOrTell(const char* what, const Json& number, const std::function<void()>& action);

private:
    void sendTile(const DrawRequest& request, const WireMessage& tile);
    struct Started {
        DrawRequest request;
        std::vector<std::string> warnings;  ///< Of its options, beside the scene's.
    };
    void sayFrameEnd(const Renderer& renderer, const Started& frame, double encodeMs, std::size_t bytes);

    std::shared_ptr<Communicator> ranks_;
    JobLink& link_;
    TileServer* tiles_;
    std::deque<Started> started_;  ///< Frames being drawn, the oldest first.
    DrawnFrame stripe_;            ///< The rows of the frame finished last.
};

/// Collective. Shows the moment that `asked` names, if it names one, and those of the surfaces that it has switched on.
/// `asked` has the renderer's own surfaces.
void show(const SceneDescription& asked, Renderer& renderer);

/// Collective. The gateway's address, on all ranks. `line`: what addressToJson() wrote; that of rank 0 counts.
GatewayAddress addressForAll(Communicator& ranks, const std::string& line);

/// What the gateway has to know about this rank when it joins.
Json aboutThisRank(const Communicator& ranks, const TileServer* tiles);

}  // namespace aeolic::stream
