#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reader/binary/numbers.h"

namespace aeolic {

/// A section of a Fluent file: "(13 (zone first last kind shape)(…))". Its numbers are text, or bytes where its index
/// is above 2000.
struct FluentSection {
    int index = 0;  ///< Of its kind: 10, 12, 13 …, for bytes and text alike.
    bool binary = false, doubles = false;
    std::string_view head;  ///< In the first parentheses, or all where there are none.
    std::string_view body;  ///< In the second ones.
};

/// A Fluent file, all of it in memory. Every failure is an InputError that begins with the file's name.
class FluentText {
public:
    explicit FluentText(const std::string& path);

    const std::string& path() const { return path_; }
    const std::vector<FluentSection>& sections() const { return sections_; }

    /// The words of a section's head.
    std::vector<std::string> words(const FluentSection& section) const;

    /// A word of a head as a whole number from 0.
    std::int64_t number(const std::string& word, int base) const;

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

private:
    void refuseGmsh() const;
    void skipBlank();
    std::string_view parentheses();
    void readSection();

    std::string path_, data_;
    std::size_t at_ = 0;
    std::vector<FluentSection> sections_;
};

/// Whether numbers in binary sections have their bytes the other way round, by the words of section 4, at least one.
inline bool fluentIsSwapped(const std::vector<std::string>& words)
{
    return words[0] != "60";
}

/// Numbers of a section's body, one after the other: whole numbers to the base 16 in text.
class FluentNumbers {
public:
    /// `swapped`: bytes are not in this machine's order.
    FluentNumbers(const FluentText& text, const FluentSection& section, bool swapped)
        : text_(text), section_(section), swapped_(swapped)
    {
    }

    std::int64_t whole();
    double real();

private:
    std::string_view word();
    template <class Number>
    Number fromBytes(NumberType type);
    [[noreturn]] void endsTooEarly() const;
    [[noreturn]] void isNone(std::string_view word, const char* expected) const;

    const FluentText& text_;
    const FluentSection& section_;
    bool swapped_;
    std::size_t at_ = 0;
};

}  // namespace aeolic
