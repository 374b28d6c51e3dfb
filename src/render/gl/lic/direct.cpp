#include "render/gl/lic/lic_stage.h"
#include "render/lic/lic_kernel.h"

namespace aeolic::gl {

void DirectConvolution::run(const ConvolvePass& pass, const LicOptions& lic, int y0, int y1)
{
    const bool hann = lic.kernel == Kernel::hann;
    const GLuint program = pass.programs.compute("direct", {{"INTEGRATOR", int(lic.integrator)}, {"HANN", hann}});
    if (hann) {
        const KernelWeights kernel = makeKernelWeights(lic);
        const std::size_t bytes = kernel.forward.size() * sizeof(float);
        const Buffer& weights = weights_.reserve(2 * bytes);
        weights.write(0, bytes, kernel.forward.data());
        weights.write(bytes, bytes, kernel.backward.data());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, weights.id());
    }
    bindTraces(pass, program);
    setContrast(program, lic);
    glProgramUniform1i(program, 3, lic.steps);
    glProgramUniform1i(program, 4, lic.streaks == Streaks::even);
    pass.images.lic.bindImage(0);
    pass.near.run(program, y0, y1);
}

}  // namespace aeolic::gl
