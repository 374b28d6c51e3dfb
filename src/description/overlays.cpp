#include "description/overlays.h"

#include <utility>

#include "description/option_rules.h"

namespace aeolic {
namespace {

bool takeOne(std::string_view word, Overlays& overlays)
{
    constexpr std::string_view streamlines = "streamlines";
    if (word == "topology") return !std::exchange(overlays.topology, true);
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
