#include "stream/gateway/viewer_session.h"

#include <algorithm>
#include <boost/beast/websocket/error.hpp>
#include <cstdio>

#include "stream/link/accept.h"
#include "stream/listen.h"

namespace aeolic::stream {
namespace {

constexpr std::size_t kMostOtherBytes = std::size_t{16} << 20;
constexpr std::size_t kLargestRequest = kHeaderBytes + 16 * 1024;
constexpr auto kHelloTime = std::chrono::seconds(5), kGoodbyeTime = std::chrono::seconds(5);
constexpr auto kLookAgain = std::chrono::seconds(1);

}  // namespace

ViewerSession::ViewerSession(WebConnection connection, Hub& hub, std::shared_ptr<CommonRate> common)
    : connection_(std::move(connection)),
      hub_(hub),
      wake_(connection_.executor(), SteadyClock::time_point::max()),
      common_(std::move(common))
{
}

void ViewerSession::send(WireMessage message)
{
    if (closing_) return;
    queue_.push(std::move(message));
    // The hub bounds the frames. A viewer that leaves so much else unread takes nothing in at all.
    if (queue_.otherBytes() > kMostOtherBytes) return close(Goodbye::policyError, "too slow");
    wake_.cancel();
}

void ViewerSession::close(std::uint16_t code, const std::string& reason)
{
    if (closing_) return;
    closing_ = {code, reason, SteadyClock::now()};
    queue_ = {};  // Nobody will read it.
    wake_.cancel();
}

asio::awaitable<void> ViewerSession::run(HttpRequest request)
{
    const WebConnection::Error refused = co_await connection_.acceptWebSocket(std::move(request), kLargestRequest);
    if (refused) co_return;
    asio::co_spawn(connection_.executor(), writeAll(shared_from_this()), asio::detached);
    asio::co_spawn(connection_.executor(), watchWrites(shared_from_this()), asio::detached);
    co_await readAll();
    seat_.reset();
    readerEnded_ = true;
    wake_.cancel();
}

asio::awaitable<void> ViewerSession::readAll()
{
    asio::steady_timer helloLimit(connection_.executor(), kHelloTime);
    helloLimit.async_wait([self = weak_from_this()](const boost::system::error_code& cancelled) {
        if (cancelled) return;
        if (const auto session = self.lock(); session && !session->seat_)
            session->close(Goodbye::policyError, "no Hello");
    });
    ByteVector message;
    while (!closing_) {
        message.clear();
        const WebConnection::Error error = co_await connection_.read(message);
        if (error == boost::beast::websocket::error::message_too_big) close(Goodbye::tooBig, "too big");
        if (error || closing_) break;
        co_await waitForTurn();
        if (closing_) break;
        take(message);
    }
    helloLimit.cancel();
}

/// What all viewers send together has a limit, too.
asio::awaitable<void> ViewerSession::waitForTurn()
{
    const auto wait = common_->nextTurn(SteadyClock::now());
    if (wait > std::chrono::milliseconds(1)) co_await pauseFor(wait);  // Less is not worth a timer.
}

void ViewerSession::take(ByteView bytes)
{
    if (!rate_.take(SteadyClock::now())) return close(Goodbye::policyError, "too many requests");
    try {
        if (!connection_.gotBinary()) throw ProtocolError("a text message");
        const MessageView message = parseMessage(bytes, Sender::viewer);
        if (!seat_)
            greet(message);
        else
            hub_.receive(seat_->viewer(), message);
    } catch (const ProtocolError& wrong) {
        close(Goodbye::protocolError, wrong.what());
    } catch (const std::exception& error) {
        fail(error);
    }
}

/// Whatever goes wrong in one session ends that session alone.
void ViewerSession::fail(const std::exception& error)
{
    std::fprintf(stderr, "aeolic: a viewer's session ends: %s\n", error.what());
    close(Goodbye::internalError, "internal error");
}

void ViewerSession::greet(const MessageView& message)
{
    if (message.type != MessageType::hello) throw ProtocolError("no Hello first");
    const Hello hello = helloFrom(parseJson(message.payload));
    if (hub_.isFull()) return close(Goodbye::tryAgainLater, "too many viewers");
    seat_.emplace(hub_, *this, hello);
}

/// Keeps the session alive while it may still send.
asio::awaitable<void> ViewerSession::writeAll(std::shared_ptr<ViewerSession> self)
{
    try {
        co_await self->writeQueue();
    } catch (const std::exception& error) {
        self->fail(error);
    }
    // A viewer that does not answer the goodbye would keep the reader waiting.
    self->writerEnded_ = true;
    self->connection_.drop();
}

/// Hangs up where a write makes no progress, and where the goodbye takes too long. Pings do not find such viewers out:
/// they may send, and so be heard, while they read nothing.
asio::awaitable<void> ViewerSession::watchWrites(std::shared_ptr<ViewerSession> self)
{
    while (!self->writerEnded_) {
        co_await pauseFor(kLookAgain);
        const auto now = SteadyClock::now();
        const bool stuck = self->writing_ && now - std::max(*self->writing_, self->connection_.wroteAt()) > kWriteLimit;
        const bool stays = self->closing_ && now - self->closing_->since > kGoodbyeTime;
        if (stuck || stays) self->connection_.drop();
    }
}

asio::awaitable<void> ViewerSession::writeQueue()
{
    for (;;) {
        if (closing_) {  // Said even where nothing more is read.
            co_await connection_.close(closing_->code, closing_->reason);
            break;
        }
        if (readerEnded_) break;
        if (queue_.empty()) {
            boost::system::error_code woken;
            co_await wake_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
            continue;
        }
        writing_ = SteadyClock::now();
        const WebConnection::Error error = co_await connection_.write(queue_.front());
        writing_.reset();
        if (error) break;
        if (closing_) continue;
        const int before = queue_.frames();
        queue_.pop();
        if (seat_ && queue_.frames() < before) hub_.frameWritten(seat_->viewer());
    }
}

}  // namespace aeolic::stream
