#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aeolic {

/// The text with a to z in place of A to Z. Other letters stay as they are.
std::string lowerCase(std::string text);

/// The extension of the file that a path names, in lower case: ".vtp". Empty where there is none.
std::string lowerExtension(const std::string& path);

/// Whether a character moves the cursor or does something else that no text needs.
inline bool isControl(char c)
{
    return static_cast<unsigned char>(c) < ' ' || c == 127;
}

/// The text with `instead` in place of control characters: a space for messages, which are one line. Names and keywords
/// of files take a '?', which shows that something was there, and a word stays one.
std::string withoutControls(std::string text, char instead = ' ');

/// The text with spaces in place of tabs and ends of lines.
std::string withSpaces(std::string text);

/// The parts of a text between separators; at least one, and any may be empty.
std::vector<std::string_view> splitText(std::string_view text, char separator);

/// The text without white space at its ends.
std::string_view trimmedText(std::string_view text);

/// The number that the whole text is, as std::from_chars() reads it; nothing where it is anything else. `base`: of a
/// whole number, 10 unless given.
template <class Number, class... Base>
std::optional<Number> wholeTextAs(std::string_view text, Base... base)
{
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base...);
    const bool isWhole = error == std::errc() && end == text.data() + text.size();
    return isWhole ? std::optional(number) : std::nullopt;
}

/// Text as it stands in XML and HTML, between tags or in double quotes, without control characters.
std::string xmlText(const std::string& text);

/// The next character of UTF-8 `text` at `at`, which moves past it. Nothing for cut and overlong sequences and for
/// surrogates.
std::optional<char32_t> nextCharacter(std::string_view text, std::size_t& at);

bool isUtf8(std::string_view text);

/// The last place up to `at` where a character of a UTF-8 text begins.
std::size_t characterStart(std::string_view text, std::size_t at);

}  // namespace aeolic
