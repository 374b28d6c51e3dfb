#include "render/gl/lic/gl_lic_stage.h"

#include <algorithm>

#include "render/flatten.h"
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

void Flatten::run(Programs& programs, const FrameImages& images, const LicOptions& lic, int height,
                  const Extent& compute, RowExchange* beside, int more, StageTimers& timers)
{
    const int reach = flatten::reachPx(lic);
    words_.hold(compute, reach + more, height);
    const Extent& held = words_.held();
    const auto bindFlow = [&] {
        images.visible.bind(0);
        images.flow.bind(1);
    };
    timers.begin(Stage::convolve);
    const GLuint words = programs.compute("flatten_words");
    setExtent(words, 1, compute);
    bindFlow();
    images.lic.bind(2);
    bindStorage(0, words_.words());
    dispatchOver(words, held);
    timers.end();
    if (beside) words_.receive(*beside);

    timers.begin(Stage::convolve);
    sums_.reserve(std::size_t(std::max(held.width(), 0)) * std::size_t(std::max(held.height(), 0)) * 2 *
                  sizeof(GLuint));
    const GLuint rows = programs.compute("flatten_rows");
    setInts(rows, 1, reach);
    bindStorage(0, words_.words());
    bindStorage(1, sums_.get());
    dispatchOver(rows, held);

    const GLuint flat = programs.compute("flatten");
    setInts(flat, 1, reach);
    setExtent(flat, 2, held);
    bindFlow();
    images.lic.bindImage(0);
    dispatchOver(flat, compute.empty() ? compute : withNeighbours(compute, images.valid, more));
    timers.end();
}

void GlPhases::keep(int which, const FrameImages& images)
{
    const Texture& values = images.lic;
    Texture& kept = kept_[std::size_t(which)];
    if (kept.width() != values.width() || kept.height() != values.height())
        kept = Texture::image(values.format(), values.width(), values.height());
    values.copyTo(kept);
}

void GlPhases::mix(Programs& programs, const FrameImages& images, const phase_mix::Mixture& mixture,
                   StageTimers& timers) const
{
    timers.begin(Stage::convolve);
    const auto* weights = std::get_if<phase_mix::Weights>(&mixture);
    const auto* turned = std::get_if<phase_mix::Turned>(&mixture);
    const GLuint program =
        weights ? programs.compute("mix_phases") : programs.compute("mix_comets", {{"MEAN", turned ? 0 : 1}});
    if (weights) setFloats(program, 1, (*weights)[0], (*weights)[1], (*weights)[2]);
    if (turned) setFloats(program, 1, turned->cosine, turned->sine);
    for (GLuint i = 0; i < GLuint(kept_.size()); ++i)
        if (kept_[i].id() != 0) kept_[i].bind(i);
    if (!weights) images.flow.bind(GLuint(kept_.size()));
    images.lic.bindImage(0);
    dispatchOver(program, {0, 0, images.lic.width(), images.valid.height()});
    timers.end();
}

}  // namespace aeolic::gl
