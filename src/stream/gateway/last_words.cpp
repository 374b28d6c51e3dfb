#include "stream/gateway/last_words.h"

#include <algorithm>
#include <vector>

#include "base/text.h"

namespace aeolic::stream {
namespace {

constexpr std::size_t kMostLines = 3;
constexpr std::size_t kMostBytes = 400;
constexpr std::size_t kShortestRuler = 20;

bool isRuler(std::string_view line)
{
    return line.size() >= kShortestRuler && line.find_first_not_of("-=*") == line.npos;
}

std::string_view trimmed(std::string_view line)
{
    const std::size_t begin = line.find_first_not_of(" \t\r");
    return begin == line.npos ? std::string_view() : line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string_view> linesOf(std::string_view text)
{
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (const std::string_view line = trimmed(text.substr(0, end)); !line.empty()) lines.push_back(line);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

}  // namespace

std::string lastWords(std::string_view written)
{
    std::vector<std::string_view> lines = linesOf(written);
    if (!lines.empty() && isRuler(lines.back())) {
        lines.pop_back();
        const auto ruler = std::find_if(lines.rbegin(), lines.rend(), isRuler);
        lines.erase(lines.begin(), ruler.base());
        lines.resize(std::min(lines.size(), kMostLines));
    }
    std::erase_if(lines, isRuler);
    const std::size_t first = lines.size() - std::min(lines.size(), kMostLines);
    std::string words;
    for (std::size_t i = first; i < lines.size(); ++i) words += (words.empty() ? "" : " ") + std::string(lines[i]);
    words = withoutControls(std::move(words));
    return words.size() <= kMostBytes ? words : words.substr(0, kMostBytes) + " …";
}

}  // namespace aeolic::stream
