#pragma once

#include <cstdint>

namespace aeolic {

/// Messages that a rank sends, and receives, one after the other, until all have heard of all: ⌈log2 ranks⌉.
inline int collectiveRounds(int ranks)
{
    int rounds = 0;
    while ((std::int64_t(1) << rounds) < ranks) ++rounds;
    return rounds;
}

/// A network for modelled times. A rank's messages go one after another, each costing `latencyUs`; nothing overlaps
/// with computing. Sending and receiving go at once.
struct NetworkModel {
    double bandwidthBytesPerS = 12.5e9;  ///< 100 Gbit/s
    double latencyUs = 2;

    /// How long it takes one rank to send, or to receive, so much.
    double transferMs(std::int64_t bytes, std::int64_t messages) const
    {
        return double(messages) * latencyUs * 1e-3 + double(bytes) / bandwidthBytesPerS * 1e3;
    }

    /// How long a small collective (balancing data) of `ranks` takes as a tree of messages. `bytes` arrive at each
    /// rank.
    double collectiveMs(int ranks, std::int64_t bytes) const
    {
        return ranks > 1 ? transferMs(bytes, collectiveRounds(ranks)) : 0.0;
    }
};

}  // namespace aeolic
