#include <algorithm>

#include "render/flatten.h"
#include "render/gbuffer.h"
#include "render/gl/device/dispatch.h"
#include "render/gl/lic/gl_lic_stage.h"

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

}  // namespace aeolic::gl
