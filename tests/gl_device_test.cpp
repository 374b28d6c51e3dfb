#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "cluster/comm/communicator.h"
#include "description/choices.h"
#include "engine/backend_together.h"
#include "gl_calls_testing.h"
#include "render/gl/device/context.h"
#include "render/gl/device/devices.h"
#include "render_testing.h"

/// Which device draws, and what is said where none can.
namespace aeolic {
namespace {

using namespace testkit;

std::string messageOf(BackendChoice backend, const Scene& scene, const GpuChoice& gpu = {})
{
    try {
        makeBackend(backend, scene, gpu);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

class GlDevice : public ::testing::Test {
protected:
    void SetUp() override { skipWithout("gl"); }
    Scene cube() const { return makeScene(makeCube({0, 0, 0}, 1)); }
};

TEST(GlDeviceNames, ProgramsThatDrawAreNoHardware)
{
    using gl::isSoftwareRenderer;
    EXPECT_TRUE(isSoftwareRenderer("llvmpipe (LLVM 15.0.6, 256 bits)"));
    EXPECT_TRUE(isSoftwareRenderer("softpipe"));
    EXPECT_TRUE(isSoftwareRenderer("Software Rasterizer"));
    EXPECT_FALSE(isSoftwareRenderer("NVIDIA H200/PCIe/SSE2"));
    EXPECT_FALSE(isSoftwareRenderer("AMD Radeon RX 6800 (navi21, LLVM 15.0.6, DRM 3.49)"));
}

/// Drivers say a lot that is no fault.
TEST(GlDeviceMessages, ErrorsAndWhatIsGraveAreFaults)
{
    using gl::isFault;
    for (const GLenum severity :
         {GL_DEBUG_SEVERITY_HIGH, GL_DEBUG_SEVERITY_MEDIUM, GL_DEBUG_SEVERITY_LOW, GL_DEBUG_SEVERITY_NOTIFICATION}) {
        const bool grave = severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM;
        EXPECT_TRUE(isFault(GL_DEBUG_TYPE_ERROR, severity));
        EXPECT_TRUE(isFault(GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR, severity));
        EXPECT_EQ(isFault(GL_DEBUG_TYPE_OTHER, severity), grave);
        EXPECT_EQ(isFault(GL_DEBUG_TYPE_PORTABILITY, severity), grave);
        EXPECT_EQ(isFault(GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR, severity), grave);
        EXPECT_FALSE(isFault(GL_DEBUG_TYPE_PERFORMANCE, severity));
        EXPECT_FALSE(isFault(GL_DEBUG_TYPE_MARKER, severity));
    }
}

/// A message of the kind that NVIDIA's driver has for textures that are not used.
TEST_F(GlDevice, AdviceDoesNotEndAFrame)
{
    const Scene scene = cube();
    const auto backend = makeBackend(BackendChoice::gl, scene);
    const View view = makeView(fitCamera(scene, {}, 40, 30), scene, {});
    backend->project(view, {0, 0, 40, 30});
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_LOW, 0, nullptr, GL_TRUE);
    glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, 131204, GL_DEBUG_SEVERITY_LOW, -1, "advice");
    EXPECT_NO_THROW(backend->convolve({}, {0, 0, 40, 30}));
}

TEST_F(GlDevice, AutoTakesRealHardwareOnly)
{
    const Scene scene = cube();
    const bool software = gl::isSoftwareRenderer(makeBackend(BackendChoice::gl, scene)->device());
    const auto alone = makeSerialCommunicator();
    SceneDescription description;
    description.surface.spec = "sphere:200";
    description.field.spec = "abc:4,4,4";
    BackendPlan plan = planBackend(*alone, description, {}, {});
    EXPECT_EQ(plan.kind().choice, software ? BackendChoice::cpu : BackendChoice::gl);
    EXPECT_EQ(makeBackend(*alone, plan, scene)->name(), software ? "cpu" : "gl");
    EXPECT_EQ(makeBackend(BackendChoice::automatic, scene)->name(), nameOf(plan.kind().choice));
    EXPECT_EQ(plan.unusedGpu.empty(), !software) << plan.unusedGpu;
    EXPECT_FALSE(plan.missed) << "a program is no GPU to complain of";
}

TEST_F(GlDevice, AnIndexBeyondTheListIsAnError)
{
    EXPECT_EQ(messageOf(BackendChoice::gl, cube(), {200, 0}).rfind("--device: 200; expected 0", 0), 0u)
        << messageOf(BackendChoice::gl, cube(), {200, 0});
}

TEST_F(GlDevice, MoreRanksThanDevicesShareThem)
{
    const Scene scene = cube();
    const auto first = makeBackend(BackendChoice::gl, scene, {-1, 0}),
               other = makeBackend(BackendChoice::gl, scene, {-1, 1000});
    EXPECT_EQ(first->device(), other->device());
}

TEST_F(GlDevice, AFieldLongerThanATextureSaysHowManyRanksWouldDo)
{
    Scene scene = cube();
    scene.field = makeField(scene.boundsWorld, {40000, 2, 2}, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    const std::string message = messageOf(BackendChoice::gl, scene);
    EXPECT_NE(message.find("40000x2x2 samples"), std::string::npos) << message;
    EXPECT_NE(message.find("ranks or more with --bricks on"), std::string::npos) << message;
    EXPECT_EQ(makeBackend(BackendChoice::automatic, scene)->name(), "cpu");
}

TEST_F(GlDevice, APictureLargerThanATextureIsAnError)
{
    const Scene scene = cube();
    const auto backend = makeBackend(BackendChoice::gl, scene);
    const View view = makeView(fitCamera(scene, {}, 40000, 2), scene, {});
    EXPECT_THROW(backend->project(view, {0, 0, 40000, 2}), InputError);
}

/// The longest side that a device draws into may differ between width and height, and be shorter than that of a
/// texture.
TEST_F(GlDevice, APictureHigherThanADeviceDrawsIsAnError)
{
    const Scene scene = cube();
    const auto backend = makeBackend(BackendChoice::gl, scene);
    static decltype(glGetInteger64v) real;
    real = glGetInteger64v;
    const Replaced<decltype(glGetInteger64v)> flat(glGetInteger64v, [](GLenum name, GLint64* value) {
        if (name == GL_MAX_VIEWPORT_DIMS)
            value[0] = 4000, value[1] = 70;
        else
            real(name, value);
    });
    const auto project = [&](int width, int height) {
        backend->project(makeView(fitCamera(scene, {}, width, height), scene, {}), {0, 0, width, height});
    };
    project(60, 60);
    try {
        project(60, 90);
        ADD_FAILURE() << "drawn";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()), "--size: 60x90; expected at most 70 pixels a side on this GPU");
    }
}

}  // namespace
}  // namespace aeolic
