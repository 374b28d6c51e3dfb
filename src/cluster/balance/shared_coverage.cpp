#include "cluster/balance/shared_coverage.h"

namespace aeolic {

void uniteCoverage(Communicator& communicator, CoverageBits& bits)
{
    const int ranks = communicator.size(), me = communicator.rank();
    std::vector<std::uint64_t> others(bits.words.size());
    // What one has, it has from twice as many ranks after every round; a bit that comes twice does no harm.
    for (int step = 1; step < ranks; step *= 2) {
        communicator.exchangeInPlace({{(me + step) % ranks, std::as_bytes(std::span(bits.words))}},
                                     {{(me + ranks - step) % ranks, std::as_writable_bytes(std::span(others))}});
        for (std::size_t i = 0; i < others.size(); ++i) bits.words[i] |= others[i];
    }
}

}  // namespace aeolic
