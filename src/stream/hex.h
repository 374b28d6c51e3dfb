#pragma once

#include <string>

#include "stream/wire.h"

namespace aeolic::stream {

/// Two hexadecimal digits a byte.
inline std::string hexText(ByteView bytes)
{
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += "0123456789abcdef"[byte >> 4];
        text += "0123456789abcdef"[byte & 15];
    }
    return text;
}

}  // namespace aeolic::stream
