#include "stream/gateway/wrong_tokens.h"

#include <algorithm>

#include "stream/listen.h"

namespace aeolic::stream {
namespace {

namespace ip = boost::asio::ip;

/// One client: a host's IPv4 address, or the 64 bits of an IPv6 address within which a host can call itself anything.
ip::address clientOf(const ip::address& address)
{
    const ip::address plain = plainAddress(address);
    if (plain.is_v4()) return plain;
    ip::address_v6::bytes_type bytes = address.to_v6().to_bytes();
    std::fill(bytes.begin() + 8, bytes.end(), static_cast<unsigned char>(0));
    return ip::address_v6(bytes);
}

}  // namespace

void WrongTokens::add(const ip::address& from, Clock::time_point now)
{
    const ip::address client = clientOf(from);
    if (!known_.count(client) && known_.size() >= kMostAddresses) {
        std::erase_if(known_, [&](const auto& entry) { return now - entry.second.last >= kForgotten; });
        if (known_.size() >= kMostAddresses)
            known_.erase(std::min_element(known_.begin(), known_.end(),
                                          [](const auto& a, const auto& b) { return a.second.last < b.second.last; }));
    }
    Guesses& guesses = known_[client];
    if (now - guesses.last >= kForgotten) guesses.count = 0;
    guesses.count = std::min(guesses.count + 1, 1000);
    guesses.last = now;
}

std::chrono::milliseconds WrongTokens::waitFor(const ip::address& from, Clock::time_point now) const
{
    const auto found = known_.find(clientOf(from));
    if (found == known_.end() || now - found->second.last >= kForgotten) return std::chrono::milliseconds(0);
    const int beyond = found->second.count - kFree;
    if (beyond <= 0) return std::chrono::milliseconds(0);
    return std::min(kLongestWait, kFirstWait * (1 << std::min(beyond - 1, 10)));
}

}  // namespace aeolic::stream
