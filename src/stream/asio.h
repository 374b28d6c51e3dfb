#pragma once

#include <utility>  // Boost 1.74 forgets it.

#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>

/// The parts of Asio that a server on one thread is written with.
namespace aeolic::stream {

namespace asio = boost::asio;
using Tcp = asio::ip::tcp;

}  // namespace aeolic::stream
