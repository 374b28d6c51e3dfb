#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "description/choices.h"
#include "render_testing.h"

/// Streaks that flow: pictures of one cycle.
namespace aeolic {
namespace {

using namespace testkit;

class FlowLoop : public BackendTest {
protected:
    SceneDescription scene(LicMethod method = LicMethod::hierarchical) const
    {
        SceneDescription d;
        d.surface.spec = "teapot:6000";
        d.field.spec = "abc:24,24,24";
        d.shading.colorBy = "abc:mag";
        d.lic.method = method;
        d.lic.steps = 60;
        d.lic.flow = FlowMotion::loop;
        d.output.width = 150;
        d.output.height = 120;
        d.output.frames = 12;
        d.run.backend = *choiceNamed<BackendChoice>(GetParam());
        return d;
    }
};
INSTANTIATE_TEST_SUITE_P(Backends, FlowLoop, allBackends, backendName);

using Bytes = std::vector<std::uint8_t>;

Bytes frame(Renderer& renderer, int index)
{
    return renderer.render({AnimationFrame{index}}).pixels;
}

Bytes alone(const SceneDescription& scene, int index)
{
    Renderer renderer(scene);
    return frame(renderer, index);
}

double meanDifference(const Bytes& a, const Bytes& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(int(a[i]) - int(b[i]));
    return sum / double(a.size());
}

TEST_P(FlowLoop, AFramesBytesDoNotDependOnWhatWasDrawnBefore)
{
    const SceneDescription d = scene();
    Renderer renderer(d);
    const Bytes first = frame(renderer, 0), seventh = frame(renderer, 7);
    EXPECT_NE(first, seventh);
    EXPECT_EQ(seventh, alone(d, 7));
    EXPECT_EQ(frame(renderer, 0), first);

    CameraOptions other;
    other.azimuth = 75;
    renderer.render({other});
    EXPECT_EQ(frame(renderer, 7), seventh);  // Another view lay between.
    ShadingOptions shading = d.shading;
    shading.colormap = "coolwarm";
    renderer.setShading(shading);
    SceneDescription colored = d;
    colored.shading = shading;
    EXPECT_EQ(frame(renderer, 7), alone(colored, 7));  // Only colours changed.
    shading.antialias = false;
    shading.occlusion = true;
    renderer.setShading(shading);
    colored.shading = shading;
    EXPECT_EQ(frame(renderer, 7), alone(colored, 7));
    renderer.setShading(d.shading);
    LicOptions lic = d.lic;
    lic.seed = 5;
    renderer.setLic(lic);
    EXPECT_NE(frame(renderer, 7), seventh);
    renderer.setLic(d.lic);
    renderer.setSize(75, 60);
    frame(renderer, 3);
    renderer.setSize(150, 120);
    EXPECT_EQ(frame(renderer, 7), seventh);
}

TEST_P(FlowLoop, TheFrameAfterTheLastIsTheFirst)
{
    SceneDescription d = scene();
    const Bytes first = alone(d, 0);
    d.lic.phase = 2 * std::numbers::pi;
    EXPECT_EQ(alone(d, 0), first);
    // A step on from the last frame is as small as any other.
    Renderer renderer(scene());
    const Bytes second = frame(renderer, 1), last = frame(renderer, 11);
    const double step = meanDifference(first, second), back = meanDifference(last, first);
    EXPECT_GT(step, 0.3);
    EXPECT_NEAR(back, step, 0.15 * step);
}

/// Mixed from three phases, a picture is the one that the Hann kernel of that phase makes: at these three, and nearly
/// so between them, where streamlines end sooner than the kernel.
TEST_P(FlowLoop, IsTheHannKernel)
{
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        SceneDescription still = scene(method);
        still.lic.flow = FlowMotion::off;
        still.lic.kernel = Kernel::hann;
        still.output.orbit = 0;
        Renderer renderer(scene(method));
        for (const int index : {0, 1, 4, 5, 8, 10}) {
            still.lic.phase = 2 * std::numbers::pi * index / 12;
            EXPECT_LT(meanDifference(frame(renderer, index), alone(still, index)), index % 4 == 0 ? 0.01 : 2.5)
                << index;
        }
    }
}

/// Streamlines that are shorter than the kernel hold little of it at other phases. Their streaks stay as clear.
TEST_P(FlowLoop, ShortStreamlinesDoNotFadeAndComeBack)
{
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        SceneDescription d = scene(method);
        d.surface.spec = "plane";  // No streamline fills the kernel.
        d.field.spec = "uniform:4,4,4";
        d.shading.colorBy.clear();
        d.shading.lighting = false;
        d.shading.blend = 1;
        d.lic.steps = 200;
        Renderer renderer(d);
        std::vector<double> deviations;
        for (int index = 0; index < 12; ++index) {
            const DrawnFrame drawn = renderer.render({AnimationFrame{index}});
            double sum = 0, squares = 0, count = 0;
            for (std::size_t i = 0; i < drawn.pixels.size(); i += 3) {
                if (drawn.pixels[i] == 255) continue;  // Beside the plane.
                const double value = drawn.pixels[i];
                sum += value, squares += value * value, ++count;
            }
            ASSERT_GT(count, 1000);
            deviations.push_back(std::sqrt(squares / count - sum * sum / (count * count)));
        }
        const auto [least, most] = std::minmax_element(deviations.begin(), deviations.end());
        EXPECT_GT(*least, 0.6 * *most) << int(method) << ": " << testing::PrintToString(deviations);
        EXPECT_GT(*least, 10);
    }
}

/// What turns besides is drawn anew for each frame, and still closes.
TEST_P(FlowLoop, GoesOnWhileTheCameraTurns)
{
    SceneDescription d = scene();
    d.output.orbit = 360;
    SceneDescription hann = d;
    hann.lic.flow = FlowMotion::off;
    hann.lic.kernel = Kernel::hann;
    hann.lic.phase = 2 * std::numbers::pi * 5 / 12;
    EXPECT_EQ(alone(d, 5), alone(hann, 5));
}

TEST_P(FlowLoop, NothingToFlowIsDrawnAsItIs)
{
    for (const Style style : {Style::dense, Style::oriented}) {
        SceneDescription d = scene(LicMethod::none);
        d.lic.style = style;
        Renderer renderer(d);
        EXPECT_EQ(frame(renderer, 0), frame(renderer, 5));
        d.lic.flow = FlowMotion::off;
        EXPECT_EQ(frame(renderer, 0), alone(d, 0));
    }
    SceneDescription away = scene();
    away.camera.position = Vec3{0, -20, 0};
    away.camera.focal = Vec3{0, -30, 0};
    Renderer empty(away);
    EXPECT_EQ(frame(empty, 0), frame(empty, 5));
    EXPECT_EQ(empty.lastFrame().coveredPixels, 0);
}

TEST_P(FlowLoop, SumsAreKeptWhereTheCameraStands)
{
    Renderer renderer(scene());
    frame(renderer, 0);
    const std::int64_t covered = renderer.lastFrame().coveredPixels;
    const double threePhasesMs = renderer.lastFrame().convolveMs;
    frame(renderer, 1);
    EXPECT_EQ(renderer.lastFrame().coveredPixels, covered);
    EXPECT_LT(renderer.lastFrame().convolveMs, 0.5 * threePhasesMs);  // Nothing is convolved again.
    EXPECT_GT(covered, 1000);
}

TEST_P(FlowLoop, OrientedStreaksFlow)
{
    SceneDescription d = scene();
    d.lic.style = Style::oriented;
    Renderer renderer(d);
    const Bytes first = frame(renderer, 0), seventh = frame(renderer, 7);
    EXPECT_EQ(seventh, alone(d, 7));
    EXPECT_EQ(frame(renderer, 0), first);
    renderer.render({CameraOptions{}});
    EXPECT_EQ(frame(renderer, 7), seventh);
    LicOptions still = d.lic;
    still.flow = FlowMotion::off;
    renderer.setLic(still);
    EXPECT_NE(frame(renderer, 7), seventh);
    renderer.setLic(d.lic);
    EXPECT_EQ(frame(renderer, 7), seventh);

    d.lic.phase = 2 * std::numbers::pi;
    EXPECT_EQ(alone(d, 0), first);
    d.lic.phase = 0;
    d.output.orbit = 360;  // Each frame has its own runs.
    Renderer turning(d);
    frame(turning, 3);
    EXPECT_EQ(frame(turning, 5), alone(d, 5));
}

TEST_P(FlowLoop, RunsOfOrientedStreaksAreKeptWhereTheCameraStands)
{
    SceneDescription d = scene();
    d.lic.style = Style::oriented;
    Renderer renderer(d);
    frame(renderer, 0);
    const std::int64_t covered = renderer.lastFrame().coveredPixels;
    const double allMs = renderer.lastFrame().convolveMs;
    frame(renderer, 1);
    EXPECT_EQ(renderer.lastFrame().coveredPixels, covered);
    EXPECT_LT(renderer.lastFrame().convolveMs, 0.5 * allMs);
    EXPECT_GT(covered, 1000);
}

}  // namespace
}  // namespace aeolic
