#pragma once

#include "base/image.h"
#include "render/gbuffer.h"
#include "render/guard_exchange.h"
#include "render/view.h"

namespace aeolic::cpu {

/// Ambient occlusion (render/occlusion.h). Memory is kept between frames.
class OcclusionStage {
public:
    /// Finds the open share in the rows of `compute` and `more` rows on each side. The G-buffer is right in `compute`.
    /// Collective with `beside`, which brings other ranks' depths; Local without. Cost: 50 ns a covered pixel and core,
    /// and a copy of the depths.
    void run(const GBuffer& buffer, const View& view, const Extent& compute, RowExchange* beside, int more);

    /// What gets of the light to the surface in those rows: 0 to 1.
    const Image<float>& open() const { return open_; }

private:
    void copyDepths(const GBuffer& buffer, const Extent& compute);
    void findHidden(const GBuffer& buffer, const View& view, const Extent& compute, int radius);

    Image<float> depths_;  // Zeros beside the surface and around the picture.
    Image<float> hidden_;  // What a pixel's own taps say, where there is surface.
    Image<float> open_;
};

}  // namespace aeolic::cpu
