#include "render/gl/lic/gl_lic_stage.h"

#include "render/gbuffer.h"
#include "render/gl/device/dispatch.h"
#include "render/lic/lic_kernel.h"

namespace aeolic::gl {

void bindTraces(const ConvolvePass& pass, GLuint program)
{
    pass.images.flow.bind(0);
    pass.images.links.bind(1);
    pass.images.openFlow.bind(2);
    pass.images.wholeFlow.bind(3);
    setFloats(program, 1, pass.flowUnitPx);
}

void setContrast(GLuint program, const LicOptions& lic)
{
    const ContrastModel model = makeContrastModel(lic);
    setFloats(program, 2, model.zeroLength, model.perLength, flow_texel::kNoiseUnit * model.inverseMeanWeight);
    setFloats(program, 5, model.phaseCosine, model.phaseSine, model.perStep);
}

void makeFlowCells(const ConvolvePass& pass, float sharpness, int y0, int y1)
{
    const GLuint program = pass.programs.compute("flow_cells");
    setFloats(program, 1, sharpness, sharpness > 0 ? 1 / kSharpenedNoiseUnit : 1.0f);
    pass.images.flow.bind(0);
    pass.images.links.bind(1);
    pass.images.openFlow.bindImage(0);
    pass.images.wholeFlow.bindImage(1);
    pass.near.run(program, y0, y1);
}

}  // namespace aeolic::gl
