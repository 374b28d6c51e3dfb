#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "data/hdf5/hdf5_store.h"

namespace aeolic {

/// What a message in an object's header is about (section IV.A.2).
enum class Hdf5MessageKind {
    dataspace = 1,
    linkInfo = 2,
    datatype = 3,
    fillValue = 5,
    link = 6,
    externalFiles = 7,
    layout = 8,
    filters = 11,
    attribute = 12,
    continuation = 16,
    symbolTable = 17,
    attributeInfo = 21
};

struct Hdf5Message {
    int kind = 0;
    std::vector<std::uint8_t> data;
};

/// All messages of the header at an address, in both of its forms (section IV.A.1). Those that stand in another
/// object's header are fetched from there.
std::vector<Hdf5Message> readHdf5Header(const Hdf5Store& store, std::uint64_t address);

/// The first of a kind, or null.
const Hdf5Message* findMessage(const std::vector<Hdf5Message>& messages, Hdf5MessageKind kind);

/// What a shared message refers to: the message of that kind in another object's header.
Hdf5Message sharedHdf5Message(const Hdf5Store& store, int kind, std::span<const std::uint8_t> reference);

}  // namespace aeolic
