#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "stream/asio.h"

namespace aeolic::stream {

/// Waits for so long.
asio::awaitable<void> pauseFor(std::chrono::steady_clock::duration time);

/// Hands every connection to `take` until the acceptor is closed; the coroutine may end after whoever has closed it.
/// `lostAfter`: the limit of noticeLostPeer(). Small messages are not held back.
asio::awaitable<void> acceptAll(std::shared_ptr<Tcp::acceptor> acceptor, std::chrono::seconds lostAfter,
                                std::function<void(Tcp::socket)> take);

/// Lets the system end a TCP connection whose other host has vanished without a word: after `limit` in which sent data
/// were not acknowledged or not taken, or, where nothing is sent, in which probes were not answered. What is pending on
/// the socket then fails. Where the system refuses, nothing happens.
void noticeLostPeer(int socket, std::chrono::seconds limit);

}  // namespace aeolic::stream
