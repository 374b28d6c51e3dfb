#include "render/gl/device/draw_visibility.h"

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

void drawVisibility(Programs& programs, const GpuScene& scene, const View& view, GLuint target, const Extent& area)
{
    const GLuint program = programs.drawing("visibility");
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
    glViewport(0, 0, view.camera.width, view.camera.height);
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_SCISSOR_TEST);
    glScissor(area.x0, area.y0, area.width(), area.height());
    glEnable(GL_DEPTH_TEST);
    const GLuint background[4] = {};
    const float farthest = view.farInvDepth * float(view.nearDepth);  // Nothing beyond the far plane is nearer.
    glClearNamedFramebufferuiv(target, GL_COLOR, 0, background);
    glClearNamedFramebufferfv(target, GL_DEPTH, 0, &farthest);
    glUseProgram(program);
    glDepthFunc(GL_GREATER);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0f / 128, 8);  // A pixel's change of depth is 256 sub-pixels'.
    scene.draw();
    glDisable(GL_POLYGON_OFFSET_FILL);
    if (!view.frontFacesOnly) {
        glCullFace(GL_FRONT);
        scene.draw();
    }
    glDisable(GL_CULL_FACE);
    finishDrawing();
}

}  // namespace aeolic::gl
