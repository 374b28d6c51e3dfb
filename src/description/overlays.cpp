#include "description/overlays.h"

#include <algorithm>
#include <utility>

#include "description/option_rules.h"

namespace aeolic {
namespace {

/// ":1:0.5:-2"
std::optional<std::array<double, 3>> positionFrom(std::string_view text)
{
    std::array<double, 3> position{};
    for (double& number : position) {
        if (!text.starts_with(':')) return std::nullopt;
        text.remove_prefix(1);
        const std::size_t end = std::min(text.find(':'), text.size());
        const std::optional<double> read = parseNumber(text.substr(0, end));
        if (!read) return std::nullopt;
        number = *read;
        text.remove_prefix(end);
    }
    return text.empty() ? std::optional(position) : std::nullopt;
}

bool takeOne(std::string_view word, Overlays& overlays)
{
    constexpr std::string_view through = "through";
    if (word.starts_with(through)) {
        if (overlays.through) return false;
        overlays.through = positionFrom(word.substr(through.size()));
        return overlays.through.has_value();
    }
    constexpr std::string_view streamlines = "streamlines";
    if (word == "topology") return !std::exchange(overlays.topology, true);
    if (word == "separation") return !std::exchange(overlays.separation, true);
    if (word == "edges") return !std::exchange(overlays.edges, true);
    if (word == "outline") return !std::exchange(overlays.outline, true);
    if (!word.starts_with(streamlines) || overlays.streamlinesPx > 0) return false;
    word.remove_prefix(streamlines.size());
    overlays.streamlinesPx = Overlays::kUsualSpacingPx;
    if (word.empty()) return true;
    if (!word.starts_with(':')) return false;
    const std::optional<double> px = parseNumber(word.substr(1));
    overlays.streamlinesPx = px.value_or(0);
    return px && *px >= Overlays::kLeastSpacingPx && *px <= Overlays::kMostSpacingPx;
}

}  // namespace

std::optional<Overlays> parseOverlays(std::string_view text)
{
    Overlays overlays;
    if (text == "none") return overlays;
    while (true) {
        const std::size_t comma = text.find(',');
        if (!takeOne(text.substr(0, comma), overlays)) return std::nullopt;
        if (comma == std::string_view::npos) return overlays;
        text.remove_prefix(comma + 1);
    }
}

Overlays overlaysOf(std::string_view text)
{
    return parseOverlays(text).value_or(Overlays{});
}

bool isOverlayList(std::string_view text)
{
    return parseOverlays(text).has_value();
}

}  // namespace aeolic
