#pragma once

#include "aeolic/scene_description.h"
#include "render/cpu/lic/fine_cells.h"
#include "render/lic/lic_kernel.h"

namespace aeolic::cpu {

/// What the kernels of one convolution read and write.
struct DirectPass {
    const GBuffer& buffer;
    KernelWeights kernel;
    ContrastModel contrast;
    Integrator integrator;
    Streaks streaks;
    LicImage& out;
};

/// Local. The line integral of every pixel of `compute` by stepping its streamline both ways (`--lic direct`).
/// Reads the G-buffer as far as its traces go: at most steps * maxStepPx beyond `compute`.
/// Cost: one 128-bit load and about 70 vector operations a sample; Euler 1, RK2 2, RK4 4 samples a step.
void convolveDirect(const GBuffer& buffer, const FlowCells& flow, const LicOptions& lic, const Extent& compute,
                    LicImage& out);
void convolveDirect(const GBuffer& buffer, const FineCells& flow, const LicOptions& lic, const Extent& compute,
                    LicImage& out);

}  // namespace aeolic::cpu
