#include "render/gl/device/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdlib>
#include <map>
#include <stdexcept>
#include <tuple>

#include "aeolic/error.h"
#include "render/gl/device/device_errors.h"
#include "render/gl/gl_backend.h"

namespace aeolic::gl {
namespace {

bool wantsMessages()
{
#ifndef NDEBUG
    return true;
#else
    return std::getenv("AEOLIC_GL_DEBUG") != nullptr;
#endif
}

const Device& chosen(const DeviceRequest& request)
{
    const auto& [choice, realOnly] = request;
    const std::vector<Device>& all = devices(!realOnly);
    if (choice.device < 0) {
        // Ranks share the real devices; software only where there is nothing else.
        std::size_t real = 0;
        while (real < all.size() && !all[real].software) ++real;
        return all[std::size_t(choice.rankOnHost) % (real > 0 ? real : all.size())];
    }
    if (std::size_t(choice.device) >= all.size())
        throw InputError("--device", std::to_string(choice.device),
                         all.size() == 1 ? "0: EGL opens one device here"
                                         : "0 to " + std::to_string(all.size() - 1) + ": EGL opens " +
                                               std::to_string(all.size()) + " devices here");
    return all[std::size_t(choice.device)];
}

}  // namespace

bool isFault(GLenum type, GLenum severity)
{
    switch (type) {
        case GL_DEBUG_TYPE_ERROR:
        case GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR:
            return true;
        case GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR:
        case GL_DEBUG_TYPE_PORTABILITY:
        case GL_DEBUG_TYPE_OTHER:
            return severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM;
        default:
            return false;
    }
}

Context::Context(const DeviceRequest& request)
{
    create(chosen(request));
    if (request.realOnly && isSoftwareRenderer(renderer_)) {
        const std::string found = "gl, but its device is a program: " + renderer_;
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        throw NoDevice("--backend", found, "a GPU");
    }
    errorsAreOf(&renderer_);
    listen();
}

void Context::create(const Device& device)
{
    display_ = device.display;
    eglBindAPI(EGL_OPENGL_API);
    const std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION,       4,
                                         EGL_CONTEXT_MINOR_VERSION,       5,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_CONTEXT_OPENGL_DEBUG,        wantsMessages() ? EGL_TRUE : EGL_FALSE};
    const auto make = [&](std::initializer_list<EGLint> more) {
        std::vector<EGLint> all = attributes;
        all.insert(all.end(), more);
        all.push_back(EGL_NONE);
        return eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, all.data());
    };
    context_ = make({EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
    if (context_ == EGL_NO_CONTEXT) context_ = make({});  // A device whose driver tells of no resets hangs instead.
    if (context_ == EGL_NO_CONTEXT || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
        const char* vendor = eglQueryString(display_, EGL_VENDOR);
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
        throw InputError("--backend",
                         std::string("gl, but the driver (") + (vendor ? vendor : "unnamed") +
                             ") makes no OpenGL 4.5 core context without a window",
                         "a newer driver (docs/gpu.md), or cpu");
    }
    renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

void Context::listen()
{
    if (!wantsMessages()) return;
    listens_ = true;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    const auto hear = [](GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* text, const void* self) {
        if (!isFault(type, severity)) return;
        auto* context = static_cast<Context*>(const_cast<void*>(self));
        const std::lock_guard lock(context->mutex_);
        if (context->messages_.empty()) context->messages_ = text;
    };
    glDebugMessageCallback(hear, this);
}

Context::~Context()
{
    if (tryBind())
        programs_.clear();
    else
        // Names of a lost context cannot be given back. NOLINTNEXTLINE(bugprone-unhandled-exception-at-new)
        new Programs(std::move(programs_));
    release();
    eglDestroyContext(display_, context_);
}

bool Context::tryBind() noexcept
{
    const bool bound =
        eglGetCurrentContext() == context_ || eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
    errorsAreOf(&renderer_);
    return bound;
}

void Context::bind()
{
    if (tryBind()) return;
    if (eglGetError() == EGL_CONTEXT_LOST) deviceFailed("it was reset, and its context is lost");
    throw std::logic_error("gl: the context is in use by another thread");
}

void Context::release() noexcept
{
    if (eglGetCurrentContext() == context_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    errorsAreOf(nullptr);
}

void Context::check(const char* doing)
{
    if (listens_) {
        std::string message;
        {
            const std::lock_guard lock(mutex_);
            message.swap(messages_);
        }
        if (!message.empty()) deviceFailed(std::string("while ") + doing + " its driver says: " + message);
    }
    checkErrors(doing);
}

std::shared_ptr<Context> acquireContext(const DeviceRequest& request)
{
    // Never freed: drivers' own threads and exit handlers outlive static objects.
    static std::mutex& mutex = *new std::mutex;
    using Key = std::tuple<int, int, bool>;
    static auto& idle = *new std::multimap<Key, std::unique_ptr<Context>>;
    const Key key{request.gpu.device, request.gpu.rankOnHost, request.realOnly};
    std::unique_ptr<Context> context;
    {
        const std::lock_guard lock(mutex);
        if (const auto found = idle.find(key); found != idle.end()) {
            context = std::move(found->second);
            idle.erase(found);
        }
    }
    if (!context) context = std::make_unique<Context>(request);
    return {context.release(), [key](Context* used) {
                std::unique_ptr<Context> owned(used);
                const bool usable = used->tryBind() && glGetGraphicsResetStatus() == GL_NO_ERROR;
                used->release();
                if (!usable) return;
                const std::lock_guard lock(mutex);
                idle.emplace(key, std::move(owned));
            }};
}

}  // namespace aeolic::gl
