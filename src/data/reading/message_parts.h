#pragma once

#include <cstdint>
#include <optional>

#include "base/byte_message.h"

namespace aeolic {

// Parts of messages between a reader and its caller, beside those that ByteWriter and ByteReader know.

template <class Value>
void addMaybe(ByteWriter& message, const std::optional<Value>& value)
{
    message.add(std::uint8_t(value.has_value()));
    if (value) message.add(*value);
}

template <class Value>
void readMaybe(ByteReader& message, std::optional<Value>& value)
{
    std::uint8_t has = 0;
    message.read(has);
    if (has != 0) message.read(value.emplace());
}

inline void readFlag(ByteReader& message, bool& flag)
{
    std::uint8_t byte = 0;
    message.read(byte);
    flag = byte != 0;
}

/// The length of a list, each of whose items takes a byte at least: to read more of them than there are throws.
inline std::uint64_t readCount(ByteReader& message)
{
    std::uint64_t count = 0;
    message.read(count);
    return count;
}

}  // namespace aeolic
