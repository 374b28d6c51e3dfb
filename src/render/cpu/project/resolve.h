#pragma once

#include "render/cpu/project/scene_arrays.h"
#include "render/cpu/project/visibility.h"
#include "render/gbuffer.h"
#include "render/lic/noise.h"
#include "render/share.h"
#include "render/view.h"

namespace aeolic::cpu {

/// Local. Turns one tile's visible triangles into the G-buffer's pixels: position, light, tangential vector projected
/// to the image, noise, scalar, depth and its gradient; everything but the links, which need the neighbours. Reads
/// `keys` over `tile`; writes the same pixels of `out`. Each visible pixel is computed once, whatever is behind it
/// (deferred projection). Cost: about 40 gathers a pixel plus 12 for a 3D field.
///
/// Where the field alone is split into bricks: the surface's part alone, with no flow, for others to fill in.
void resolveTile(const TileKeys& keys, const Extent& tile, const SceneArrays& arrays, const View& view,
                 const NoisePyramid& noise, GBuffer& out);

/// Local. The field's part alone, of the pixels that lie in this rank's brick; the same bits as without bricks.
/// `inBrick`: [triangles], 0 for those that have none.
void resolveBrickTile(const TileKeys& keys, const Extent& tile, const SceneArrays& arrays,
                      const std::vector<std::uint32_t>& inBrick, const View& view, const NoisePyramid& noise,
                      FieldPixels& out);

/// Where the surface is in pieces, beside resolveTile(): copies what says which piece is in front, the depth and order
/// of the visible triangles. `order`: SurfaceMesh::order.
void copyKeys(const TileKeys& keys, const Extent& tile, const std::vector<std::uint64_t>& order, SurfacePixels& out);

/// Writes background over `tile`.
void clearBrickTile(const Extent& tile, FieldPixels& out);

}  // namespace aeolic::cpu
