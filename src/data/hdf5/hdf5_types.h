#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "data/binary/numbers.h"
#include "data/hdf5/hdf5_header.h"

namespace aeolic {

/// What one element of a data set or attribute is (section IV.A.2.d).
struct Hdf5Type {
    enum class Kind { number, text, variableText, other };
    Kind kind = Kind::other;
    std::uint32_t bytes = 0;  ///< In the file.
    NumberType number = NumberType::int8;
    bool swapped = false;   ///< The file's byte order is not this machine's.
    std::string name = "";  ///< Of what is `other`, for messages: "compound".
};

/// How many elements there are (section IV.A.2.b).
struct Hdf5Space {
    std::vector<std::uint64_t> shape;  ///< Slowest first; empty: a single one.
    std::vector<std::uint64_t> most;   ///< As large as each may become; ~0: without limit.
    bool none = false;                 ///< It has no elements at all.

    std::uint64_t count() const;  ///< At most 2^62.
};

Hdf5Type parseHdf5Type(const Hdf5Store& store, std::span<const std::uint8_t> message);
Hdf5Space parseHdf5Space(const Hdf5Store& store, std::span<const std::uint8_t> message);

struct Hdf5Attribute {
    std::string name;
    Hdf5Type type;
    Hdf5Space space;
    std::vector<std::uint8_t> data;
};
/// The attribute if it is the one `wanted`. Types and shapes of others may stand in other objects' headers; those are
/// not read.
std::optional<Hdf5Attribute> parseHdf5Attribute(const Hdf5Store& store, std::span<const std::uint8_t> message,
                                                const std::string& wanted);

/// Every text among `data`, without what fills it up.
std::vector<std::string> hdf5Texts(const Hdf5Store& store, const Hdf5Type& type, std::uint64_t count,
                                   std::span<const std::uint8_t> data);

}  // namespace aeolic
