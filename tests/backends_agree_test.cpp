#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "cluster/comm/communicator.h"
#include "description/choices.h"
#include "engine/frame.h"
#include "render_testing.h"

/// The same picture from every backend, but for rounding: a streak that starts a rounding error beside another ends a
/// little beside it.
namespace aeolic {
namespace {

using namespace testkit;

Tile draw(const std::string& backendName, const Scene& scene, const Camera& camera, const LicOptions& lic,
          const ShadingOptions& shading)
{
    FrameGroup group(makeSerialCommunicator(), {});
    const auto backend = makeBackend(*choiceNamed<BackendChoice>(backendName), scene);
    Frame frame;
    renderFrame({camera, lic, shading}, scene, *backend, group, frame);
    return frame.tiles.stripe;
}

bool isBackground(const std::uint8_t* pixel)
{
    return pixel[3] == 0;
}

/// A pixel beside one of the other kind.
bool onSilhouette(const Tile& tile, int x, int y)
{
    const bool here = isBackground(tile.row(y) + 4 * x);
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, tile.extent.y1 - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, tile.extent.x1 - 1); ++i)
            if (isBackground(tile.row(j) + 4 * i) != here) return true;
    return false;
}

void expectAgreement(const Scene& scene, const CameraOptions& view, const LicOptions& lic, int width, int height)
{
    ShadingOptions shading;
    shading.background = "transparent";
    const Camera camera = fitCamera(scene, view, width, height);
    const Tile a = draw("cpu", scene, camera, lic, shading), b = draw("gl", scene, camera, lic, shading);
    ASSERT_EQ(a.rgba.size(), b.rgba.size());
    double sum = 0;
    int covered = 0, far = 0, inside = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::uint8_t *p = a.row(y) + 4 * x, *q = b.row(y) + 4 * x;
            if (isBackground(p) != isBackground(q)) {
                inside += !onSilhouette(a, x, y);
                continue;
            }
            if (isBackground(p)) continue;
            ++covered;
            int largest = 0;
            for (int c = 0; c < 3; ++c) {
                sum += std::abs(p[c] - q[c]);
                largest = std::max(largest, std::abs(p[c] - q[c]));
            }
            far += largest > 4;
        }
    ASSERT_GT(covered, width * height / 10);
    EXPECT_LE(sum / (3.0 * covered), 0.1);
    EXPECT_LE(far, 0.001 * covered);
    EXPECT_EQ(inside, 0) << "pixels covered on one backend alone, away from any silhouette";
    ::testing::Test::RecordProperty("meanDifference", std::to_string(sum / (3.0 * covered)));
    ::testing::Test::RecordProperty("shareBeyond4", std::to_string(double(far) / covered));
}

class BackendsAgree : public ::testing::Test {
protected:
    void SetUp() override { skipWithout("gl"); }
};

LicOptions licOf(LicMethod method, int steps, Kernel kernel = Kernel::box, Integrator integrator = Integrator::rk2)
{
    LicOptions lic = directLic(steps, integrator, kernel, 0.7);
    lic.method = method;
    return lic;
}

TEST_F(BackendsAgree, BothMethodsOnBuiltinSurfaces)
{
    CameraOptions close;
    close.zoom = 1.4;
    for (const char* surface : {"teapot:6000", "torus:4000", "sphere:4000"}) {
        Scene scene = makeBuiltinScene(surface, "abc:32,32,32");
        scene.hasScalar = true;
        scene.ofVectors = ArrayPart::length;
        scene.scalarRange = {0, 3.5};
        for (const LicMethod method : {LicMethod::none, LicMethod::direct, LicMethod::hierarchical})
            for (const int steps : {16, 128}) {
                SCOPED_TRACE(std::string(surface) + ", method " + std::to_string(int(method)) + ", " +
                             std::to_string(steps) + " steps");
                expectAgreement(scene, close, licOf(method, steps), 320, 240);
            }
    }
}

/// Errors where traces end or the flow parts lie along lines of pixels. In a small picture those are a larger share of
/// all pixels.
TEST_F(BackendsAgree, KernelsIntegratorsAndStepsByMagnitude)
{
    const Scene scene = makeBuiltinScene("teapot:6000", "tornado:32,32,32");
    for (const Integrator integrator : {Integrator::euler, Integrator::rk4})
        expectAgreement(scene, {}, licOf(LicMethod::direct, 40, Kernel::hann, integrator), 300, 220);
    LicOptions lic = licOf(LicMethod::hierarchical, 77, Kernel::hann);  // 77 steps leave a remainder after the jumps.
    expectAgreement(scene, {}, lic, 300, 220);
    lic.normalize = false;
    expectAgreement(scene, {}, lic, 300, 220);
    expectAgreement(scene, {}, licOf(LicMethod::hierarchical, 128), 300, 220);
}

TEST_F(BackendsAgree, SurfaceVectorsAndScalars)
{
    SurfaceMesh mesh = makeBuiltinScene("torus:4000", "uniform:2,2,2").surface;
    setPointVectors(mesh, [](const glm::dvec3& p) { return glm::vec3(-p.y, p.x, 0.3); });
    for (const glm::vec3& p : mesh.positions) mesh.pointScalars.push_back(p.x);
    Scene scene = makeScene(std::move(mesh));
    scene.scalarRange = {-0.5, 0.5};
    expectAgreement(scene, {}, licOf(LicMethod::hierarchical, 50), 300, 220);
}

}  // namespace
}  // namespace aeolic
