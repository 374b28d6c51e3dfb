#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace aeolic {

/// What lies over a scene's surface: the parts of ShadingOptions::overlay.
struct Overlays {
    static constexpr double kUsualSpacingPx = 24, kLeastSpacingPx = 4, kMostSpacingPx = 1000;

    bool topology = false, separation = false, edges = false, outline = false;
    double streamlinesPx = 0;                      ///< Their spacing; 0: none.
    std::optional<std::array<double, 3>> through;  ///< World position: the streamline through the place nearest to it.

    bool any() const { return topology || separation || streamlinesPx > 0 || through || edges || outline; }
};

inline constexpr std::string_view overlayNames[] = {"none",       "streamlines", "topology",
                                                    "separation", "edges",       "outline"};

/// The texts that are no name, in words and for the page.
inline constexpr auto overlayListText =
    "several of them with ',' between, as streamlines:PX,topology,through:X:Y:Z, with PX from 4 to 1000";
inline constexpr auto overlayListPattern =
    "^(?!.*(topology|separation|edges|outline|streamlines|through).*\\1)"
    "((topology|separation|edges|outline|streamlines(:(([4-9]|[1-9][0-9]{1,2})([.][0-9]+)?|1000))?|"
    "through(:-?[0-9]+([.][0-9]+)?(e[+-]?[0-9]+)?){3})(,(?!$)|$))+$";

/// Reads "none" or a list in which nothing stands twice: "streamlines:16,through:1:0:0.5". Nothing where it is not one.
std::optional<Overlays> parseOverlays(std::string_view text);

/// Reads such a text that was checked before.
Overlays overlaysOf(std::string_view text);

/// It is a list, or one of the names.
bool isOverlayList(std::string_view text);

}  // namespace aeolic
