#pragma once

#include <cstdint>

#include "aeolic/scene_description.h"
#include "base/image.h"
#include "render/gbuffer.h"
#include "render/guard_exchange.h"
#include "render/lic/lic_kernel.h"

namespace aeolic::cpu {

/// The last step of even streaks (render/flatten.h). Memory is kept between frames.
class FlattenStage {
public:
    /// `values` are right in `compute` and `more` rows on each side, as are the flow of `buffer`, and stay so.
    /// Collective with `beside`; Local without. Cost: 2 ns a pixel and core.
    void run(const GBuffer& buffer, const LicOptions& lic, const Extent& compute, RowExchange* beside, int more,
             LicImage& values);

private:
    Image<std::uint16_t> words_;  // Zeros beside the flow and around the picture.
};

}  // namespace aeolic::cpu
