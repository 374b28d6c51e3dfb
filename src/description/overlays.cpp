#include "description/overlays.h"

#include <utility>

#include "base/text.h"
#include "description/option_rules.h"

namespace aeolic {
namespace {

/// ":1:0.5:-2"
std::optional<std::array<double, 3>> positionFrom(std::string_view text)
{
    const auto parts = splitText(text, ':');
    if (parts.size() != 4 || !parts.front().empty()) return std::nullopt;
    std::array<double, 3> position{};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::optional<double> read = parseNumber(parts[c + 1]);
        if (!read) return std::nullopt;
        position[c] = *read;
    }
    return position;
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
    for (const std::string_view word : splitText(text, ','))
        if (!takeOne(word, overlays)) return std::nullopt;
    return overlays;
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
