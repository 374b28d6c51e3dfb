#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "base/uninitialized.h"

namespace aeolic {

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

    Bytes take() { return std::move(bytes_); }

    template <class... Values>
    void addAll(const Values&... values)
    {
        (add(values), ...);
    }

private:
    void append(const void* from, std::size_t count)
    {
        const std::size_t before = bytes_.size();
        bytes_.resize(before + count);
        if (count > 0) std::memcpy(bytes_.data() + before, from, count);
    }

    Bytes bytes_;
};

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
