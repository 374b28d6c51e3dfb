#include "stream/job/job_link.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/post.hpp>

#include "stream/link/accept.h"
#include "stream/link/link_greeting.h"

namespace aeolic::stream {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostQueuedBytes = 64 << 20;
constexpr auto kMeetingTime = std::chrono::seconds(10);
constexpr int kMostRounds = 6;  // Strangers may crowd the port for a moment.

}  // namespace

JobLink::JobLink(const GatewayAddress& address, const Json& about, std::function<void()> onEnd,
                 std::function<void(const MessageView&)> onInvite)
    : onEnd_(std::move(onEnd)), onInvite_(std::move(onInvite)), silenceLimit_(address.silenceLimitS)
{
    meet(address, about);
    heard_ = Clock::now();
    asio::co_spawn(io_, readAll(), asio::detached);
    asio::co_spawn(io_, writeAll(), asio::detached);
    io_.restart();
    thread_ = std::thread([this] { io_.run(); });
}

void JobLink::meet(const GatewayAddress& address, const Json& about)
{
    const TlsSide tls = address.fingerprint.empty() ? nullptr : makeTlsClient(address.fingerprint);
    std::string why = "no host to try";
    for (int round = 0; round < kMostRounds; ++round) {
        std::this_thread::sleep_for(round * std::chrono::milliseconds(200));
        for (const std::string& host : address.hosts) {
            try {
                return meetAt(host, address, tls, about);
            } catch (const std::exception& error) {
                why = host + ": " + error.what();
            }
        }
    }
    throw std::runtime_error("the gateway cannot be reached: " + why);
}

/// Throws where the gateway of this job is not there.
void JobLink::meetAt(const std::string& host, const GatewayAddress& address, const TlsSide& tls, const Json& about)
{
    bool ended = false;
    std::exception_ptr failure;
    const auto places = Tcp::resolver(io_).resolve(host, std::to_string(address.port));
    link_ = LinkSocket(Tcp::socket(io_));
    asio::co_spawn(io_, greet(places, tls, address.secret, about),
                   [&](const std::exception_ptr& error) { ended = true, failure = error; });
    io_.restart();
    io_.run_for(kMeetingTime);
    if (!ended) {
        link_.close();
        io_.restart();
        io_.run();
        throw std::runtime_error("no answer");
    }
    if (failure) std::rethrow_exception(failure);
    noticeLostPeer(link_.tcp().native_handle(), silenceLimit_);
}

asio::awaitable<void> JobLink::greet(Tcp::resolver::results_type places, TlsSide tls, std::string secret, Json about)
{
    co_await asio::async_connect(link_.tcp(), places, asio::use_awaitable);
    link_.tcp().set_option(Tcp::no_delay(true));
    if (tls) co_await link_.startTls(tls, false);
    co_await greetGateway(link_, secret, about);
}

void JobLink::close()
{
    {
        std::unique_lock lock(mutex_);
        if (std::exchange(closing_, true)) return;
        asio::post(io_, [this] { wake_.cancel(); });
        changed_.wait(lock, [&] { return writerEnded_; });
    }
    io_.stop();
    thread_.join();
    link_.close();
}

asio::awaitable<void> JobLink::readAll()
{
    try {
        for (bool goesOn = true; goesOn;) {
            WireMessage message = co_await link_.readMessage(Sender::gatewayToRank);
            goesOn = take(std::move(message));
        }
    } catch (const std::exception&) {
        end();
    }
}

/// Takes in a message of the gateway's. False after the last one, behind which nothing comes.
bool JobLink::take(WireMessage message)
{
    const auto type = MessageType((*message)[2]);
    if (type == MessageType::invite) {
        if (onInvite_) onInvite_({type, ByteView(*message).subspan(kHeaderBytes)});
        return true;
    }
    heard_ = Clock::now();
    const std::lock_guard lock(mutex_);
    if (type == MessageType::ping) {
        // Tells the gateway that this process is alive, whatever its other threads do. Does not wait for room in the
        // queue, because this thread must go on.
        if (!std::exchange(pongQueued_, true)) queue(emptyMessage(MessageType::pong));
        return true;
    }
    received_.push_back(std::move(message));
    changed_.notify_all();
    return type != MessageType::quit;
}

/// Nothing comes any more, and nothing that is sent arrives.
void JobLink::end()
{
    {
        const std::lock_guard lock(mutex_);
        if (closing_ || std::exchange(ended_, true)) return;
    }
    changed_.notify_all();
    onEnd_();
}

asio::awaitable<void> JobLink::writeAll()
{
    co_await writeQueue();
    const std::lock_guard lock(mutex_);
    writerEnded_ = true;
    changed_.notify_all();
}

/// Ends with close(), once everything is sent, and where the gateway is silent for too long. Time in which this process
/// itself was stopped does not count as silence.
asio::awaitable<void> JobLink::writeQueue()
{
    const auto interval = std::chrono::milliseconds(silenceLimit_) / 4;
    for (;;) {
        WireMessage message;
        {
            const std::lock_guard lock(mutex_);
            if (!toSend_.empty())
                message = toSend_.front();
            else if (closing_)
                break;
        }
        if (!message) {
            const auto since = Clock::now();
            boost::system::error_code woken;
            wake_.expires_after(interval);
            co_await wake_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
            const auto now = Clock::now();
            if (now - since > 2 * interval) heard_ = now;
            if (now - heard_ > silenceLimit_) {
                end();
                break;
            }
            continue;
        }
        try {
            co_await link_.write(*message);
        } catch (const std::exception&) {  // The reading side ends, too, and tells it.
        }
        if (MessageType((*message)[2]) == MessageType::pong) pongQueued_ = false;
        const std::lock_guard lock(mutex_);
        toSend_.pop_front();
        queuedBytes_ -= message->size();
        changed_.notify_all();
    }
}

/// Appends a message to those to be sent, and wakes the writer. The caller holds the mutex.
void JobLink::queue(WireMessage message)
{
    queuedBytes_ += message->size();
    toSend_.push_back(std::move(message));
    asio::post(io_, [this] { wake_.cancel(); });
}

WireMessage JobLink::receive()
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !received_.empty() || ended_; });
    if (received_.empty()) throw std::runtime_error("the gateway has gone");
    WireMessage message = std::move(received_.front());
    received_.pop_front();
    return message;
}

std::size_t JobLink::waiting(std::chrono::milliseconds time, std::size_t enough)
{
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, waitable(time), [&] { return received_.size() >= enough || ended_; });
    return received_.size();
}

bool JobLink::hasEnded()
{
    const std::lock_guard lock(mutex_);
    return ended_;
}

bool JobLink::isNext(MessageType type)
{
    const std::lock_guard lock(mutex_);
    return !received_.empty() &&
           parseHeader(ByteView(*received_.front()).first(kHeaderBytes), Sender::gatewayToRank).type == type;
}

void JobLink::send(WireMessage message)
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return queuedBytes_ < kMostQueuedBytes || ended_; });
    if (!ended_) queue(std::move(message));
}

}  // namespace aeolic::stream
