#pragma once

#include <utility>  // Boost 1.74 forgets it.

#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>

/// What all that speaks HTTP and WebSockets calls the libraries by, and their settings.
namespace aeolic::stream {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;

/// Messages are binary and go out in one piece; larger ones than `largestMessage` bytes do not come in.
template <class Stream>
void setMessages(websocket::stream<Stream>& socket, std::size_t largestMessage)
{
    socket.read_message_max(largestMessage);
    socket.binary(true);
    socket.auto_fragment(false);
}

/// How long a server waits for whoever opened `socket`, who is pinged before it is taken for gone.
template <class Stream>
void setServerTimes(websocket::stream<Stream>& socket)
{
    websocket::stream_base::timeout times{};
    times.handshake_timeout = std::chrono::seconds(5);
    times.idle_timeout = std::chrono::seconds(30);
    times.keep_alive_pings = true;
    socket.set_option(times);
}

}  // namespace aeolic::stream
