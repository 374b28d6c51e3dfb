#pragma once

#include <cstdint>

#include "base/image.h"
#include "render/gbuffer.h"

namespace aeolic {

/// What one rank's piece of the surface gives the picture, wherever in the image its pixels fall, as long as no other
/// piece is in front.
struct SurfacePixels {
    Extent drawn;                ///< Global pixels that may hold something: where the piece's box is seen.
    Image<std::uint32_t> depth;  ///< Bits of 1 / eye depth by which triangles hide each other; 0: nothing here.
    Image<std::uint64_t> order;  ///< SurfaceMesh::order of the triangle seen: of equally near ones the least shows.
    GBuffer seen;                ///< All but the links.
};

}  // namespace aeolic
