#pragma once

#include <map>
#include <memory>
#include <optional>

#include "records.h"
#include "stream/gateway/hub/hub.h"

namespace aeolic::stream::fuzz {

/// A viewer that looks at whatever it is sent as closely as a page must.
class FuzzViewer : public ViewerPort {
public:
    void send(WireMessage message) override
    {
        const MessageView view = parseMessage(*message, Sender::gateway);  // Throws out of the target where it is none.
        if (view.type == MessageType::frame) {
            ++open;
            lastFrame = parseFrame(view.payload).frame;
        }
    }
    void close(std::uint16_t, const std::string&) override { closed = true; }
    int framesQueued() const override { return 0; }
    std::optional<std::uint32_t> oldestQueued() const override { return std::nullopt; }
    bool isOpen() const override { return !closed; }

    std::uint32_t id = 0, lastFrame = 0, open = 0;
    bool closed = false;
};

/// A hub between viewers and a job that the input plays.
class FuzzHub {
public:
    FuzzHub()
        : hub(
              Hub::Options{}, [this](WireMessage message) { toJob(message); }, [this] { return now; })
    {
        hub.jobStarting();
        hub.jobStarted(2);
        load();
        for (FuzzViewer& viewer : viewers) join(viewer);
    }

    void join(FuzzViewer& viewer)
    {
        if (viewer.id != 0) hub.leave(viewer.id);
        viewer.closed = false;
        viewer.id = hub.join(viewer, {{Codec::jpeg, Codec::png, Codec::lz4}, false, "v"});
    }

    /// As a session does it: what is refused ends the connection; the viewer comes back.
    void viewerSays(FuzzViewer& viewer, ByteView bytes)
    {
        if (viewer.closed) join(viewer);
        try {
            const MessageView message = parseMessage(bytes, Sender::viewer);
            if (message.type == MessageType::hello) {
                const Hello hello = helloFrom(parseJson(message.payload));
                require(hello.name.size() <= 64);
                if (viewer.id != 0) hub.leave(viewer.id);
                viewer.id = hub.join(viewer, hello);
            } else {
                hub.receive(viewer.id, message);
            }
        } catch (const ProtocolError&) {
            join(viewer);
        }
    }

    /// As the links do it: what is refused ends the job, which is started again.
    void jobSays(const WireMessage& message)
    {
        try {
            hub.jobSaid(message);
        } catch (const ProtocolError&) {
            restart();
        }
    }

    void restart()
    {
        hub.jobEnded("ended");
        if (hub.sceneError()) return;
        hub.jobStarting();
        hub.jobStarted(2);
        load();
    }
    void load()
    {
        jobSays(jsonMessage(MessageType::scene, Json{{"load", lastLoad}, {"scene", Json::object()}}.dump()));
    }

    /// The rows of the frame that is being drawn, or some of them.
    void drawRows(std::uint32_t first, std::uint32_t rows)
    {
        if (!drawing) return;
        ByteVector message = beginMessage(MessageType::tile);
        putTileHeader(message, {drawing->frame, first, rows, std::uint32_t(drawing->scene.output.width), 0,
                                std::uint8_t(drawing->codec), 3, 0});
        jobSays(endMessage(std::move(message)));
    }
    void endFrame()
    {
        if (drawing) jobSays(frameEndMessage(drawing->frame, "{}"));
    }

    FuzzViewer viewers[3];
    SteadyClock::time_point now{std::chrono::hours(1)};
    std::optional<DrawRequest> drawing;
    std::uint32_t lastLoad = 0;
    Hub hub;

private:
    void toJob(const WireMessage& message)
    {
        const MessageView view = parseMessage(*message, Sender::gatewayToRank);
        const Json json = parseJson(view.payload);
        if (view.type == MessageType::draw) {
            drawing = drawFrom(json);  // What the gateway asks for is what a rank takes.
            require(drawing->scene.output.width <= 4096 && drawing->scene.output.height <= 4096);
            require(drawing->scene.surface.spec == SceneDescription{}.surface.spec ||
                    drawing->scene.surface.spec.find(':') != std::string::npos ||
                    drawing->scene.surface.spec == "boundary");  // No file that a viewer named.
        } else if (view.type == MessageType::load) {
            lastLoad = json.at("load").get<std::uint32_t>();
        }
    }
};

/// The records of an input, 64 at most, on a hub of their own. `play(hub, record)`.
template <class Play>
void playAll(ByteView input, const Play& play)
{
    FuzzHub world;
    Record record;
    for (int count = 0; count < 64 && takeRecord(input, record); ++count) play(world, record);
}

}  // namespace aeolic::stream::fuzz
