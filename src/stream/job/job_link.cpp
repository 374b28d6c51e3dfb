#include "stream/job/job_link.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include "stream/lost_peer.h"

namespace aeolic::stream {
namespace {

using Tcp = boost::asio::ip::tcp;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostQueuedBytes = 64 << 20;

}  // namespace

struct JobLink::Socket {
    boost::asio::io_context io;
    Tcp::socket tcp{io};

    explicit Socket(const GatewayAddress& address)
    {
        boost::system::error_code error = boost::asio::error::host_not_found;
        Tcp::resolver resolver(io);
        for (const std::string& host : address.hosts) {
            const auto found = resolver.resolve(host, std::to_string(address.port), error);
            if (error) continue;
            boost::asio::connect(tcp, found, error);
            if (!error) break;
        }
        if (error) throw std::runtime_error("the gateway cannot be reached: " + error.message());
        tcp.set_option(Tcp::no_delay(true));
        noticeLostPeer(tcp.native_handle(), std::chrono::seconds(address.silenceLimitS));
    }
};

JobLink::JobLink(const GatewayAddress& address, const WireMessage& join, std::function<void()> onEnd,
                 std::function<void(const MessageView&)> onInvite)
    : socket_(std::make_unique<Socket>(address)),
      onEnd_(std::move(onEnd)),
      onInvite_(std::move(onInvite)),
      silenceLimit_(address.silenceLimitS)
{
    boost::asio::write(socket_->tcp, boost::asio::buffer(*join));
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
    socket_->tcp.shutdown(Tcp::socket::shutdown_both, ignored);
    reader_.join();
}

void JobLink::readAll()
{
    try {
        for (;;) {
            ByteVector bytes(kHeaderBytes);
            boost::asio::read(socket_->tcp, boost::asio::buffer(bytes));
            const MessageHeader header = parseHeader(bytes, Sender::gatewayToRank);
            bytes.resize(kHeaderBytes + header.payloadBytes);
            boost::asio::read(socket_->tcp, boost::asio::buffer(bytes.data() + kHeaderBytes, header.payloadBytes));
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
        std::unique_lock lock(mutex_);
        if (closing_) return;
        lock.unlock();
        onEnd_();
    }
}

void JobLink::writeAll()
{
    for (;;) {
        std::unique_lock lock(mutex_);
        if (!waitForWork(lock)) {
            lock.unlock();
            return onEnd_();
        }
        if (toSend_.empty()) return;
        const WireMessage message = toSend_.front();
        lock.unlock();
        boost::system::error_code error;
        boost::asio::write(socket_->tcp, boost::asio::buffer(*message), error);  // An error ends the reading side, too.
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

/// Waits for a message to send, or for close(). False where the gateway is silent for too long. Where this process
/// itself was stopped for a while, that is no silence of the gateway.
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
    changed_.wait(lock, [&] { return !received_.empty(); });
    WireMessage message = std::move(received_.front());
    received_.pop_front();
    return message;
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
    changed_.wait(lock, [&] { return queuedBytes_ < kMostQueuedBytes; });
    queuedBytes_ += message->size();
    toSend_.push_back(std::move(message));
    changed_.notify_all();
}

}  // namespace aeolic::stream
