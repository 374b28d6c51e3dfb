#include "render/gl/device/fetch_rate.h"

#include <algorithm>
#include <vector>

#include "base/median.h"
#include "render/gl/device/context.h"
#include "render/gl/device/stage_timers.h"

namespace aeolic::gl {
namespace {

constexpr int kRepeats = 5;

/// Median seconds of `work` by the device's clock, the first time not counted.
template <class Work>
double secondsOf(const Work& work)
{
    std::vector<double> seconds;
    for (int i = 0; i <= kRepeats; ++i) {
        StageTimers timers;
        timers.begin(Stage::convolve);
        work();
        timers.end();
        const double ms = timers.read().convolveMs;
        if (i > 0) seconds.push_back(std::max(ms, 1e-6) * 1e-3);
    }
    return median(seconds);
}

double gatheredLanesPerS(Programs& programs, bool software)
{
    const int side = software ? 512 : 4096, gathers = software ? 16 : 256;
    const Texture texels = Texture::image(GL_R32UI, side, side);
    const Buffer sums(4, 0);
    const GLuint program = programs.compute("fetch_rate");
    glProgramUniform1i(program, 0, gathers);
    const double seconds = secondsOf([&] {
        glUseProgram(program);
        texels.bind(0);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, sums.id());
        glDispatchCompute(GLuint(side / 8), GLuint(side / 8), 1);
    });
    return 4.0 * gathers * double(side) * double(side) / seconds;
}

double copiedBytesPerS(bool software)
{
    const std::size_t bytes = std::size_t{1} << (software ? 24 : 29);
    const Buffer from(bytes, 0), to(bytes, 0);
    from.fill(0, bytes, 1);
    const double seconds = secondsOf([&] { glCopyNamedBufferSubData(from.id(), to.id(), 0, 0, GLsizeiptr(bytes)); });
    return 2.0 * double(bytes) / seconds;
}

}  // namespace

FetchRates measureFetchRates(const GpuChoice& choice)
{
    const std::shared_ptr<Context> context = acquireContext(choice, false);
    context->bind();
    const bool software = isSoftwareRenderer(context->renderer());
    const FetchRates rates{gatheredLanesPerS(context->programs(), software), copiedBytesPerS(software)};
    context->check("measuring the device");
    context->release();
    return rates;
}

}  // namespace aeolic::gl
