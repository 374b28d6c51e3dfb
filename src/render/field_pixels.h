#pragma once

#include <cstdint>

#include "base/image.h"

namespace aeolic {

/// What one rank's brick of the field gives the picture, wherever in the image its pixels fall.
struct FieldPixels {
    Extent drawn;               ///< Global pixels that may hold something: where the brick's box is seen.
    Image<std::uint32_t> flow;  ///< flow_texel; 0 where the pixel's cell is another rank's, or nothing flows.
    Image<float> scalar;        ///< NaN there. Only sized where the scalar comes from the field.
};

/// The pixels of the G-buffer that come from the field, in this process's memory, for others to fill in.
struct FieldRows {
    Image<std::uint32_t>* flow;  ///< flow_texel; holds 0 where nobody wrote.
    Image<float>* scalar;        ///< Null where what is coloured by is not in the field.
};

}  // namespace aeolic
