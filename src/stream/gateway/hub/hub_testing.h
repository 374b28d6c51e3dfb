#pragma once

#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "description/scene_json.h"
#include "stream/gateway/hub/hub.h"

/// A hub without sockets and processes: viewers, job and clock are the test's.
namespace aeolic::stream::test {

inline Json jsonOf(const WireMessage& message, std::size_t skip = 0)
{
    return Json::parse(message->begin() + std::ptrdiff_t(kHeaderBytes + skip), message->end());
}

/// A viewer that keeps what it gets.
class FakeViewer : public ViewerPort {
public:
    void send(WireMessage message) override
    {
        EXPECT_NO_THROW(parseMessage(*message, Sender::gateway)) << "nothing goes out that viewers must refuse";
        messages.push_back(std::move(message));
    }
    void close(std::uint16_t code, const std::string&) override { closedWith = code; }
    int framesQueued() const override { return queued; }
    std::optional<std::uint32_t> oldestQueued() const override
    {
        return queued > 0 ? std::optional(oldest) : std::nullopt;
    }
    bool isOpen() const override { return closedWith == 0; }

    /// The messages of that type since the last look. They are forgotten; messages of other types stay.
    std::vector<WireMessage> taken(MessageType type)
    {
        std::vector<WireMessage> found;
        std::erase_if(messages, [&](const WireMessage& message) {
            if (MessageType((*message)[2]) != type) return false;
            found.push_back(message);
            return true;
        });
        return found;
    }
    /// Frame numbers that were begun, and that came to their end, since the last look.
    std::vector<std::uint32_t> begun()
    {
        std::vector<std::uint32_t> frames;
        for (const WireMessage& message : taken(MessageType::frame)) frames.push_back(header(message).frame);
        return frames;
    }
    std::vector<std::uint32_t> ended()
    {
        std::vector<std::uint32_t> frames;
        for (const WireMessage& message : taken(MessageType::frameEnd))
            frames.push_back(WireReader(ByteView(*message).subspan(kHeaderBytes)).u32());
        return frames;
    }
    static FrameHeader header(const WireMessage& message)
    {
        return parseFrame(ByteView(*message).subspan(kHeaderBytes));
    }
    /// The numbers of changes that were answered since the last look.
    std::vector<std::uint32_t> answered()
    {
        std::vector<std::uint32_t> changes;
        for (const WireMessage& message : taken(MessageType::changed))
            changes.push_back(WireReader(ByteView(*message).subspan(kHeaderBytes)).u32());
        return changes;
    }
    /// What the last State says.
    Json state()
    {
        const auto states = taken(MessageType::state);
        return states.empty() ? Json() : jsonOf(states.back());
    }
    std::string errors()
    {
        std::string all;
        for (const WireMessage& message : taken(MessageType::notice)) {
            const Json notice = jsonOf(message);
            if (notice["level"] == "error") all += notice["message"].get<std::string>() + "\n";
        }
        return all;
    }

    std::vector<WireMessage> messages;
    int closedWith = 0;
    int queued = 0;            ///< Frames that it does not read.
    std::uint32_t oldest = 1;  ///< The first of them.
    std::uint32_t id = 0;
};

class HubTest : public testing::Test {
protected:
    HubTest() : HubTest(Hub::Options{}) {}
    explicit HubTest(Hub::Options options)
        : hub(
              std::move(options), [this](WireMessage message) { toJob.push_back(std::move(message)); },
              [this] { return now; })
    {
    }

    // ---- Viewers.
    void join(FakeViewer& viewer, std::vector<Codec> codecs = {Codec::jpeg, Codec::png, Codec::lz4},
              const std::string& name = "v")
    {
        viewer.id = hub.join(viewer, {std::move(codecs), false, name});
    }
    void receive(const FakeViewer& viewer, const WireMessage& message)
    {
        hub.receive(viewer.id, parseMessage(*message, Sender::viewer));
    }
    /// Sends a view with that number and these options.
    void look(const FakeViewer& viewer, std::uint32_t number, bool moving = true, const std::string& options = "{}",
              int width = 40, int height = 30)
    {
        Json view{{"view", number}, {"moving", moving}, {"width", width}, {"height", height}};
        view.update(Json::parse(options));
        receive(viewer, jsonMessage(MessageType::view, view.dump()));
    }
    void shown(const FakeViewer& viewer, std::uint32_t frame)
    {
        receive(viewer, numberMessage(MessageType::shown, frame));
    }
    void follow(const FakeViewer& viewer, std::uint32_t other)
    {
        receive(viewer, numberMessage(MessageType::follow, other));
    }
    void change(const FakeViewer& viewer, const std::string& json)
    {
        receive(viewer, jsonMessage(MessageType::change, json));
    }

    // ---- The job.
    std::vector<WireMessage> sentToJob(MessageType type)
    {
        std::vector<WireMessage> found;
        std::erase_if(toJob, [&](const WireMessage& message) {
            EXPECT_NO_THROW(parseMessage(*message, Sender::gatewayToRank));
            if (MessageType((*message)[2]) != type) return false;
            found.push_back(message);
            return true;
        });
        return found;
    }
    /// The draws since the last look.
    std::vector<DrawRequest> draws()
    {
        std::vector<DrawRequest> found;
        for (const WireMessage& message : sentToJob(MessageType::draw)) found.push_back(drawFrom(jsonOf(message)));
        return found;
    }
    std::vector<Json> loads()
    {
        std::vector<Json> found;
        for (const WireMessage& message : sentToJob(MessageType::load)) found.push_back(jsonOf(message));
        return found;
    }
    void say(MessageType type, const Json& json) { hub.jobSaid(jsonMessage(type, json.dump())); }
    void sceneLoaded(const Json& load, int framesInFlight = 1)
    {
        say(MessageType::scene, {{"load", load["load"]}, {"scene", load["scene"]}, {"framesInFlight", framesInFlight}});
    }
    /// Starts the job and loads what it is told to.
    void startJob(int ranks = 1, int framesInFlight = 1)
    {
        hub.jobStarting();
        hub.jobStarted(ranks);
        const auto asked = loads();
        ASSERT_EQ(asked.size(), 1u);
        sceneLoaded(asked[0], framesInFlight);
    }
    void tile(const DrawRequest& draw, int firstRow, int rows, int rank = 0)
    {
        ByteVector message = beginMessage(MessageType::tile);
        putTileHeader(message,
                      {draw.frame, std::uint32_t(firstRow), std::uint32_t(rows), std::uint32_t(draw.scene.output.width),
                       std::uint16_t(rank), std::uint8_t(draw.codec), 3, 0});
        putText(message, "pixels");
        hub.jobSaid(endMessage(std::move(message)));
    }
    void frameEnd(const DrawRequest& draw) { hub.jobSaid(frameEndMessage(draw.frame, "{}")); }
    /// Draws a whole frame.
    void finish(const DrawRequest& draw)
    {
        tile(draw, 0, draw.scene.output.height);
        frameEnd(draw);
    }
    /// The one draw that is under way. Fails if there is none or more than one.
    DrawRequest onlyDraw()
    {
        auto all = draws();
        EXPECT_EQ(all.size(), 1u);
        return all.empty() ? DrawRequest{} : all.back();
    }
    /// Asks for a view, draws it and shows it. Returns its frame.
    std::uint32_t see(const FakeViewer& viewer, std::uint32_t number, bool moving = true)
    {
        look(viewer, number, moving);
        const DrawRequest draw = onlyDraw();
        finish(draw);
        shown(viewer, draw.frame);
        return draw.frame;
    }

    std::vector<WireMessage> toJob;
    SteadyClock::time_point now{std::chrono::hours(1)};
    Hub hub;
};

}  // namespace aeolic::stream::test
