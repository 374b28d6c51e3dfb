#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "data/hdf5/hdf5_types.h"

namespace aeolic {

/// How the chunks of a data set are found.
enum class Hdf5Index { oldTree, single, implicit, fixedArray, extensibleArray, newTree };

/// Where a data set's elements stand (section IV.A.2.i).
struct Hdf5Layout {
    enum class Kind { compact, contiguous, chunked };
    Kind kind = Kind::contiguous;
    std::uint64_t address = 0, bytes = 0;
    std::vector<std::uint8_t> compact;
    Hdf5Index index = Hdf5Index::oldTree;
    std::vector<std::uint64_t> chunk;  ///< Elements of a chunk in each dimension.
    bool rawEdges = false;             ///< Chunks that stand over the end are not filtered.
    std::uint64_t singleBytes = 0;     ///< Of a single filtered chunk.
    std::uint32_t singleMask = 0;
};

struct Hdf5Filter {
    int id = 0;
    std::string name;
    std::uint64_t size = 0;  ///< What it says of itself first: of the shuffle the bytes of an element.
};

Hdf5Layout parseHdf5Layout(const Hdf5Store& store, std::span<const std::uint8_t> message, std::size_t rank,
                           const std::string& name);
std::vector<Hdf5Filter> parseHdf5Filters(const Hdf5Store& store, std::span<const std::uint8_t> message);

/// How many bytes a byte that deflate has packed can become at most.
inline constexpr std::uint64_t kMostRatio = 1032;

/// Undoes the filters of a chunk. `bytes`: how many the chunk has without them. `skipped`: a bit for each filter that
/// was left out. Throws InputError for a filter that is not known, and for data that cannot be of it.
std::vector<std::uint8_t> unfiltered(const Hdf5Store& store, std::vector<std::uint8_t> data,
                                     const std::vector<Hdf5Filter>& filters, std::uint32_t skipped, std::uint64_t bytes,
                                     const std::string& name);

/// Throws InputError for a filter that is not known.
void requireKnownFilters(const Hdf5Store& store, const std::vector<Hdf5Filter>& filters, const std::string& name);

}  // namespace aeolic
