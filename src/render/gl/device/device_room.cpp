#include <epoxy/gl.h>

#include <array>

#include "render/gl/device/context.h"
#include "render/gl/device/scene_limits.h"
#include "render/gl/gl_backend.h"

namespace aeolic::gl {

std::string deviceIdentity(const DeviceRequest& request)
{
    const std::shared_ptr<Context> context = acquireContext(request);
    context->bind();
    std::string identity;
    if (epoxy_has_gl_extension("GL_EXT_memory_object")) {
        std::array<GLubyte, GL_UUID_SIZE_EXT> uuid{};
        glGetUnsignedBytei_vEXT(GL_DEVICE_UUID_EXT, 0, uuid.data());
        identity.assign(uuid.begin(), uuid.end());
    }
    context->check("asking for its identity");
    context->release();
    return identity;
}

void requireRoom(const std::vector<SceneSizes>& steps, const DeviceRequest& request, int ranks)
{
    const std::shared_ptr<Context> context = acquireContext(request);
    context->bind();
    DeviceLimits limits = deviceLimits();
    limits.ranks = ranks;
    context->check("asking for its limits");
    context->release();
    for (const SceneSizes& sizes : steps) requireLimits(sizes, limits, true);
}

}  // namespace aeolic::gl
