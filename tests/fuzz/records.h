#pragma once

#include <cstdint>
#include <cstdlib>

#include "stream/wire.h"

/// What the fuzz targets share. An input is a row of records: what happens, two bytes of length, that many bytes.
namespace aeolic::stream::fuzz {

struct Record {
    std::uint8_t what = 0;
    ByteView bytes;
};

/// Takes the first record off `input`, cut to what is there. False where there is none.
inline bool takeRecord(ByteView& input, Record& record)
{
    if (input.size() < 3) return false;
    record.what = input[0];
    const std::size_t length = std::min<std::size_t>(input[1] | input[2] << 8, input.size() - 3);
    record.bytes = input.subspan(3, length);
    input = input.subspan(3 + length);
    return true;
}

/// Something that must hold, whatever came over the wire.
inline void require(bool holds)
{
    if (!holds) std::abort();
}

}  // namespace aeolic::stream::fuzz
