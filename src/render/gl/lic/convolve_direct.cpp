#include "render/gbuffer.h"
#include "render/gl/lic/convolve.h"
#include "render/gl/lic/lic_uniforms.h"

namespace aeolic::gl {

void bindTraces(const ConvolvePass& pass, GLuint program)
{
    pass.images.flow.bind(0);
    pass.images.links.bind(1);
    pass.images.openFlow.bind(2);
    pass.images.wholeFlow.bind(3);
    glProgramUniform1f(program, 1, pass.flowUnitPx);
}

void setContrast(GLuint program, const LicOptions& lic)
{
    const ContrastModel model = makeContrastModel(lic);
    glProgramUniform3f(program, 2, model.zeroLength, model.perLength, flow_texel::kNoiseUnit * model.inverseMeanWeight);
}

void makeTraceTexels(const ConvolvePass& pass, float sharpness, int y0, int y1)
{
    const GLuint program = pass.programs.compute("trace_texels");
    glProgramUniform2f(program, 1, sharpness, sharpness > 0 ? 1 / kSharpenedNoiseUnit : 1.0f);
    pass.images.flow.bind(0);
    pass.images.links.bind(1);
    pass.images.openFlow.bindImage(0);
    pass.images.wholeFlow.bindImage(1);
    pass.near.run(program, y0, y1);
}

void DirectConvolution::run(const ConvolvePass& pass, const LicOptions& lic, int y0, int y1)
{
    const bool hann = lic.kernel == Kernel::hann;
    const GLuint program =
        pass.programs.compute("convolve_direct", {{"INTEGRATOR", int(lic.integrator)}, {"HANN", hann}});
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
    pass.images.lic.bindImage(0);
    pass.near.run(program, y0, y1);
}

}  // namespace aeolic::gl
