#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "aeolic/picture.h"
#include "aeolic/renderer.h"
#include "engine/frame_group.h"
#include "render/overlay/figure.h"

namespace aeolic {

/// All pixels of the picture that rank 0 gathered, or that one rank drew. `kept`: a picture that nobody needs any more;
/// its memory is used again.
Picture gatheredPicture(const FrameTiles& tiles, int height, Picture kept = {});

/// How a legend finds its corner: `steady`, the one that it has all through an animation, where it must not jump; else
/// the one in which the surface covers least. `sumOfRanks` adds up what the ranks found in their own rows.
struct LegendPlace {
    std::optional<Corner> steady;
    std::function<void(std::vector<std::int64_t>&)> sumOfRanks = [](std::vector<std::int64_t>&) {};
};

/// The gathered picture for the user, with the figure on top.
DrawnFrame pictureOf(const FrameTiles& tiles, int height, const Figure& figure, std::optional<Corner> steady,
                     Picture kept);

/// A rank's own rows for the user, with their part of the figure. `height` is the whole picture's. Collective where
/// `place.sumOfRanks` is.
DrawnFrame pictureOf(const Tile& stripe, int height, const Figure& figure, const LegendPlace& place, Picture kept);

}  // namespace aeolic
