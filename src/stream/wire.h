#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace aeolic::stream {

/// A message is damaged, hostile or of another version. One line, for logs: it holds nothing of the bytes
/// themselves. Who sent them is not to be trusted further.
class ProtocolError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

using ByteVector = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

inline void putU16(ByteVector& out, std::uint16_t value)
{
    out.push_back(std::uint8_t(value));
    out.push_back(std::uint8_t(value >> 8));
}
inline void putU32(ByteVector& out, std::uint32_t value)
{
    putU16(out, std::uint16_t(value));
    putU16(out, std::uint16_t(value >> 16));
}
inline void putText(ByteVector& out, std::string_view text)
{
    out.insert(out.end(), text.begin(), text.end());
}

/// Takes little-endian numbers from the front of a message. Throws ProtocolError where it is too short.
class WireReader {
public:
    explicit WireReader(ByteView bytes) : rest_(bytes) {}

    std::uint8_t u8() { return take(1)[0]; }
    std::uint16_t u16()
    {
        const ByteView b = take(2);
        return std::uint16_t(b[0] | b[1] << 8);
    }
    std::uint32_t u32()
    {
        const std::uint32_t low = u16();
        return low | std::uint32_t(u16()) << 16;
    }
    ByteView rest() const { return rest_; }
    std::string_view text() const { return {reinterpret_cast<const char*>(rest_.data()), rest_.size()}; }
    void expectEnd() const
    {
        if (!rest_.empty()) throw ProtocolError("a message is longer than its type");
    }

private:
    ByteView take(std::size_t count)
    {
        if (rest_.size() < count) throw ProtocolError("a message is shorter than its type");
        const ByteView front = rest_.first(count);
        rest_ = rest_.subspan(count);
        return front;
    }
    ByteView rest_;
};

}  // namespace aeolic::stream
