#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "cluster/comm/communicator.h"
#include "description/choices.h"
#include "engine/backend_together.h"
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

TEST_F(GlDevice, AutoTakesRealHardwareOnly)
{
    const Scene scene = cube();
    const bool software = gl::isSoftwareRenderer(makeBackend(BackendChoice::gl, scene)->device());
    const auto alone = makeSerialCommunicator();
    SceneDescription description;
    description.surface.spec = "sphere:200";
    description.field.spec = "abc:4,4,4";
    BackendPlan plan = planBackend(*alone, description, {}, {});
    EXPECT_EQ(plan.choice, software ? BackendChoice::cpu : BackendChoice::automatic);
    EXPECT_EQ(makeBackend(*alone, plan, scene, {})->name(), software ? "cpu" : "gl");
    EXPECT_EQ(makeBackend(BackendChoice::automatic, scene)->name(), nameOf(plan.choice));
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

}  // namespace
}  // namespace aeolic
