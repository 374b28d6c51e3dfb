#include "stream/job/job_link.h"

#include <boost/asio/connect.hpp>

#include "stream/link/link_greeting.h"
#include "stream/link/lost_peer.h"
#include "stream/waitable.h"

namespace aeolic::stream {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostQueuedBytes = 64 << 20;
constexpr auto kMeetingTime = std::chrono::seconds(10);
constexpr int kMostRounds = 6;  // Strangers may crowd the port for a moment.

}  // namespace

struct JobLink::Socket {
    asio::io_context io{1};
    LinkSocket link{Tcp::socket(io)};

    Socket(const GatewayAddress& address, const Json& about)
    {
        const TlsSide tls = address.fingerprint.empty() ? nullptr : makeTlsClient(address.fingerprint);
        std::string why = "no host to try";
        for (int round = 0; round < kMostRounds; ++round) {
            std::this_thread::sleep_for(round * std::chrono::milliseconds(200));
            for (const std::string& host : address.hosts)
                if (hasMet(host, address, tls, about, why)) return;
        }
        throw std::runtime_error("the gateway cannot be reached: " + why);
    }

    /// Whether the gateway of this job is there; `why` not, if it is not.
    bool hasMet(const std::string& host, const GatewayAddress& address, const TlsSide& tls, const Json& about,
                std::string& why)
    {
        bool ended = false;
        std::exception_ptr failure;
        try {
            const auto places = Tcp::resolver(io).resolve(host, std::to_string(address.port));
            link = LinkSocket(Tcp::socket(io));
            asio::co_spawn(io, meet(places, tls, address.secret, about),
                           [&](const std::exception_ptr& error) { ended = true, failure = error; });
            io.restart();
            io.run_for(kMeetingTime);
            if (!ended) {
                link.close();
                io.restart();
                io.run();
                throw std::runtime_error("no answer");
            }
            if (failure) std::rethrow_exception(failure);
            noticeLostPeer(link.tcp().native_handle(), std::chrono::seconds(address.silenceLimitS));
            return true;
        } catch (const std::exception& error) {
            why = host + ": " + error.what();
            return false;
        }
    }

    asio::awaitable<void> meet(Tcp::resolver::results_type places, TlsSide tls, std::string secret, Json about)
    {
        co_await asio::async_connect(link.tcp(), places, asio::use_awaitable);
        link.tcp().set_option(Tcp::no_delay(true));
        if (tls) co_await link.startTls(tls, false);
        co_await greetGateway(link, secret, about);
    }
};

JobLink::JobLink(const GatewayAddress& address, const Json& about, std::function<void()> onEnd,
                 std::function<void(const MessageView&)> onInvite)
    : socket_(std::make_unique<Socket>(address, about)),
      onEnd_(std::move(onEnd)),
      onInvite_(std::move(onInvite)),
      silenceLimit_(address.silenceLimitS)
{
    reader_ = std::thread([this] { readAll(); });
    writer_ = std::thread([this] { writeAll(); });
}

JobLink::~JobLink()
{
    close();
}

void JobLink::close()
{
    {
        const std::lock_guard lock(mutex_);
        if (closing_) return;
        closing_ = true;
    }
    changed_.notify_all();
    writer_.join();
    boost::system::error_code ignored;
    socket_->link.tcp().shutdown(Tcp::socket::shutdown_both, ignored);
    reader_.join();
}

void JobLink::readAll()
{
    try {
        for (;;) {
            ByteVector bytes(kHeaderBytes);
            socket_->link.readNow(bytes.data(), bytes.size());
            const MessageHeader header = parseHeader(bytes, Sender::gatewayToRank);
            bytes.resize(kHeaderBytes + header.payloadBytes);
            socket_->link.readNow(bytes.data() + kHeaderBytes, header.payloadBytes);
            if (header.type == MessageType::invite) {
                if (onInvite_) onInvite_({header.type, ByteView(bytes).subspan(kHeaderBytes)});
                continue;
            }
            const std::lock_guard lock(mutex_);
            heard_ = Clock::now();
            if (header.type == MessageType::ping) {
                answerPing();
                continue;
            }
            received_.push_back(std::make_shared<const ByteVector>(std::move(bytes)));
            changed_.notify_all();
            if (header.type == MessageType::quit) return;  // The connection ends now, as was asked for.
        }
    } catch (const std::exception&) {
        end();
    }
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

void JobLink::writeAll()
{
    for (;;) {
        std::unique_lock lock(mutex_);
        if (!waitForWork(lock)) {
            lock.unlock();
            return end();
        }
        if (toSend_.empty()) return;
        const WireMessage message = toSend_.front();
        lock.unlock();
        try {
            socket_->link.writeNow(*message);
        } catch (const std::exception&) {  // The reading side ends, too, and tells it.
        }
        lock.lock();
        toSend_.pop_front();
        queuedBytes_ -= message->size();
        if (MessageType((*message)[2]) == MessageType::pong) pongQueued_ = false;
        changed_.notify_all();
    }
}

/// Tells the gateway that this process is alive, whatever its other threads do. Does not wait for room in the queue,
/// because the thread that reads must go on. The mutex is held.
void JobLink::answerPing()
{
    if (std::exchange(pongQueued_, true)) return;
    toSend_.push_back(emptyMessage(MessageType::pong));
    queuedBytes_ += toSend_.back()->size();
    changed_.notify_all();
}

/// Waits for a message to send, or for close(). False where the gateway is silent for too long. Time in which this
/// process itself was stopped does not count as silence.
bool JobLink::waitForWork(std::unique_lock<std::mutex>& lock)
{
    const auto interval = std::chrono::milliseconds(silenceLimit_) / 4;
    const auto ready = [&] { return closing_ || !toSend_.empty(); };
    for (auto last = Clock::now(); !changed_.wait_for(lock, interval, ready);) {
        const auto now = Clock::now();
        if (now - last > 2 * interval) heard_ = now;
        if (now - heard_ > silenceLimit_) return false;
        last = now;
    }
    return true;
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
    if (ended_) return;
    queuedBytes_ += message->size();
    toSend_.push_back(std::move(message));
    changed_.notify_all();
}

}  // namespace aeolic::stream
