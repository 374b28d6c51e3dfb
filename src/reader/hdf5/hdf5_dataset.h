#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reader/binary/numbers.h"
#include "reader/binary/slab.h"

namespace aeolic {

/// A data set's elements, and how to get at them. Whoever makes one holds a Hdf5Lock. The library's identifiers (hid_t)
/// are numbers of 64 bits here, so that its headers stay away from those who read.
class Hdf5DataSet {
public:
    /// `id`: of the data set. `file` and `name`: for messages. All must outlive this.
    Hdf5DataSet(std::int64_t id, const std::string& file, const std::string& name);

    const std::vector<std::uint64_t>& shape() const { return shape_; }
    std::uint64_t count() const { return count_; }
    std::optional<NumberType> type() const { return type_; }

    template <class Number>
    std::vector<Number> read(const Slab& slab) const;
    std::string characters() const;

private:
    struct Chunks;

    void requireOtherFiles(std::int64_t creation) const;
    std::optional<Chunks> plainChunks(std::int64_t creation, const Slab& slab) const;
    template <class Number>
    void readChunk(const Chunks& chunks, std::uint64_t number, const Slab& slab, std::vector<Number>& values) const;
    void readByLibrary(std::int64_t type, const Slab& slab, void* values) const;
    [[noreturn]] void fail(const std::string& found, const std::string& expected = "a complete, undamaged file") const;

    std::int64_t id_;
    const std::string& file_;
    const std::string& name_;
    std::vector<std::uint64_t> shape_;  // Slowest first.
    std::uint64_t count_ = 0;
    std::optional<NumberType> type_;
    const char* kind_ = "";  // Of elements that are no numbers.
    bool exact_ = false;     // The file has `type_` bit by bit, but perhaps in the other byte order.
    bool swapped_ = false;   // The file's byte order is not this machine's.
};

}  // namespace aeolic
