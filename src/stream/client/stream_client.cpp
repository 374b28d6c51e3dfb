#include "aeolic/stream_client.h"

#include <stdexcept>

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
    s.socket->send(jsonMessage(MessageType::hello, hello.dump()), options.timeout);
    while (s.viewer == 0) s.step();
}

StreamClient::~StreamClient() = default;
StreamClient::StreamClient(StreamClient&&) noexcept = default;
StreamClient& StreamClient::operator=(StreamClient&&) noexcept = default;

std::string StreamClient::scene()
{
    while (state_->scene.empty()) state_->step();
    return state_->scene;
}

std::uint32_t StreamClient::requestView(const StreamView& view)
{
    Json request{{"view", ++state_->lastView}, {"moving", view.moving}, {"width", view.width}, {"height", view.height}};
    if (!view.options.empty()) request.update(parseJson(view.options));
    state_->frames.asked(view.width, view.height);
    state_->socket->send(jsonMessage(MessageType::view, request.dump()), state_->options.timeout);
    return state_->lastView;
}

void StreamClient::change(const std::string& json)
{
    state_->socket->send(jsonMessage(MessageType::change, json), state_->options.timeout);
}

StreamFrame StreamClient::nextFrame()
{
    for (;;) {
        auto frame = state_->step();
        if (!frame) continue;
        state_->socket->send(numberMessage(MessageType::shown, frame->frame), state_->options.timeout);
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
        if (frame.view == number && frame.viewer == state_->viewer && frame.lossless) return frame;
    }
}

const std::string& StreamClient::state() const
{
    return state_->state;
}
std::uint32_t StreamClient::viewer() const
{
    return state_->viewer;
}

}  // namespace aeolic
