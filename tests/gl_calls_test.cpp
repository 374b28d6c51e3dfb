#include <array>
#include <mutex>
#include <set>

#include "aeolic/renderer.h"
#include "gl_calls_testing.h"
#include "render_testing.h"
#include "same_bytes_testing.h"

/// What a driver is asked. A renderer that is a program forgives mistakes here that a GPU does not.
namespace aeolic {
namespace {

using namespace testkit;

/// What frames consist of, with all stages that leave anything on the device for the next.
SceneDescription everyStage(LicMethod method)
{
    SceneDescription d;
    d.surface.spec = "teapot:2000";
    d.field.spec = "abc:8,8,8";
    d.output.width = 90;
    d.output.height = 70;
    d.lic.method = method;
    d.lic.kernel = Kernel::hann;
    d.lic.steps = 20;
    d.shading.occlusion = true;
    d.run.backend = BackendChoice::gl;
    return d;
}

/// Which barriers are still to come for what shaders wrote. Each rank is a thread, and has a context of its own.
thread_local GLbitfield missing = 0;
std::mutex mutex;
std::set<std::string> early;  // Of all threads.

/// Writes down what looks at memory before a barrier stands behind the shaders that may have written it.
class BarrierWatch {
public:
    BarrierWatch()
    {
        missing = 0;
        early.clear();
        now_ = this;
    }
    ~BarrierWatch() { now_ = nullptr; }

private:
    static inline BarrierWatch* now_ = nullptr;

    static void needs(GLbitfield barrier, const char* call)
    {
        const std::lock_guard lock(mutex);
        if (missing & barrier) early.insert(call);
    }
    static constexpr GLbitfield kShaders =
        GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT;

    Replaced<decltype(glMemoryBarrier)> barrier_{glMemoryBarrier, [](GLbitfield bits) {
                                                     missing &= ~bits;
                                                     now_->barrier_.original()(bits);
                                                 }};
    Replaced<decltype(glDispatchCompute)> dispatch_{glDispatchCompute, [](GLuint x, GLuint y, GLuint z) {
                                                        needs(kShaders, "a program");
                                                        missing = GL_ALL_BARRIER_BITS;
                                                        now_->dispatch_.original()(x, y, z);
                                                    }};
    Replaced<decltype(glDispatchComputeIndirect)> indirect_{glDispatchComputeIndirect, [](GLintptr at) {
                                                                needs(kShaders | GL_COMMAND_BARRIER_BIT,
                                                                      "a program over a list");
                                                                missing = GL_ALL_BARRIER_BITS;
                                                                now_->indirect_.original()(at);
                                                            }};
    Replaced<decltype(glNamedBufferSubData)> write_{glNamedBufferSubData,
                                                    [](GLuint id, GLintptr offset, GLsizeiptr bytes, const void* data) {
                                                        needs(GL_BUFFER_UPDATE_BARRIER_BIT, "writing a buffer");
                                                        now_->write_.original()(id, offset, bytes, data);
                                                    }};
    Replaced<decltype(glCopyNamedBufferSubData)> copy_{
        glCopyNamedBufferSubData, [](GLuint from, GLuint to, GLintptr fromAt, GLintptr toAt, GLsizeiptr bytes) {
            needs(GL_BUFFER_UPDATE_BARRIER_BIT, "copying a buffer");
            now_->copy_.original()(from, to, fromAt, toAt, bytes);
        }};
    Replaced<decltype(glTextureSubImage2D)> image_{
        glTextureSubImage2D, [](GLuint id, GLint level, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                                GLenum type, const void* data) {
            needs(GL_TEXTURE_UPDATE_BARRIER_BIT, "writing a texture");
            now_->image_.original()(id, level, x, y, width, height, format, type, data);
        }};
    Replaced<decltype(glTextureSubImage3D)> layers_{
        glTextureSubImage3D, [](GLuint id, GLint level, GLint x, GLint y, GLint z, GLsizei width, GLsizei height,
                                GLsizei depth, GLenum format, GLenum type, const void* data) {
            needs(GL_TEXTURE_UPDATE_BARRIER_BIT, "writing layers");
            now_->layers_.original()(id, level, x, y, z, width, height, depth, format, type, data);
        }};
    Replaced<decltype(glGetTextureSubImage)> read_{
        glGetTextureSubImage, [](GLuint id, GLint level, GLint x, GLint y, GLint z, GLsizei width, GLsizei height,
                                 GLsizei depth, GLenum format, GLenum type, GLsizei bytes, void* to) {
            needs(GL_TEXTURE_UPDATE_BARRIER_BIT, "reading a texture");
            now_->read_.original()(id, level, x, y, z, width, height, depth, format, type, bytes, to);
        }};
    Replaced<decltype(glClearTexSubImage)> clear_{
        glClearTexSubImage, [](GLuint id, GLint level, GLint x, GLint y, GLint z, GLsizei width, GLsizei height,
                               GLsizei depth, GLenum format, GLenum type, const void* data) {
            needs(GL_TEXTURE_UPDATE_BARRIER_BIT, "clearing a texture");
            now_->clear_.original()(id, level, x, y, z, width, height, depth, format, type, data);
        }};
};

std::string listed(const std::set<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) text += word + "; ";
    return text;
}

class GlCalls : public ::testing::Test {
protected:
    void SetUp() override { skipWithout("gl"); }
};

TEST_F(GlCalls, WhatShadersWroteIsThereForWhatFollows)
{
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        Renderer renderer(everyStage(method));
        renderer.render({});  // libepoxy has found its functions.
        const BarrierWatch watch;
        for (int frame = 0; frame < 3; ++frame) renderer.render({});
        EXPECT_EQ(listed(early), "") << int(method);
    }
}

/// Rows travel between ranks, and pixels of bricks.
TEST_F(GlCalls, WhatShadersWroteIsThereForOtherRanks)
{
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical})
        for (const char* bricks : {"off", "on"}) {
            LicOptions lic = licOf(method, 40, Kernel::hann);
            Case c = makeCase("rows", 90, 300, lic, "teapot:2000", "abc:8,8,8");
            c.description.shading.occlusion = true;
            c.description.lic.maskBelow = 0.5;
            const RunOptions options = runOptions("static", "estimate", "receive", bricks);
            draw("gl", c, options, 2, 1);
            const BarrierWatch watch;
            draw("gl", c, options, 2, 3);
            EXPECT_EQ(listed(early), "") << int(method) << ", bricks " << bricks;
        }
}

/// A device whose buffers are too short for the samples of all edge pixels takes them one part after the other.
TEST_F(GlCalls, EdgesInParts)
{
    SceneDescription d = everyStage(LicMethod::hierarchical);
    d.surface.spec = "sphere:200";
    d.output.width = 200;
    d.output.height = 150;
    const Picture expected = Renderer(d).render({});
    d.shading.antialias = false;
    const Picture plain = Renderer(d).render({});
    d.shading.antialias = true;
    std::size_t changed = 0;
    for (std::size_t i = 0; i < plain.pixels.size(); i += 3) changed += plain.pixels[i] != expected.pixels[i];
    constexpr long kBytes = 16'000, kPixelBytes = 64;  // The surface still fits.
    ASSERT_GT(long(changed), kBytes / kPixelBytes) << "more than one part";
    static decltype(glGetInteger64v) real;
    real = glGetInteger64v;
    const Replaced<decltype(glGetInteger64v)> small(glGetInteger64v, [](GLenum name, GLint64* value) {
        real(name, value);
        if (name == GL_MAX_SHADER_STORAGE_BLOCK_SIZE) *value = kBytes;
    });
    EXPECT_EQ(Renderer(d).render({}).pixels, expected.pixels);
}

/// What kind of texture a sampler takes; 0 where the type is no sampler.
GLenum bindingOf(GLint type)
{
    switch (type) {
        case GL_SAMPLER_2D:
        case GL_UNSIGNED_INT_SAMPLER_2D:
            return GL_TEXTURE_BINDING_2D;
        case GL_UNSIGNED_INT_SAMPLER_2D_ARRAY:
            return GL_TEXTURE_BINDING_2D_ARRAY;
        case GL_SAMPLER_3D:
        case GL_UNSIGNED_INT_SAMPLER_3D:
            return GL_TEXTURE_BINDING_3D;
        default:
            return 0;
    }
}

std::set<std::string> unboundSamplers()
{
    std::set<std::string> unbound;
    GLint program = 0, uniforms = 0, active = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    glGetProgramiv(GLuint(program), GL_ACTIVE_UNIFORMS, &uniforms);
    for (GLint i = 0; i < uniforms; ++i) {
        std::array<char, 128> name{};
        GLint elements = 0, unit = 0, texture = 0;
        GLenum type = 0;
        glGetActiveUniform(GLuint(program), GLuint(i), GLsizei(name.size()), nullptr, &elements, &type, name.data());
        const GLenum binding = bindingOf(GLint(type));
        if (binding == 0) continue;
        glGetUniformiv(GLuint(program), glGetUniformLocation(GLuint(program), name.data()), &unit);
        glActiveTexture(GLenum(GL_TEXTURE0 + unit));
        glGetIntegerv(binding, &texture);
        if (texture == 0) unbound.insert(name.data());
    }
    glActiveTexture(GLenum(active));
    return unbound;
}

/// NVIDIA's driver complains of samplers without a texture, even where the shader does not get to them.
TEST_F(GlCalls, EverySamplerHasATexture)
{
    for (const LicMethod method : {LicMethod::none, LicMethod::direct, LicMethod::hierarchical}) {
        Renderer renderer(everyStage(method));
        renderer.render({});
        static std::set<std::string> unbound;
        static decltype(glDispatchCompute) dispatch;
        static decltype(glDispatchComputeIndirect) indirect;
        unbound.clear();
        dispatch = glDispatchCompute;
        indirect = glDispatchComputeIndirect;
        const Replaced<decltype(glDispatchCompute)> direct(glDispatchCompute, [](GLuint x, GLuint y, GLuint z) {
            unbound.merge(unboundSamplers());
            dispatch(x, y, z);
        });
        const Replaced<decltype(glDispatchComputeIndirect)> listed_(glDispatchComputeIndirect, [](GLintptr at) {
            unbound.merge(unboundSamplers());
            indirect(at);
        });
        for (GLuint unit = 0; unit < 16; ++unit) glBindTextureUnit(unit, 0);
        renderer.render({});
        EXPECT_EQ(listed(unbound), "") << int(method);
    }
}

}  // namespace
}  // namespace aeolic
