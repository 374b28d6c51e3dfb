#include "base/text.h"

#include <algorithm>
#include <filesystem>

namespace aeolic {

std::string lowerCase(std::string text)
{
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return text;
}

std::string lowerExtension(const std::string& path)
{
    return lowerCase(std::filesystem::path(path).extension().string());
}

std::string withSpaces(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c >= '\t' && c <= '\r'; }, ' ');
    return text;
}

std::string withoutControls(std::string text, char instead)
{
    std::replace_if(text.begin(), text.end(), isControl, instead);
    return text;
}

std::vector<std::string_view> splitText(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (std::size_t start = 0;;) {
        const std::size_t end = text.find(separator, start);
        parts.push_back(text.substr(start, end - start));
        if (end == std::string_view::npos) return parts;
        start = end + 1;
    }
}

std::string_view trimmedText(std::string_view text)
{
    constexpr const char* whiteSpace = " \t\n\v\f\r";
    const std::size_t begin = std::min(text.find_first_not_of(whiteSpace), text.size());
    return text.substr(begin, text.find_last_not_of(whiteSpace) + 1 - begin);
}

std::optional<char32_t> nextCharacter(std::string_view text, std::size_t& at)
{
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned first = byte(at++);
    if (first < 0x80) return char32_t(first);
    const int more = first >= 0xf0 && first < 0xf5   ? 3
                     : first >= 0xe0 && first < 0xf0 ? 2
                     : first >= 0xc2 && first < 0xe0 ? 1
                                                     : 0;
    if (more == 0) return std::nullopt;
    char32_t code = first & (0x3fu >> more);
    for (int i = 0; i < more; ++i) {
        if ((byte(at) & 0xc0) != 0x80) return std::nullopt;
        code = code << 6 | (byte(at++) & 0x3f);
    }
    const char32_t least[] = {0, 0x80, 0x800, 0x10000};
    if (code < least[more] || (code >= 0xd800 && code < 0xe000) || code > 0x10ffff) return std::nullopt;
    return code;
}

bool isUtf8(std::string_view text)
{
    for (std::size_t at = 0; at < text.size();)
        if (!nextCharacter(text, at)) return false;
    return true;
}

std::size_t characterStart(std::string_view text, std::size_t at)
{
    while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80) --at;
    return at;
}

std::string xmlText(const std::string& text)
{
    std::string out;
    for (const char c : withoutControls(text))
        out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
    return out;
}

}  // namespace aeolic
