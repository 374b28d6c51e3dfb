#pragma once

#include <algorithm>
#include <utility>  // Boost 1.74 forgets it.

#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <chrono>

/// The parts of Asio that a server on one thread is written with.
namespace aeolic::stream {

namespace asio = boost::asio;
using Tcp = asio::ip::tcp;

/// `time`, or a year where it is longer: much more would overflow a clock that it is added to.
inline std::chrono::milliseconds waitable(std::chrono::milliseconds time)
{
    constexpr std::chrono::milliseconds longest = std::chrono::hours(24 * 365);
    return std::min(time, longest);
}

}  // namespace aeolic::stream
