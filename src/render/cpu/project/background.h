#pragma once

#include <vector>

#include "base/extent.h"
#include "render/cpu/project/visibility.h"
#include "render/gbuffer.h"

namespace aeolic::cpu {

/// Writes background over `tile`: what later stages test of pixels. The other images are never read there.
void clearTile(const Extent& tile, GBuffer& out);

/// Local. `out.surface` of `rows`, those of the tiles of `visibility`: from the first to the last tile of a row in
/// which anything is `seen`, [tiles].
void findSurfaceColumns(const Visibility& visibility, const Extent& rows, const std::vector<char>& seen, GBuffer& out);

/// Local. Writes what later stages read of the tiles in which nothing is seen: all that they test where there is
/// surface on both sides in a row; beside the surface its flow and links, as far as traces look (NearFlow), and its
/// depth, where edges are looked for. Needs `out.surface`.
void clearBackground(const Visibility& visibility, const std::vector<char>& seen, GBuffer& out);

}  // namespace aeolic::cpu
