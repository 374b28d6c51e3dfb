#pragma once

#include <cstdint>
#include <variant>

#include "base/image.h"
#include "render/gbuffer.h"

namespace aeolic {

/// What one rank's brick of the field gives the picture, wherever in the image its pixels fall.
struct FieldPixels {
    Extent drawn;                 ///< Global pixels that may hold something: where the brick's box is seen.
    Image<std::uint32_t> flow;    ///< flow_texel; 0 where the pixel's cell is another rank's, or nothing flows.
    Image<std::uint32_t> masked;  ///< 1 where no streaks show, else 0. Only sized where a mask is asked for.
    Image<float> scalar;  ///< NaN where the pixel has none here. Only sized where the scalar comes from the field.
};

/// The pixels of the G-buffer that come from the field, in this process's memory, for all ranks' pixels to go to.
struct FieldRows {
    Image<std::uint32_t>* flow = nullptr;    ///< flow_texel; holds 0 where nobody wrote.
    Image<float>* scalar = nullptr;          ///< Null where the field does not have the colours' array.
    Image<std::uint32_t>* masked = nullptr;  ///< Holds 0 where nobody wrote; null where no mask is asked for.
};

/// What one rank's piece of the surface gives the picture, wherever in the image its pixels fall, as long as no other
/// piece is in front.
struct SurfacePixels {
    Extent drawn;                ///< Global pixels that may hold something: where the piece's box is seen.
    Image<std::uint32_t> depth;  ///< Bits of 1 / eye depth, by which triangles hide each other; 0: nothing here.
    Image<std::uint64_t> order;  ///< SurfaceMesh::order of the triangle seen: of equally near ones the least shows.
    GBuffer seen;                ///< All but the links.
};

/// A rank's share of a scene whose field is split into bricks.
struct BrickShare {
    const FieldPixels* mine = nullptr;  ///< For the ranks in whose rows these pixels lie.
    FieldRows into;                     ///< Where all ranks' pixels of this rank's rows go.
};

/// A rank's share of a scene whose surface is split into pieces.
struct PieceShare {
    const SurfacePixels* mine = nullptr;  ///< For the ranks in whose rows these pixels lie.
    GBuffer* into = nullptr;  ///< Background, where the nearest of all ranks' pixels of this rank's rows go.
};

/// What a rank's projection has for others, and where it wants what others have for it. Nothing where every rank holds
/// the whole scene.
using Share = std::variant<std::monostate, BrickShare, PieceShare>;

}  // namespace aeolic
