#include "render/gl/device/dispatch.h"
#include "render/gl/lic/gl_lic_stage.h"
#include "render/lic/lic_kernel.h"

namespace aeolic::gl {

void DirectConvolution::run(const ConvolvePass& pass, const LicOptions& lic, int y0, int y1)
{
    const KernelModel kernel = makeKernelModel(lic);
    const GLuint program =
        pass.programs.compute("direct", {{"INTEGRATOR", int(lic.integrator)}, {"WEIGHTED", kernel.weighted()}});
    if (kernel.weighted()) {
        const KernelWeights sampled = makeKernelWeights(kernel);
        const std::size_t bytes = sampled.forward.size() * sizeof(float);
        const Buffer& weights = weights_.reserve(2 * bytes);
        weights.write(0, bytes, sampled.forward.data());
        weights.write(bytes, bytes, sampled.backward.data());
        bindStorage(0, weights);
    }
    bindTraces(pass, program);
    setContrast(program, lic);
    setInts(program, 3, lic.steps);
    setInts(program, 4, lic.streaks == Streaks::even);
    pass.images.lic.bindImage(0);
    pass.near.run(program, y0, y1);
}

}  // namespace aeolic::gl
