#pragma once

#include <array>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <variant>

#include "stream/asio.h"

namespace aeolic::stream {

/// The first few buffers of a sequence of any type. Reads and writes of "some" may leave the rest for the next call.
template <class Buffer>
class SomeBuffers {
public:
    template <class Sequence>
    explicit SomeBuffers(const Sequence& sequence)
    {
        const auto end = asio::buffer_sequence_end(sequence);
        for (auto it = asio::buffer_sequence_begin(sequence); it != end && count_ < buffers_.size(); ++it)
            if (const Buffer buffer(*it); buffer.size() > 0) buffers_[count_++] = buffer;
    }
    const Buffer* begin() const { return buffers_.data(); }
    const Buffer* end() const { return buffers_.data() + count_; }

private:
    std::array<Buffer, 16> buffers_;
    std::size_t count_ = 0;
};

/// A TCP or TLS stream behind one type, so that HTTP and WebSockets on top of it are compiled once. What is below is
/// compiled once, too: every completion handler becomes a std::function.
class ByteStream {
public:
    // NOLINTBEGIN(readability-identifier-naming): names that Asio and Beast look for.
    using TcpStream = boost::beast::tcp_stream;
    using TlsStream = boost::beast::ssl_stream<TcpStream>;
    using executor_type = TcpStream::executor_type;
    using Error = boost::system::error_code;

    explicit ByteStream(Tcp::socket&& socket) : stream_(std::in_place_type<TcpStream>, std::move(socket)) {}
    ByteStream(Tcp::socket&& socket, asio::ssl::context& context)
        : stream_(std::in_place_type<TlsStream>, TcpStream(std::move(socket)), context)
    {
    }

    TcpStream& tcp() { return isTls() ? tls().next_layer() : std::get<TcpStream>(stream_); }
    bool isTls() const { return std::holds_alternative<TlsStream>(stream_); }
    TlsStream& tls() { return std::get<TlsStream>(stream_); }
    /// When the last bytes were handed to the system; the stream's beginning where there were none.
    std::chrono::steady_clock::time_point wroteAt() const { return *wroteAt_; }
    executor_type get_executor() { return tcp().get_executor(); }

    template <class Sequence, class Handler>
    void async_read_some(const Sequence& buffers, Handler&& handler)
    {
        read(SomeBuffers<asio::mutable_buffer>(buffers), held<Error, std::size_t>(std::forward<Handler>(handler)));
    }
    template <class Sequence, class Handler>
    void async_write_some(const Sequence& buffers, Handler&& handler)
    {
        write(SomeBuffers<asio::const_buffer>(buffers), held<Error, std::size_t>(std::forward<Handler>(handler)));
    }

    /// What a WebSocket ends its stream with.
    template <class Handler>
    friend void async_teardown(boost::beast::role_type role, ByteStream& stream, Handler&& handler)
    {
        stream.tearDown(role, held<Error>(std::forward<Handler>(handler)));
    }
    friend void beast_close_socket(ByteStream& stream) { boost::beast::close_socket(stream.tcp()); }
    // NOLINTEND(readability-identifier-naming)

private:
    /// Handlers cannot be copied, but a std::function must be.
    template <class... Arguments, class Handler>
    static std::function<void(Arguments...)> held(Handler&& handler)
    {
        return [handler = std::make_shared<std::decay_t<Handler>>(std::forward<Handler>(handler))](
                   Arguments... arguments) { (*handler)(arguments...); };
    }
    void read(const SomeBuffers<asio::mutable_buffer>& buffers, std::function<void(Error, std::size_t)> handler);
    void write(const SomeBuffers<asio::const_buffer>& buffers, std::function<void(Error, std::size_t)> handler);
    void tearDown(boost::beast::role_type role, std::function<void(Error)> handler);

    std::variant<TcpStream, TlsStream> stream_;
    /// Shared: pending calls end after the stream.
    std::shared_ptr<std::chrono::steady_clock::time_point> wroteAt_ =
        std::make_shared<std::chrono::steady_clock::time_point>(std::chrono::steady_clock::now());
};

}  // namespace aeolic::stream
