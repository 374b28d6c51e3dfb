#include "stream/link/link_socket.h"

#include <algorithm>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

namespace aeolic::stream {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 18;  // What is packed at a time.

}  // namespace

void LinkSocket::close()
{
    boost::system::error_code ignored;
    socket_.shutdown(Tcp::socket::shutdown_both, ignored);
    socket_.close(ignored);
}

asio::awaitable<void> LinkSocket::startTls(TlsSide side, bool isServer)
{
    tls_ = std::make_unique<LinkTls>(side, isServer);
    for (;;) {
        const bool done = tls_->shakeHands();
        const ByteVector due = tls_->takeOut();
        co_await asio::async_write(socket_, asio::buffer(due), asio::use_awaitable);
        if (done) co_return;
        const std::size_t got = co_await socket_.async_read_some(asio::buffer(wire_), asio::use_awaitable);
        tls_->putIn(ByteView(wire_).first(got));
    }
}

asio::awaitable<void> LinkSocket::read(std::uint8_t* to, std::size_t count)
{
    if (!tls_) {
        const auto noted = [this](const boost::system::error_code& error, std::size_t) -> std::size_t {
            heard_ = std::chrono::steady_clock::now();
            return error ? 0 : kPieceBytes;
        };
        co_await asio::async_read(socket_, asio::buffer(to, count), noted, asio::use_awaitable);
        co_return;
    }
    while (count > 0) {
        const std::size_t unpacked = tls_->read(to, count);
        to += unpacked;
        count -= unpacked;
        if (unpacked > 0) continue;
        const std::size_t got = co_await socket_.async_read_some(asio::buffer(wire_), asio::use_awaitable);
        heard_ = std::chrono::steady_clock::now();
        tls_->putIn(ByteView(wire_).first(got));
    }
}

asio::awaitable<void> LinkSocket::write(ByteView bytes)
{
    while (!bytes.empty()) {
        const ByteView piece = bytes.first(std::min(bytes.size(), kPieceBytes));
        bytes = bytes.subspan(piece.size());
        const ByteVector packed = tls_ ? tls_->write(piece) : ByteVector();
        const ByteView out = tls_ ? ByteView(packed) : piece;
        co_await asio::async_write(socket_, asio::buffer(out.data(), out.size()), asio::use_awaitable);
    }
}

asio::awaitable<WireMessage> LinkSocket::readMessage(Sender sender, std::optional<MessageType> type)
{
    ByteVector bytes(kHeaderBytes);
    co_await read(bytes.data(), bytes.size());
    const MessageHeader header = parseHeader(bytes, sender);
    if (type && header.type != *type) throw ProtocolError("a message out of turn");
    bytes.resize(kHeaderBytes + header.payloadBytes);
    co_await read(bytes.data() + kHeaderBytes, header.payloadBytes);
    co_return std::make_shared<const ByteVector>(std::move(bytes));
}

}  // namespace aeolic::stream
