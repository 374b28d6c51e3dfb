#pragma once

#include "aeolic/scene_description.h"
#include "base/image.h"
#include "render/cpu/lic/flow_cells.h"

namespace aeolic::cpu {

/// The LIC stage's result: mean noise along the streamline times the contrast gain: about unit variance, zero mean.
/// 0 where there is no flow.
using LicImage = Image<float>;

/// Local. The line integral of every pixel of `compute` by stepping its streamline both ways (`--lic direct`).
/// Reads the G-buffer as far as its traces go: at most steps * maxStepPx beyond `compute`.
/// Cost: one 128-bit load and about 70 vector operations a sample; Euler 1, RK2 2, RK4 4 samples a step.
void convolveDirect(const GBuffer& buffer, const FlowCells& flow, const LicOptions& lic, const Extent& compute,
                    LicImage& out);

}  // namespace aeolic::cpu
