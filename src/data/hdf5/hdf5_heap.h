#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "data/hdf5/hdf5_store.h"

namespace aeolic {

/// The object `index` of a global heap's collection (section III.E): a text of no fixed length.
std::vector<std::uint8_t> readGlobalHeap(const Hdf5Store& store, std::uint64_t address, std::uint32_t index,
                                         std::uint64_t count);

/// A fractal heap (section III.G), which holds the links and attributes of objects that have many.
class Hdf5FractalHeap {
public:
    Hdf5FractalHeap(const Hdf5Store& store, std::uint64_t address);

    std::size_t idBytes() const { return idBytes_; }

    /// What an object's ID, as the trees over the heap have it, stands for.
    std::vector<std::uint8_t> object(std::span<const std::uint8_t> id) const;

private:
    std::uint64_t blockBytes(std::uint64_t row) const;
    std::vector<std::uint8_t> managed(std::uint64_t offset, std::uint64_t length) const;

    const Hdf5Store& store_;
    std::size_t idBytes_ = 0, offsetBytes_ = 0, lengthBytes_ = 0;
    std::uint64_t width_ = 0, firstBlock_ = 0, largestDirect_ = 0, root_ = 0, rows_ = 0, directRows_ = 0;
};

}  // namespace aeolic
