#include "aeolic/stream_client.h"

#include <stdexcept>

#include "aeolic/error.h"
#include "base/moved_from.h"
#include "stream/client/frame_assembler.h"
#include "stream/client/web_socket.h"
#include "stream/requests.h"

namespace aeolic {

using namespace stream;

struct StreamClient::State {
    Options options;
    std::unique_ptr<ClientWebSocket> socket;
    FrameAssembler frames;
    std::uint32_t viewer = 0, lastView = 0;
    std::string scene, state;

    /// Takes the next message. Returns a frame if the message made it whole.
    std::optional<StreamFrame> step()
    {
        const ByteVector bytes = socket->receive(options.timeout);
        const MessageView message = parseMessage(bytes, Sender::gateway);
        const std::string_view text(reinterpret_cast<const char*>(message.payload.data()), message.payload.size());
        switch (message.type) {
            case MessageType::welcome:
                viewer = parseJson(message.payload).value("viewer", 0u);
                break;
            case MessageType::scene:
                scene = text;
                break;
            case MessageType::state:
                state = text;
                if (const Json json = parseJson(message.payload); json.value("state", "") == "failed")
                    throw std::runtime_error("the server gave up: " + json.value("message", ""));
                break;
            case MessageType::notice:
                if (const Json json = parseJson(message.payload); json.value("level", "") == "error")
                    throw std::runtime_error("the server says: " + json.value("message", ""));
                break;
            default:
                return frames.take(message);
        }
        return std::nullopt;
    }
};

StreamClient::StreamClient(const std::string& address) : StreamClient(address, Options()) {}

StreamClient::StreamClient(const std::string& address, const Options& options) : state_(std::make_unique<State>())
{
    State& s = *state_;
    s.options = options;
    StreamAddress place = parseStreamAddress(address);
    if (place.token.empty()) place.token = options.token;
    s.socket = openWebSocket(place, options.trustAnyCertificate, options.timeout);
    Json codecs = Json::array();
    for (const Codec codec : {Codec::lz4, Codec::png, Codec::lzo, Codec::jpeg})
        if (available(codec) && (codec != Codec::jpeg || options.lossy))
            codecs.push_back(std::string(codecName(codec)));
    const Json hello{{"codecs", codecs}, {"direct", false}, {"name", options.name}};
    s.socket->send(jsonMessage(MessageType::hello, jsonText(hello)), options.timeout);
    while (s.viewer == 0) s.step();
}

StreamClient::~StreamClient() = default;
StreamClient::StreamClient(StreamClient&&) noexcept = default;
StreamClient& StreamClient::operator=(StreamClient&&) noexcept = default;

StreamClient::State& StreamClient::held() const
{
    return heldBy(state_, "StreamClient");
}

std::string StreamClient::scene()
{
    while (held().scene.empty()) held().step();
    return held().scene;
}

std::uint32_t StreamClient::requestView(const StreamView& view)
{
    Json request{{"view", ++held().lastView}, {"moving", view.moving}, {"width", view.width}, {"height", view.height}};
    if (!view.options.empty()) {
        const Json options = parseJson(view.options);
        if (!options.is_object())
            throw InputError("view", "found options that are not an object", "JSON as in a scene file");
        request.update(options);
    }
    held().frames.asked(view.width, view.height);
    held().socket->send(jsonMessage(MessageType::view, request.dump()), held().options.timeout);
    return held().lastView;
}

void StreamClient::change(const std::string& json)
{
    held().socket->send(jsonMessage(MessageType::change, json), held().options.timeout);
}

StreamFrame StreamClient::nextFrame()
{
    for (;;) {
        auto frame = held().step();
        if (!frame) continue;
        held().socket->send(numberMessage(MessageType::shown, frame->frame), held().options.timeout);
        return std::move(*frame);
    }
}

StreamFrame StreamClient::grab(StreamView view)
{
    scene();
    view.moving = false;
    const std::uint32_t number = requestView(view);
    for (;;) {
        StreamFrame frame = nextFrame();
        if (frame.view == number && frame.viewer == held().viewer && frame.lossless) return frame;
    }
}

const std::string& StreamClient::state() const
{
    return held().state;
}
std::uint32_t StreamClient::viewer() const
{
    return held().viewer;
}

}  // namespace aeolic
