#pragma once

#include <cstdint>

#include "render/cpu/lic/fine_cells.h"
#include "render/gbuffer.h"
#include "render/lic/lic_kernel.h"

namespace aeolic::cpu {

/// Local. The words (along_flow.h) of `values` over `compute`; zeros beside it and beside the surface in its rows,
/// which may go to other ranks.
void packValues(const GBuffer& buffer, const LicImage& values, const Extent& compute, Image<std::uint32_t>& words);

/// Local. The second convolution (along_flow.h) over the rows of `compute`. `words` holds limits::kAlongRows more on
/// either side, as far as the picture goes. Cost: six gathers and about 100 vector operations for as many pixels as a
/// vector has. `fine`: where the flow is kept in more bits; null: it is not.
void smoothAlongFlow(const GBuffer& buffer, const FineFlow* fine, const Image<std::uint32_t>& words, float gain,
                     const Extent& compute, LicImage& out);

}  // namespace aeolic::cpu
