#pragma once

#include <cstdint>
#include <functional>

#include "data/hdf5/hdf5_store.h"

namespace aeolic {

/// Calls leaf(key, child) for every child of the leaves of a tree of version 1 (section III.A.1), in its order. `kind`:
/// 0 for a group's links, 1 for a data set's chunks. `keyBytes`: how long a key is. The key is the one before the
/// child.
using Hdf5OldLeaf = std::function<void(std::span<const std::uint8_t> key, std::uint64_t child)>;
void walkOldHdf5Tree(const Hdf5Store& store, std::uint64_t address, int kind, std::size_t keyBytes,
                     const Hdf5OldLeaf& leaf);

/// Calls take(record) for every record of a tree of version 2 (section III.A.2), in its order.
using Hdf5Record = std::function<void(std::span<const std::uint8_t> record)>;
void walkNewHdf5Tree(const Hdf5Store& store, std::uint64_t address, const Hdf5Record& take);

}  // namespace aeolic
