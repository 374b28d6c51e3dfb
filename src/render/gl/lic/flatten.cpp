#include "render/gl/lic/flatten.h"

#include <algorithm>

#include "render/flatten.h"
#include "render/gbuffer.h"

namespace aeolic::gl {

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
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, words_.words().id());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    dispatchOver(words, held);
    timers.end();
    if (beside) words_.receive(*beside);

    timers.begin(Stage::convolve);
    sums_.reserve(std::size_t(std::max(held.width(), 0)) * std::size_t(std::max(held.height(), 0)) * 2 *
                  sizeof(GLuint));
    const GLuint rows = programs.compute("flatten_rows");
    glProgramUniform1i(rows, 1, reach);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, words_.words().id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, sums_.get().id());
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    dispatchOver(rows, held);

    const GLuint flat = programs.compute("flatten");
    glProgramUniform1i(flat, 1, reach);
    setExtent(flat, 2, held);
    bindFlow();
    images.lic.bindImage(0);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    dispatchOver(flat, compute.empty() ? compute : withNeighbours(compute, images.valid, more));
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    timers.end();
}

}  // namespace aeolic::gl
