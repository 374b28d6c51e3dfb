#include "render/along_flow.h"

#include <algorithm>

#include "render/gl/lic/lic_stage.h"
#include "render/limits.h"

namespace aeolic::gl {
namespace {

constexpr int kWordBytes = 4;

}  // namespace

std::size_t AlongFlow::placeOf(const FrameImages& images, int y) const
{
    return std::size_t(y - around_.y0) * std::size_t(images.valid.width()) * kWordBytes;
}

void AlongFlow::sendWords(const FrameImages& images, const Extent& compute)
{
    const int width = images.valid.width();
    around_ = withNeighbours(compute, images.valid, limits::kAlongRows);
    memory_.reserve(placeOf(images, around_.y1) + kWordBytes);
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, memory_.id());
    const auto take = [&](int y0, int y1) {
        if (y0 >= y1) return;
        glGetTextureSubImage(images.words.id(), 0, 0, y0 - images.valid.y0, 0, width, y1 - y0, 1, GL_RED_INTEGER,
                             GL_UNSIGNED_INT, width * (y1 - y0) * kWordBytes, offsetPointer(placeOf(images, y0)));
    };
    const int upperEnd = std::min(compute.y0 + limits::kAlongRows, compute.y1);
    take(compute.y0, upperEnd);
    take(std::max(compute.y1 - limits::kAlongRows, upperEnd), compute.y1);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
    copied_.set();
}

void AlongFlow::receiveWords(const FrameImages& images, const Extent& compute, RowExchange& beside, StageTimers& timers)
{
    const int width = images.valid.width();
    timers.end();
    copied_.wait();
    beside.receive({memory_.data(), std::ptrdiff_t(width) * kWordBytes, kWordBytes, around_}, limits::kAlongRows);
    timers.begin(Stage::convolve);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, memory_.id());
    const auto put = [&](int y0, int y1) {
        if (y0 >= y1) return;
        glTextureSubImage2D(images.words.id(), 0, 0, y0 - images.valid.y0, width, y1 - y0, GL_RED_INTEGER,
                            GL_UNSIGNED_INT, offsetPointer(placeOf(images, y0)));
    };
    put(around_.y0, compute.y0);
    put(compute.y1, around_.y1);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

void AlongFlow::run(const ConvolvePass& pass, const LicOptions& lic, const Extent& compute, RowExchange* beside,
                    StageTimers& timers)
{
    const FrameImages& images = pass.images;
    const int y0 = compute.y0 - images.valid.y0, y1 = compute.y1 - images.valid.y0;
    timers.begin(Stage::convolve);
    const GLuint pack = pass.programs.compute("along_words");
    images.lic.bind(0);
    images.links.bind(1);
    images.words.bindImage(0);
    pass.near.run(pack, y0, y1);
    if (beside) sendWords(images, compute);

    const GLuint program = pass.programs.compute("along_flow");
    glProgramUniform1f(program, 1, along_flow::gain(lic));
    images.flow.bind(0);
    images.words.bind(1);
    images.lic.bindImage(0);
    // What reads this rank's rows alone is computed while the others' travel.
    const int rows = beside ? limits::kAlongRows : 0, upperEnd = std::min(y0 + rows, y1),
              lowerBegin = std::max(y1 - rows, upperEnd);
    pass.near.run(program, upperEnd, lowerBegin);
    if (beside) {
        receiveWords(images, compute, *beside, timers);
        pass.near.run(program, y0, upperEnd);
        pass.near.run(program, lowerBegin, y1);
    }
    timers.end();
}

}  // namespace aeolic::gl
