#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/overlay/orientation_axes.h"
#include "render/overlay/scalar_bar.h"

namespace aeolic {

/// Legends, texts and axes around the surface in a picture. A part that has no room is left out.
struct Figure {
    std::vector<ScalarBar> bars;  ///< Beside each other in one corner; as many as fit there.
    std::string title, stamp;     ///< UTF-8, shown as they are; long ones are shortened with an ellipsis. Empty: none.
    /// What the stamp is in other pictures of the same animation: the bars have the same places in all of them.
    std::vector<std::string> otherStamps;
    std::optional<Orientation> axes;
    Inks inks = Inks::dark;
    double textScale = 1;  ///< The size of everything, relative to the usual one.
};

/// A corner of the picture, in the order in which bars take them. One bit is left or right, the other upper or lower.
enum class Corner : unsigned { upperRight, lowerRight, upperLeft, lowerLeft };

/// Where the parts of a figure stand. The title is in the middle of the upper edge, the axes are in the lower left
/// corner, the stamp in the lower right one, and the bars in a corner that they fit beside them. Nothing overlaps and
/// nothing is cut off. It depends on the picture's size and the figure alone.
struct FigureLayout {
    FigureLayout(const Figure& figure, int pictureWidth, int pictureHeight);

    /// Which of the places is in that corner, or else nearest to it: above or below rather than on the other side. 0
    /// where there is none.
    std::size_t placeIn(Corner corner) const;

    /// What of the figure has no room in the picture, in words: "the title and the legend". Empty: all has.
    std::string leftOut(const Figure& figure) const;

    double em = 0;
    std::optional<Box> title, axes, stamp;
    std::vector<ScalarBarLayout> bars;  ///< Those that have room.
    /// The places of all bars: upper right, lower right, upper left, lower left, as far as they fit; perhaps none.
    std::vector<Box> barPlaces;
    std::vector<Corner> barCorners;  ///< [barPlaces] Where those are.
};

/// How many pixels of these rows that are not background lie in each of the boxes.
std::vector<std::int64_t> coveredPixels(const PictureRows& picture, const std::vector<Box>& boxes,
                                        const std::array<std::uint8_t, 4>& background);

/// The first place with the fewest covered pixels, 0 where there is none.
std::size_t freestPlace(const std::vector<std::int64_t>& covered);

/// Draws what of the figure lies in these rows, with the bar at that of its places. The pixels are the same on every
/// run and machine.
void drawFigure(const PictureRows& picture, const Figure& figure, const FigureLayout& layout, std::size_t barPlace);

}  // namespace aeolic
