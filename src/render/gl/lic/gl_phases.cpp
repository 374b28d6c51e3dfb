#include "render/gl/device/dispatch.h"
#include "render/gl/lic/gl_lic_stage.h"

namespace aeolic::gl {

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
