#include "render/overlay/title_lines.h"

#include <algorithm>
#include <optional>

namespace aeolic {
namespace {

struct Halves {
    std::string_view first, second;
};

/// Every way to break the title, from the left.
std::vector<Halves> breaksOf(std::string_view title)
{
    std::vector<Halves> breaks;
    int depth = 0;
    for (std::size_t at = 0; at < title.size(); ++at) {
        const char c = title[at];
        if (c == '[' || c == '(') ++depth;
        if (c == ']' || c == ')') depth = std::max(depth - 1, 0);
        if (c != ' ' || depth > 0 || at == 0 || title[at - 1] == ' ') continue;
        const std::size_t next = title.find_first_not_of(' ', at);
        if (next != title.npos) breaks.push_back({title.substr(0, at), title.substr(next)});
    }
    return breaks;
}

bool isUnit(std::string_view text)
{
    return (text.starts_with('[') && text.ends_with(']')) || (text.starts_with('(') && text.ends_with(')'));
}

/// Both lines whole, the wider one as narrow as can be.
std::optional<Halves> evenHalves(const std::vector<Halves>& breaks, double widestPx, const TextPainter& text)
{
    std::optional<Halves> best;
    double bestPx = widestPx;
    for (const Halves& halves : breaks) {
        const double px = std::max(text.widthPx(halves.first), text.widthPx(halves.second));
        if (px > bestPx || (best && px == bestPx)) continue;
        best = halves;
        bestPx = px;
    }
    return best;
}

}  // namespace

std::vector<std::string> titleLines(std::string_view title, double widestPx, const TextPainter& text)
{
    const std::string whole = text.fitted(title, widestPx);
    if (whole.empty() || whole == title) return whole.empty() ? std::vector<std::string>{} : std::vector{whole};
    const std::vector<Halves> breaks = breaksOf(title);
    if (const auto halves = evenHalves(breaks, widestPx, text))
        return {std::string(halves->first), std::string(halves->second)};
    const auto shortened = [&](const Halves& halves) {
        return std::vector{text.fitted(halves.first, widestPx), text.fitted(halves.second, widestPx)};
    };
    if (!breaks.empty() && isUnit(breaks.back().second) && text.widthPx(breaks.back().second) <= widestPx)
        return shortened(breaks.back());
    const auto fits = [&](const Halves& halves) { return text.widthPx(halves.first) <= widestPx; };
    const auto last = std::find_if(breaks.rbegin(), breaks.rend(), fits);
    return last == breaks.rend() ? std::vector{whole} : shortened(*last);
}

}  // namespace aeolic
