#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "base/uninitialized.h"

namespace aeolic {

/// `Value` or `const Value`.
template <class Type, class Value>
concept PerhapsConst = std::same_as<std::remove_const_t<Type>, Value>;

/// A visitor that takes any members, to find out whether there are any.
struct AnyMembers {
    template <class... Members>
    void operator()(const Members&...) const;
};

/// What is written and read member by member: withMembers(value, visit) calls visit(…) with all of them.
template <class Value>
concept HasMembers = requires(Value& value)
{
    withMembers(value, AnyMembers());
};

/// Puts values one behind the other into bytes, as they lie in memory: for other processes of the same program. A list
/// begins with its number of values.
class ByteWriter {
public:
    template <class Value>
    requires std::is_trivially_copyable_v<Value>
    void add(const Value& value) { append(&value, sizeof value); }
    template <class Value>
    requires std::is_trivially_copyable_v<Value>
    void add(const std::vector<Value>& values)
    {
        add(std::uint64_t(values.size()));
        append(values.data(), values.size() * sizeof(Value));
    }
    void add(const std::string& text)
    {
        add(std::uint64_t(text.size()));
        append(text.data(), text.size());
    }
    void add(const Bytes& bytes)
    {
        add(std::uint64_t(bytes.size()));
        append(bytes.data(), bytes.size());
    }
    void add(const std::vector<std::string>& texts)
    {
        add(std::uint64_t(texts.size()));
        for (const std::string& text : texts) add(text);
    }
    /// Writes whether there is a value, and the value if so.
    template <class Value>
    void add(const std::optional<Value>& value)
    {
        add(value.has_value());
        if (value) add(*value);
    }
    template <HasMembers Value>
    void add(const Value& value)
    {
        withMembers(value, [&](const auto&... members) { addAll(members...); });
    }
    template <HasMembers Value>
    void add(const std::vector<Value>& values)
    {
        add(std::uint64_t(values.size()));
        for (const Value& value : values) add(value);
    }

    Bytes take() { return std::move(bytes_); }

    template <class... Values>
    void addAll(const Values&... values)
    {
        (add(values), ...);
    }

private:
    // Not inlined: GCC 12 would warn of lengths that no text can have.
    [[gnu::noinline]] void append(const void* from, std::size_t count)
    {
        const std::size_t before = bytes_.size();
        bytes_.resize(before + count);
        if (count > 0) std::memcpy(bytes_.data() + before, from, count);
    }

    Bytes bytes_;
};

/// A message of one value.
template <class Value>
Bytes byteMessage(const Value& value)
{
    ByteWriter writer;
    writer.add(value);
    return writer.take();
}

/// Reads what a ByteWriter wrote, in the same order. Throws std::runtime_error where less is there.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : left_(bytes) {}

    template <class Value>
    requires std::is_trivially_copyable_v<Value>
    void read(Value& value) { std::memcpy(&value, next(sizeof value), sizeof value); }
    template <class Value>
    requires std::is_trivially_copyable_v<Value>
    void read(std::vector<Value>& values)
    {
        const std::size_t count = countOf(sizeof(Value));
        values.resize(count);
        if (count > 0) std::memcpy(values.data(), next(count * sizeof(Value)), count * sizeof(Value));
    }
    void read(std::string& text)
    {
        const std::size_t count = countOf(1);
        text.assign(reinterpret_cast<const char*>(next(count)), count);
    }
    /// A message within the message, where it lies.
    void read(std::span<const std::byte>& bytes)
    {
        const std::size_t count = countOf(1);
        bytes = {next(count), count};
    }
    void read(std::vector<std::string>& texts)
    {
        texts.resize(countOf(sizeof(std::uint64_t)));
        for (std::string& text : texts) read(text);
    }
    void read(bool& flag)  ///< Any byte but 0 is true: the sender may be damaged.
    {
        std::uint8_t byte = 0;
        read(byte);
        flag = byte != 0;
    }
    template <class Value>
    void read(std::optional<Value>& value)
    {
        bool has = false;
        read(has);
        Value one{};
        if (has) read(one);
        value = has ? std::optional<Value>(std::move(one)) : std::nullopt;
    }
    template <HasMembers Value>
    void read(Value& value)
    {
        withMembers(value, [&](auto&... members) { readAll(members...); });
    }
    template <HasMembers Value>
    void read(std::vector<Value>& values)
    {
        values.clear();
        for (std::size_t left = countOf(1); left > 0; --left) read(values.emplace_back());
    }
    template <class... Values>
    void readAll(Values&... values)
    {
        (read(values), ...);
    }
    bool atEnd() const { return left_.empty(); }

private:
    /// The length of a list whose values take at least so many bytes.
    std::size_t countOf(std::size_t bytesOfValue)
    {
        std::uint64_t count = 0;
        read(count);
        if (count > left_.size() / bytesOfValue) throw std::runtime_error("a message between ranks is cut off");
        return std::size_t(count);
    }
    const std::byte* next(std::size_t count)
    {
        if (count > left_.size()) throw std::runtime_error("a message between ranks is cut off");
        const std::byte* at = left_.data();
        left_ = left_.subspan(count);
        return at;
    }

    std::span<const std::byte> left_;
};

}  // namespace aeolic
