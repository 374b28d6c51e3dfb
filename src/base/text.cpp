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

std::string withoutControls(std::string text)
{
    std::replace_if(text.begin(), text.end(), isControl, '?');
    return text;
}

std::size_t characterStart(std::string_view text, std::size_t at)
{
    while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80) --at;
    return at;
}

}  // namespace aeolic
