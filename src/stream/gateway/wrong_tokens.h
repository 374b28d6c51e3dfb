#pragma once

#include <boost/asio/ip/address.hpp>
#include <chrono>
#include <map>

namespace aeolic::stream {

/// How long a client that brings a token waits for its answer: the longer, the more wrong tokens came from its address.
/// The right token waits as long as a wrong one, or an attacker would guess again after a moment's silence. The wait is
/// bounded, and sessions do not wait at all. Not thread-safe.
class WrongTokens {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr int kFree = 4;  ///< So many typing errors cost nothing.
    static constexpr std::chrono::milliseconds kFirstWait{50}, kLongestWait{1000};
    static constexpr std::chrono::seconds kForgotten{60};  ///< After the address's last wrong token.
    static constexpr std::size_t kMostAddresses = 1024;

    void add(const boost::asio::ip::address& from, Clock::time_point now);
    std::chrono::milliseconds waitFor(const boost::asio::ip::address& from, Clock::time_point now) const;
    std::size_t addresses() const { return known_.size(); }

private:
    struct Guesses {
        int count = 0;
        Clock::time_point last;
    };
    std::map<boost::asio::ip::address, Guesses> known_;
};

}  // namespace aeolic::stream
