#pragma once

#include <chrono>
#include <string>

#include "stream/asio.h"

namespace aeolic::stream {

/// Rank and gateway take each other for gone after so long without a word. A quarter of it lies between two words.
inline constexpr std::chrono::seconds kSilenceLimit{20};

/// A viewer whose connection has taken no byte for so long, although there was one to send, is taken for gone.
inline constexpr std::chrono::seconds kWriteLimit{30};

/// Ports to listen on: the first free one of them. 0 to 0: any that is free.
struct PortRange {
    std::uint16_t first = 0, last = 0;
    bool operator==(const PortRange&) const = default;
};

/// Listens on an address of this host, or, if `host` is empty, on all of them, IPv6 and IPv4. Throws
/// boost::system::system_error where there is no such address or all of the ports are taken.
Tcp::acceptor listenOn(asio::io_context& io, const std::string& host, PortRange ports);

/// The address as other programs write it: IPv4 where a socket for both kinds shows an IPv4 address as IPv6.
asio::ip::address plainAddress(const asio::ip::address& address);

}  // namespace aeolic::stream
