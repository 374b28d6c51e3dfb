#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "aeolic/picture.h"
#include "aeolic/renderer.h"
#include "engine/frame_group.h"
#include "render/overlay/figure.h"

namespace aeolic {

/// All pixels of the picture that rank 0 gathered, or that one rank drew. `kept`: a picture that nobody needs any more;
/// its memory is used again.
Picture gatheredPicture(const FrameTiles& tiles, int height, Picture kept = {});

/// Adds up what the ranks found in their own rows.
using SumOfRanks = std::function<void(std::vector<std::int64_t>&)>;

/// A frame for the user, with the figure on top: the whole picture where it is gathered, on rank 0, else a rank's own
/// rows with their part of the figure. `height` is the whole picture's. `steady`: the corner that the legend has all
/// through an animation, where it must not jump; without it, the one in which the surface covers least. Collective
/// where `sumOfRanks` is, and the picture is not gathered.
DrawnFrame pictureOf(const FrameTiles& tiles, int height, const Figure& figure, std::optional<Corner> steady,
                     const SumOfRanks& sumOfRanks, Picture kept);

}  // namespace aeolic
