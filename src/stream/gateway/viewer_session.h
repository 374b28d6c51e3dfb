#pragma once

#include <memory>

#include "stream/beast.h"
#include "stream/gateway/hub.h"
#include "stream/gateway/request_rate.h"
#include "stream/http_request.h"
#include "stream/outgoing.h"

namespace aeolic::stream {

/// One viewer's WebSocket: what it says goes to the hub, what the hub says goes out in order. `Stream` is plain or TLS.
template <class Stream>
class ViewerSession final : public ViewerPort, public std::enable_shared_from_this<ViewerSession<Stream>> {
public:
    ViewerSession(Stream&& stream, Hub& hub)
        : socket_(std::move(stream)), hub_(hub), wake_(socket_.get_executor(), SteadyClock::time_point::max())
    {
    }

    void send(WireMessage message) override
    {
        if (closing_) return;
        queue_.push(std::move(message));
        // The hub bounds the frames; who lets so much else lie takes nothing in at all.
        if (queue_.otherBytes() > kMostOtherBytes) return close(websocket::close_code::policy_error, "too slow");
        wake_.cancel();
    }

    int framesQueued() const override { return queue_.frames(); }

    void close(std::uint16_t code, const std::string& reason) override
    {
        if (closing_) return;
        closing_ = websocket::close_reason(websocket::close_code(code), reason);
        wake_.cancel();
    }

    /// Until the viewer leaves or is sent away.
    asio::awaitable<void> run(HttpRequest request)
    {
        setServerTimes(socket_);
        setMessages(socket_, kHeaderBytes + 16 * 1024);
        boost::system::error_code error;
        co_await socket_.async_accept(request, asio::redirect_error(asio::use_awaitable, error));
        if (error) co_return;
        asio::co_spawn(socket_.get_executor(), writeAll(this->shared_from_this()), asio::detached);
        co_await readAll();
        if (id_ != 0) hub_.leave(std::exchange(id_, 0));
        readerEnded_ = true;
        wake_.cancel();
    }

private:
    static constexpr std::size_t kMostOtherBytes = std::size_t{16} << 20;

    asio::awaitable<void> readAll()
    {
        asio::steady_timer helloLimit(socket_.get_executor(), std::chrono::seconds(5));
        helloLimit.async_wait([self = this->weak_from_this()](const boost::system::error_code& cancelled) {
            if (cancelled) return;
            if (const auto session = self.lock(); session && session->id_ == 0)
                session->close(websocket::close_code::policy_error, "no Hello");
        });
        beast::flat_buffer buffer;
        boost::system::error_code error;
        while (!closing_) {
            co_await socket_.async_read(buffer, asio::redirect_error(asio::use_awaitable, error));
            if (error == websocket::error::message_too_big) close(websocket::close_code::too_big, "too big");
            if (error || closing_) break;
            take(buffer);
            buffer.consume(buffer.size());
        }
        helloLimit.cancel();
    }

    void take(const beast::flat_buffer& buffer)
    {
        if (!rate_.allows(SteadyClock::now())) return close(websocket::close_code::policy_error, "too many requests");
        try {
            if (!socket_.got_binary()) throw ProtocolError("a text message");
            const auto data = buffer.cdata();
            const MessageView message =
                parseMessage({static_cast<const std::uint8_t*>(data.data()), data.size()}, Sender::viewer);
            if (id_ == 0)
                greet(message);
            else
                hub_.receive(id_, message);
        } catch (const ProtocolError& wrong) {
            close(websocket::close_code::protocol_error, wrong.what());
        }
    }

    void greet(const MessageView& message)
    {
        if (message.type != MessageType::hello) throw ProtocolError("no Hello first");
        const Hello hello = helloFrom(parseJson(message.payload));
        if (hub_.isFull()) return close(websocket::close_code::try_again_later, "too many viewers");
        id_ = hub_.join(*this, hello);
    }

    /// Keeps the session alive while it may still send.
    static asio::awaitable<void> writeAll(std::shared_ptr<ViewerSession> self)
    {
        ViewerSession& s = *self;
        boost::system::error_code error;
        while (!error) {
            if (s.closing_) {  // Said even where nothing more is read.
                co_await s.socket_.async_close(*s.closing_, asio::redirect_error(asio::use_awaitable, error));
                break;
            }
            if (s.readerEnded_) break;
            if (s.queue_.empty()) {
                boost::system::error_code woken;
                co_await s.wake_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
                continue;
            }
            const WireMessage message = s.queue_.front();
            co_await s.socket_.async_write(asio::buffer(*message), asio::redirect_error(asio::use_awaitable, error));
            const int before = s.queue_.frames();
            s.queue_.pop();
            if (s.id_ != 0 && s.queue_.frames() < before) s.hub_.frameWritten(s.id_);
        }
        // A peer that does not answer the close would keep the reader waiting.
        boost::system::error_code ignored;
        beast::get_lowest_layer(s.socket_).socket().close(ignored);
    }

    websocket::stream<Stream> socket_;
    Hub& hub_;
    asio::steady_timer wake_;
    Outgoing queue_;
    std::optional<websocket::close_reason> closing_;
    bool readerEnded_ = false;
    std::uint32_t id_ = 0;
    RequestRate rate_;
};

}  // namespace aeolic::stream
