#include "render/gl/project/gl_visibility.h"

#include "render/gl/device/dispatch.h"
#include "render/gl/device/gl_blocks.h"

namespace aeolic::gl {

void drawVisibility(Programs& programs, const GpuScene& scene, const View& view, GLuint target, const Extent& area)
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
    glViewport(0, 0, view.camera.width, view.camera.height);
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_SCISSOR_TEST);
    glScissor(area.x0, area.y0, area.width(), area.height());
    glEnable(GL_DEPTH_TEST);
    const GLuint background[4] = {};
    // Nothing beyond the far plane is nearer than what the depth is cleared to.
    const float farthest = view.farInvDepth * float(view.nearDepth);
    glClearNamedFramebufferuiv(target, GL_COLOR, 0, background);
    glClearNamedFramebufferfv(target, GL_DEPTH, 0, &farthest);
    glUseProgram(programs.drawing("visibility"));
    glDepthFunc(GL_GREATER);
    // Front faces count as nearer by what corners on whole sub-pixels and rounding make planes differ (frontBias()): a
    // pixel's change of depth is 256 sub-pixels'.
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.0f / 128, 8);
    scene.draw();
    glDisable(GL_POLYGON_OFFSET_FILL);
    if (!view.frontFacesOnly) {
        glCullFace(GL_FRONT);
        scene.draw();
    }
    glDisable(GL_CULL_FACE);
    finishDrawing();
}

std::vector<std::int64_t> CoverageCount::count(Programs& programs, const GpuScene& scene, const View& view)
{
    const int width = view.camera.width, height = view.camera.height;
    if (!ids_ || ids_.width() != width || ids_.height() != height) {
        target_ = {};
        ids_ = Texture::image(GL_R32UI, width, height);
        depth_ = Texture::image(GL_DEPTH_COMPONENT32F, width, height);
        target_ = makeTarget(ids_, depth_);
    }
    const ViewBlock block = makeViewBlock(view, 0, height);
    if (block_.bytes() == 0) block_ = Buffer(sizeof block, GL_DYNAMIC_STORAGE_BIT);
    block_.write(0, sizeof block, &block);
    glBindBufferBase(GL_UNIFORM_BUFFER, kViewBinding, block_.id());
    drawVisibility(programs, scene, view, target_, {0, 0, width, height});
    counts_.start(programs, ids_, 0, height);
    counts_.wait();
    std::vector<std::int64_t> covered;
    covered.reserve(std::size_t(height));
    for (int y = 0; y < height; ++y) covered.push_back(counts_.get(y, y + 1));
    return covered;
}

}  // namespace aeolic::gl
