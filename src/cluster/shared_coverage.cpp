#include "cluster/shared_coverage.h"

#include <cstring>
#include <stdexcept>

namespace aeolic {

void uniteCoverage(Communicator& communicator, CoverageBits& bits)
{
    for (const Bytes& bytes : communicator.allGather(std::as_bytes(std::span(bits.words)))) {
        if (bytes.size() != bits.words.size() * sizeof(std::uint64_t))
            throw std::runtime_error("rank " + std::to_string(communicator.rank()) +
                                     ": coverage of another size than another rank's");
        for (std::size_t i = 0; i < bits.words.size(); ++i) {
            std::uint64_t word;
            std::memcpy(&word, &bytes[i * sizeof word], sizeof word);
            bits.words[i] |= word;
        }
    }
}

}  // namespace aeolic
