#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render_testing.h"

/// The noise lives in physical space: the streaks stay on the surface when the camera moves.
namespace aeolic {
namespace {

using namespace testkit;

struct Picture {
    Camera camera;
    Image<float> invDepth, light, lic;
};

void copy(const Image<float>& from, Image<float>& to)
{
    to.resize(from.valid());
    for (int y = from.valid().y0; y < from.valid().y1; ++y)
        for (int x = from.valid().x0; x < from.valid().x1; ++x) to.at(x, y) = from.at(x, y);
}

Picture draw(Stages& stages, const CameraOptions& options, const LicOptions& lic)
{
    Picture picture;
    picture.camera = fitCamera(stages.scene, options, 300, 300);
    const GBuffer& buffer = stages.project(picture.camera, lic);
    copy(buffer.invDepth, picture.invDepth);
    copy(buffer.light, picture.light);
    copy(stages.convolve(lic), picture.lic);
    return picture;
}

/// LIC values of the same points of the surface in two pictures, where both see them from well above.
double agreement(const Picture& a, const Picture& b)
{
    constexpr float wellAbove = 0.35f + 0.65f * 0.6f;  // Light at 53 degrees off the normal.
    std::vector<double> inA, inB;
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 300; ++x) {
            if (!(a.invDepth.at(x, y) > 0) || a.light.at(x, y) < wellAbove) continue;
            const glm::dvec3 at = imageOf(b.camera, positionAt(a.camera, double(a.invDepth.at(x, y)), x, y));
            const int x0 = int(std::floor(at.x)), y0 = int(std::floor(at.y));
            if (!b.lic.valid().contains(x0, y0) || !b.lic.valid().contains(x0 + 1, y0 + 1)) continue;
            if (b.light.at(x0, y0) < wellAbove || !(std::abs(1 / at.z - double(b.invDepth.at(x0, y0))) < 0.01 / at.z))
                continue;
            const double wx = at.x - x0, wy = at.y - y0;
            inA.push_back(double(a.lic.at(x, y)));
            inB.push_back((1 - wy) * ((1 - wx) * double(b.lic.at(x0, y0)) + wx * double(b.lic.at(x0 + 1, y0))) +
                          wy * ((1 - wx) * double(b.lic.at(x0, y0 + 1)) + wx * double(b.lic.at(x0 + 1, y0 + 1))));
        }
    EXPECT_GT(inA.size(), 10000u);
    return correlation(inA, inB);
}

class CameraMotion : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, CameraMotion, allBackends, backendName);

TEST_P(CameraMotion, StreaksStickToATurningSphere)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:40000", "abc:48,48,48"));
    const LicOptions lic = directLic(24);
    CameraOptions options;
    const Picture before = draw(stages, options, lic);
    options.azimuth += 5;
    EXPECT_GT(agreement(before, draw(stages, options, lic)), 0.9);
    options.elevation += 5;
    options.roll += 20;
    EXPECT_GT(agreement(before, draw(stages, options, lic)), 0.8);
}

TEST_P(CameraMotion, StreaksStayWhenTheCameraComesNearer)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:40000", "abc:48,48,48"));
    CameraOptions options;
    LicOptions lic = directLic(24);
    const Picture before = draw(stages, options, lic);
    options.zoom = 1.05;
    EXPECT_GT(agreement(before, draw(stages, options, lic)), 0.85);
}

/// Another seed is another noise: the tests above can fail.
TEST_P(CameraMotion, AnotherSeedAgreesInNothing)
{
    Stages first(GetParam(), makeBuiltinScene("sphere:40000", "abc:48,48,48"), 1),
        second(GetParam(), makeBuiltinScene("sphere:40000", "abc:48,48,48"), 2);
    const LicOptions lic = directLic(24);
    EXPECT_LT(std::abs(agreement(draw(first, {}, lic), draw(second, {}, lic))), 0.15);
}

}  // namespace
}  // namespace aeolic
