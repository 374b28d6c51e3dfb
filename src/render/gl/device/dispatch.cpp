#include "render/gl/device/dispatch.h"

namespace aeolic::gl {
namespace {

void waitForShaders()
{
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_UNIFORM_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT);
}

}  // namespace

void setExtent(GLuint program, GLint location, const Extent& area)
{
    glProgramUniform4i(program, location, area.x0, area.y0, area.x1, area.y1);
}

void dispatch(GLuint program, GLuint groupsX, GLuint groupsY, GLuint groupsZ)
{
    glUseProgram(program);
    glDispatchCompute(groupsX, groupsY, groupsZ);
    waitForShaders();
}

void dispatchIndirect(GLuint program, const Buffer& groups, std::size_t offset)
{
    glUseProgram(program);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups.id());
    glDispatchComputeIndirect(GLintptr(offset));
    waitForShaders();
}

void dispatchOver(GLuint program, const Extent& area, int groupWidth)
{
    constexpr int kGroupHeight = 8;
    if (area.empty()) return;
    setExtent(program, 0, area);
    dispatch(program, GLuint((area.width() + groupWidth - 1) / groupWidth),
             GLuint((area.height() + kGroupHeight - 1) / kGroupHeight));
}

void finishDrawing()
{
    waitForShaders();
}

void startWork()
{
    glFlush();
}

}  // namespace aeolic::gl
