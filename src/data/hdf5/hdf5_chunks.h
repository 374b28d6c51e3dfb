#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "data/hdf5/hdf5_layout.h"

namespace aeolic {

/// A part of a data set that stands in one piece.
struct Hdf5Chunk {
    std::vector<std::uint64_t> first;  ///< Of its elements, in each dimension.
    std::uint64_t address = 0, bytes = 0;
    std::uint32_t skipped = 0;  ///< A bit for each filter that was left out.
};

/// All chunks that the file has of a data set (sections III.A.1, VII.A to VII.D), each once. `elementBytes`: of one
/// element. Throws InputError where more are named than there can be.
std::vector<Hdf5Chunk> findHdf5Chunks(const Hdf5Store& store, const Hdf5Layout& layout, const Hdf5Space& space,
                                      std::uint32_t elementBytes, bool filtered, const std::string& name);

/// Entries of an array of chunks: take(index, bytes of the entry).
using Hdf5ArrayEntry = std::function<void(std::uint64_t index, std::span<const std::uint8_t> entry)>;
void walkHdf5FixedArray(const Hdf5Store& store, std::uint64_t address, const Hdf5ArrayEntry& take);

/// `count`: how many entries are wanted at most.
void walkHdf5ExtensibleArray(const Hdf5Store& store, std::uint64_t address, std::uint64_t count,
                             const Hdf5ArrayEntry& take);

}  // namespace aeolic
