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

}  // namespace

std::string lastWords(std::string_view written)
{
    std::vector<std::string_view> lines = splitText(written, '\n');
    for (std::string_view& line : lines) line = trimmedText(line);
    std::erase(lines, "");
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
