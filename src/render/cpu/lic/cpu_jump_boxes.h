#pragma once

#include "base/image.h"
#include "render/cpu/lic/hierarchical.h"
#include "render/lic/jump_boxes.h"
#include "render/lic/near_flow.h"

namespace aeolic::cpu {

/// Boxes without jumps for the stripe `own`, to be filled tile by tile.
JumpBoxes emptyBoxes(const JumpLevel& level, const Extent& own);

/// Local. Those of a tile of `own`, of whole blocks but for the stripe's ends; x0 of the image is 0. `near`: where
/// jumps have been written. One pass over them, best while a cache has them.
void addBoxes(const JumpLevel& level, const NearFlow& near, const Extent& own, const Extent& tile, JumpBoxes& boxes);

}  // namespace aeolic::cpu
