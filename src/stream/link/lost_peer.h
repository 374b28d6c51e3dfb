#pragma once

#include <chrono>

namespace aeolic::stream {

/// Rank and gateway take each other for gone after so long without a word. A quarter of it lies between two words.
inline constexpr std::chrono::seconds kSilenceLimit{20};

/// A viewer whose connection has taken no byte for so long, although there was one to send, is taken for gone.
inline constexpr std::chrono::seconds kWriteLimit{30};

/// Lets the system end a TCP connection whose other host has vanished without a word: after `limit` in which sent data
/// were not acknowledged or not taken, or, where nothing is sent, in which probes were not answered. What is pending on
/// the socket then fails. Where the system refuses, nothing happens.
void noticeLostPeer(int socket, std::chrono::seconds limit);

}  // namespace aeolic::stream
