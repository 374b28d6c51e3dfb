#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/extent.h"
#include "cluster/comm/communicator.h"

namespace aeolic {

/// Neighbouring pixels of a row that hold something: columns [x0, x1).
struct PixelRun {
    std::uint16_t x0, x1;
};

/// Rows [y0, y1) that a rank needs and in which something is seen. A message of pixels begins with them.
struct MessageRows {
    std::int32_t y0, y1;
};

template <class T>
void appendBytes(Bytes& bytes, const T* values, std::size_t count)
{
    const auto* from = reinterpret_cast<const std::byte*>(values);
    bytes.insert(bytes.end(), from, from + count * sizeof(T));
}

/// A message of values and of nothing else.
template <class Value>
Bytes messageOf(const std::vector<Value>& values)
{
    Bytes bytes;
    appendBytes(bytes, values.data(), values.size());
    return bytes;
}

/// What such a message holds. Throws std::runtime_error naming the sender where that is a part of a value.
template <class Value>
std::vector<Value> valuesOf(const Message& message)
{
    if (message.bytes.size() % sizeof(Value) != 0)
        throw std::runtime_error("rank " + std::to_string(message.rank) + " sent a part of a value");
    std::vector<Value> values(message.bytes.size() / sizeof(Value));
    if (!values.empty()) std::memcpy(values.data(), message.bytes.data(), message.bytes.size());
    return values;
}

/// The columns of `drawn` for which holds(x) is true, as runs.
template <class Holds>
void findRuns(const Extent& drawn, const Holds& holds, std::vector<PixelRun>& runs)
{
    runs.clear();
    for (int x = drawn.x0; x < drawn.x1; ++x) {
        if (!holds(x)) continue;
        const int begin = x;
        while (x < drawn.x1 && holds(x)) ++x;
        runs.push_back({std::uint16_t(begin), std::uint16_t(x)});
    }
}

/// Appends the number of runs (16 bits), then each one's columns (16 bits each).
void appendRuns(Bytes& bytes, const std::vector<PixelRun>& runs);

/// Reads a message of pixels in order. Everything throws std::runtime_error naming the sender where the message ends
/// too early or holds other pixels than those of `rows`, which its receiver needs.
class PixelReader {
public:
    PixelReader(const Bytes& bytes, int sender) : bytes_(bytes), sender_(sender) {}

    MessageRows rows(const Extent& rows);
    void runs(const Extent& rows, std::vector<PixelRun>& runs);  ///< The next row's runs: ascending, none empty.
    void read(void* to, std::size_t bytes);
    const std::byte* skip(std::size_t bytes);  ///< Returns where the skipped bytes begin.
    void requireEnd() const;

private:
    [[noreturn]] void fail(const std::string& what) const;

    const Bytes& bytes_;
    int sender_;
    std::size_t at_ = 0;
};

}  // namespace aeolic
