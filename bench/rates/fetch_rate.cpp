#include "rates/fetch_rate.h"

#include <algorithm>
#include <vector>

#include "base/median.h"
#include "render/gl/device/context.h"
#include "render/gl/device/device_errors.h"
#include "render/gl/device/stage_timers.h"

namespace aeolic::gl {
namespace {

constexpr int kRepeats = 5;

// Nothing but gathers of four texels, each a step beside the last, as a trace's are.
constexpr const char* kGathers = R"(#version 450 core
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D texels;  // All zero.
layout(std430, binding = 0) buffer Sums { uint sums[]; };
layout(location = 0) uniform int gathers;

void main()
{
    vec2 scale = 1.0 / vec2(textureSize(texels, 0)), at = (vec2(gl_GlobalInvocationID.xy) + 1.0) * scale;
    uint sum = 0u;
    for (int i = 0; i < gathers; ++i) {
        uvec4 four = textureGather(texels, at);
        sum += (four.x ^ four.y) + (four.z ^ four.w);
        at += vec2(0.8, 0.6) * scale * (1.0 + uintBitsToFloat(four.x));  // Where to go next is known only now.
    }
    if (sum != 0u) sums[0] = sum;
}
)";

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

double gatheredLanesPerS(bool software)
{
    const int side = software ? 512 : 4096, gathers = software ? 16 : 256;
    const Texture texels = Texture::image(GL_R32UI, side, side);
    const Buffer sums(4, 0);
    const Program program(glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &kGathers));
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) deviceFailed("its driver does not accept the shader that measures gathers");
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
    const GLuint one = 1;
    glClearNamedBufferData(from.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &one);
    const double seconds = secondsOf([&] { glCopyNamedBufferSubData(from.id(), to.id(), 0, 0, GLsizeiptr(bytes)); });
    return 2.0 * double(bytes) / seconds;
}

}  // namespace

FetchRates measureFetchRates(const GpuChoice& choice)
{
    const std::shared_ptr<Context> context = acquireContext({choice, false});
    context->bind();
    const bool software = isSoftwareRenderer(context->renderer());
    const FetchRates rates{gatheredLanesPerS(software), copiedBytesPerS(software)};
    context->check("measuring the device");
    context->release();
    return rates;
}

}  // namespace aeolic::gl
