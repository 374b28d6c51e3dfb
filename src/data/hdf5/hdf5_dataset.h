#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "data/hdf5/hdf5_chunks.h"
#include "data/hdf5/hdf5_file.h"

namespace aeolic {

/// A data set's elements, and how to get at them.
class Hdf5DataSet {
public:
    /// `name`: for messages; it must outlive this, like the others.
    Hdf5DataSet(const Hdf5Store& store, const std::vector<Hdf5Message>& header, const std::string& name);

    const Hdf5Type& type() const { return type_; }
    const Hdf5Space& space() const { return space_; }

    /// A slab as numbers. Throws InputError for a slab that is not within the data set, and for elements that are none.
    template <class Number>
    std::vector<Number> read(const Slab& slab) const;

    /// All elements as they stand in the file.
    std::vector<std::uint8_t> bytes() const;

private:
    /// take(at, count, bytes): so many elements of the slab from the element `at` on. Threads may call it at once.
    using Take = std::function<void(std::uint64_t at, std::uint64_t count, const std::uint8_t* bytes)>;

    void require(const Slab& slab) const;
    void requireStored(std::uint64_t count, const std::vector<Hdf5Chunk>& chunks, std::size_t bytesInMemory) const;
    std::vector<Hdf5Chunk> chunksIn(const Slab& slab) const;
    std::uint64_t storedBytes(const std::vector<Hdf5Chunk>& chunks) const;
    void readInto(const Slab& slab, const std::vector<Hdf5Chunk>& chunks, const Take& take) const;
    void readContiguous(const Slab& slab, const Take& take) const;
    void readChunk(const Hdf5Chunk& chunk, const Slab& slab, const Take& take) const;

    const Hdf5Store& store_;
    const std::string& name_;
    Hdf5Type type_;
    Hdf5Space space_;
    Hdf5Layout layout_;
    std::vector<Hdf5Filter> filters_;
    std::vector<std::uint8_t> fill_;  // An element that was never written; empty: zeros.
};

}  // namespace aeolic
