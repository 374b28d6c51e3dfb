#include "render/gl/device/raster.h"

#include <stdexcept>

#include "render/gl/device/dispatch.h"

namespace aeolic::gl {

Framebuffer makeTarget(const Texture& ids, const Texture& depth)
{
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    Framebuffer target(id);
    glNamedFramebufferTexture(id, GL_COLOR_ATTACHMENT0, ids.id(), 0);
    glNamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, depth.id(), 0);
    if (glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("gl: the driver draws no 32-bit numbers with 32-bit depth");
    return target;
}

void rasterize(const GpuScene& scene, const RasterPass& pass)
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, pass.target);
    glViewport(0, 0, pass.width, pass.height);
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_SCISSOR_TEST);
    glScissor(pass.area.x0, pass.area.y0, pass.area.width(), pass.area.height());
    glEnable(GL_DEPTH_TEST);
    const GLuint background[4] = {};
    glClearNamedFramebufferuiv(pass.target, GL_COLOR, 0, background);
    glClearNamedFramebufferfv(pass.target, GL_DEPTH, 0, &pass.farthest);
    glUseProgram(pass.program);
    glDepthFunc(GL_GREATER);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0f / 128, 8);  // A pixel's change of depth is 256 sub-pixels'.
    scene.draw();
    glDisable(GL_POLYGON_OFFSET_FILL);
    if (!pass.frontFacesOnly) {
        glCullFace(GL_FRONT);
        scene.draw();
    }
    glDisable(GL_CULL_FACE);
    finishDrawing();
}

}  // namespace aeolic::gl
