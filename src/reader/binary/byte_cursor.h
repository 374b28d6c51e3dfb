#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "aeolic/error.h"

namespace aeolic {

/// Reads whole numbers of known widths, one after the other, out of a block of bytes. Nothing beyond the block is read:
/// that is an InputError which begins with the file's name.
class ByteCursor {
public:
    /// `item`: what the block is, for the message: "a group's links". Both must outlive the cursor.
    ByteCursor(std::span<const std::uint8_t> bytes, const std::string& path, const char* item, bool bigEndian = false)
        : bytes_(bytes), path_(path), item_(item), bigEndian_(bigEndian)
    {
    }

    std::size_t at() const { return at_; }
    std::size_t left() const { return bytes_.size() - at_; }

    /// The next `width` bytes as they are.
    std::span<const std::uint8_t> take(std::size_t width)
    {
        if (width > left()) fail("ends too early");
        at_ += width;
        return bytes_.subspan(at_ - width, width);
    }
    void skip(std::size_t width) { take(width); }

    /// An unsigned number of 1 to 8 bytes.
    std::uint64_t whole(std::size_t width)
    {
        if (width < 1 || width > 8) fail("has a number of unknown width");
        std::uint64_t value = 0;
        const auto bytes = take(width);
        for (std::size_t i = 0; i < width; ++i) value = value << 8 | bytes[bigEndian_ ? i : width - 1 - i];
        return value;
    }
    std::uint8_t u8() { return std::uint8_t(whole(1)); }
    std::uint16_t u16() { return std::uint16_t(whole(2)); }
    std::uint32_t u32() { return std::uint32_t(whole(4)); }
    std::uint64_t u64() { return whole(8); }

    std::string text(std::size_t width)
    {
        const auto bytes = take(width);
        return {bytes.begin(), bytes.end()};
    }

    /// Text up to a zero, behind which the cursor then stands.
    std::string textToZero()
    {
        std::string text;
        for (std::uint8_t byte = u8(); byte != 0; byte = u8()) text += char(byte);
        return text;
    }

    /// Throws unless the next bytes are `sign`.
    void expect(std::string_view sign)
    {
        if (text(sign.size()) != sign) fail("does not begin with its sign");
    }

    [[noreturn]] void fail(const std::string& found) const
    {
        throw InputError(path_, std::string(item_) + " " + found, "a complete, undamaged file");
    }

private:
    std::span<const std::uint8_t> bytes_;
    const std::string& path_;
    const char* item_;
    bool bigEndian_;
    std::size_t at_ = 0;
};

}  // namespace aeolic
