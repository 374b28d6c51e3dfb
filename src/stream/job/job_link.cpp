#include "stream/job/job_link.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

namespace aeolic::stream {
namespace {

using Tcp = boost::asio::ip::tcp;

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
    }
};

JobLink::JobLink(const GatewayAddress& address, const WireMessage& join, std::function<void()> onEnd,
                 std::function<void(const MessageView&)> onInvite)
    : socket_(std::make_unique<Socket>(address)), onEnd_(std::move(onEnd)), onInvite_(std::move(onInvite))
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
            received_.push_back(std::make_shared<const ByteVector>(std::move(bytes)));
            changed_.notify_all();
            if (header.type == MessageType::quit) return;  // The end of the link that follows is no fault.
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
        changed_.wait(lock, [&] { return closing_ || !toSend_.empty(); });
        if (toSend_.empty()) return;
        const WireMessage message = toSend_.front();
        lock.unlock();
        boost::system::error_code error;
        boost::asio::write(socket_->tcp, boost::asio::buffer(*message), error);  // After an error the reader ends, too.
        lock.lock();
        toSend_.pop_front();
        queuedBytes_ -= message->size();
        changed_.notify_all();
    }
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
