#include "render/gl/edges/edges.h"

#include <bit>
#include <cstdint>

#include "render/antialias.h"
#include "render/gl/project/visibility.h"
#include "render/limits.h"

namespace aeolic::gl {
namespace {

float slackPerDepth(const View& view)
{
    return 0.5f * limits::kSlackFootprints / view.focalPx;
}

}  // namespace

void Edges::resize(const Pass& pass, const Extent& compute)
{
    const int width = pass.view.camera.width, height = pass.view.camera.height, rows = pass.images.surface.height();
    if (!edges_ || edges_.width() != width || edges_.height() != rows) {
        edges_ = {};
        edges_ = Texture::image(GL_R8UI, width, rows);
    }
    if (!seen_ || seen_.width() != width || seen_.height() != height) {
        target_ = {};
        seen_ = {};
        depth_ = {};
        seen_ = Texture::image(GL_R32UI, width, height);
        depth_ = Texture::image(GL_DEPTH_COMPONENT32F, width, height);
        target_ = makeTarget(seen_, depth_);
    }
    if (!none_) {
        GLuint id = 0;
        glCreateVertexArrays(1, &id);
        none_ = VertexArray(id);
    }
    sums_.reserve(std::size_t(compute.width()) * std::size_t(compute.height()) * 4 * sizeof(GLuint));
}

void Edges::findEdges(const Pass& pass, const Extent& compute) const
{
    const GLuint program = pass.programs.compute("edge_mask");
    glProgramUniform1f(program, 1, slackPerDepth(pass.view));
    glProgramUniform1i(program, 2, pass.palette.lighting);
    pass.images.visible.bind(0);
    pass.images.surface.bind(1);
    edges_.bindImage(0);
    dispatchOver(program, compute);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void Edges::drawSample(const Pass& pass, const Extent& compute, int sample)
{
    const float right = float(antialias::kRight[sample]) / float(antialias::kParts),
                down = float(antialias::kDown[sample]) / float(antialias::kParts);
    const GLuint clear = pass.programs.drawing("edge_depth");
    glProgramUniform1f(clear, 1, pass.view.farInvDepth * float(pass.view.nearDepth));
    beginVisibility(pass.view, target_, compute);
    glDepthFunc(GL_ALWAYS);
    glUseProgram(clear);
    edges_.bind(0);
    glBindVertexArray(none_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    drawTriangles(pass.programs, pass.scene, pass.view,
                  {-2 * right / float(pass.view.camera.width), 2 * down / float(pass.view.camera.height)});
}

void Edges::run(const Pass& pass, const Extent& compute, const Extent& shown, const Buffer& pixels, const Buffer& open)
{
    if (compute.empty()) return;
    resize(pass, compute);
    findEdges(pass, compute);
    const GLuint add = pass.programs.compute("edge_samples"), mix = pass.programs.compute("edge_mix");
    setExtent(add, 1, shown);
    setExtent(mix, 1, shown);
    glProgramUniform1ui(mix, 2, std::bit_cast<std::uint32_t>(pass.palette.background));
    glProgramUniform1f(add, 3, slackPerDepth(pass.view));
    for (int s = 0; s < antialias::kSamples; ++s) {
        drawSample(pass, compute, s);
        glProgramUniform2f(add, 2, float(antialias::kRight[s]) / float(antialias::kParts),
                           float(antialias::kDown[s]) / float(antialias::kParts));
        glProgramUniform1i(add, 4, s == 0);
        pass.scene.bindMesh();
        edges_.bind(0);
        seen_.bind(1);
        pass.images.visible.bind(2);
        pass.images.surface.bind(3);
        if (pass.images.scalar) pass.images.scalar.bind(4);
        if (pass.images.colors) pass.images.colors.bind(5);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, pixels.id());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 6, open.id());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 5, sums_.get().id());
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        dispatchOver(add, compute);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    dispatchOver(mix, compute);
}

}  // namespace aeolic::gl
