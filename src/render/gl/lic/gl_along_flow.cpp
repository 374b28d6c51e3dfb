#include "render/lic/along_flow.h"

#include <algorithm>

#include "render/gl/device/dispatch.h"
#include "render/gl/lic/gl_lic_stage.h"
#include "render/limits.h"

namespace aeolic::gl {
namespace {

constexpr int kWordBytes = 4;

}  // namespace

std::size_t AlongFlow::placeOf(const FrameImages& images, int y) const
{
    return std::size_t(y - around_.y0) * std::size_t(images.valid.width()) * kWordBytes;
}

void AlongFlow::send(const FrameImages& images, const Texture& from, const Extent& compute, int rows)
{
    around_ = withNeighbours(compute, images.valid, rows);
    memory_.reserve(placeOf(images, around_.y1) + kWordBytes);
    const PixelsInto memory(memory_);
    const auto take = [&](int y0, int y1) {
        from.readRows(y0 - images.valid.y0, y1 - images.valid.y0, 0, offsetPointer(placeOf(images, y0)));
    };
    const int upperEnd = std::min(compute.y0 + rows, compute.y1);
    take(compute.y0, upperEnd);
    take(std::max(compute.y1 - rows, upperEnd), compute.y1);
    copied_.set();
}

void AlongFlow::receive(const FrameImages& images, const Texture& into, const Extent& compute, RowExchange& beside,
                        int rows, StageTimers& timers)
{
    const int width = images.valid.width();
    timers.end();
    copied_.wait();
    beside.receive({memory_.data(), std::ptrdiff_t(width) * kWordBytes, kWordBytes, around_}, rows);
    timers.begin(Stage::convolve);
    const PixelsFrom memory(memory_);
    const auto put = [&](int y0, int y1) {
        into.writeRows(y0 - images.valid.y0, y1 - images.valid.y0, 0, offsetPointer(placeOf(images, y0)));
    };
    put(around_.y0, compute.y0);
    put(compute.y1, around_.y1);
}

void AlongFlow::receiveValues(const ConvolvePass& pass, const Extent& compute, RowExchange& beside, int rows,
                              StageTimers& timers)
{
    timers.begin(Stage::convolve);
    send(pass.images, pass.images.lic, compute, rows);
    receive(pass.images, pass.images.lic, compute, beside, rows, timers);
    timers.end();
}

void AlongFlow::run(const ConvolvePass& pass, const LicOptions& lic, const Extent& compute, RowExchange* beside,
                    int more, StageTimers& timers)
{
    const FrameImages& images = pass.images;
    const int y0 = compute.y0 - images.valid.y0, y1 = compute.y1 - images.valid.y0;
    timers.begin(Stage::convolve);
    const GLuint pack = pass.programs.compute("along_words");
    images.lic.bind(0);
    images.links.bind(1);
    images.words.bindImage(0);
    pass.near.run(pack, y0, y1);
    if (beside) send(images, images.words, compute, limits::kAlongRows + more);

    const GLuint program = pass.programs.compute("along_flow");
    setFloats(program, 1, along_flow::gain(lic));
    images.flow.bind(0);
    images.words.bind(1);
    images.lic.bindImage(0);
    // What reads this rank's rows alone is computed while the others' travel.
    const int rows = beside ? limits::kAlongRows : 0, upperEnd = std::min(y0 + rows, y1),
              lowerBegin = std::max(y1 - rows, upperEnd);
    pass.near.run(program, upperEnd, lowerBegin);
    if (beside) {
        receive(images, images.words, compute, *beside, limits::kAlongRows + more, timers);
        pass.near.run(program, std::max(y0 - more, 0), upperEnd);
        pass.near.run(program, lowerBegin, std::min(y1 + more, images.valid.height()));
    }
    timers.end();
}

}  // namespace aeolic::gl
