#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "data/mesh/join_meshes.h"
#include "reference/reference.h"
#include "render_testing.h"

/// The projection stage of every backend against rays and triangles in double precision.
namespace aeolic {
namespace {

using namespace testkit;

/// Differences between a backend's G-buffer and the reference, as counts of pixels.
struct Differences {
    int covered = 0, coverage = 0;  ///< Covered in both; covered in one of the two only.
    int depth = 0, gradient = 0, light = 0, hasFlow = 0, vector = 0, noise = 0, scalar = 0;
    int links = 0, missedLinks = 0;  ///< Pairs of neighbours, both with flow in both.
};

Differences compare(const reference::PixelImage& expected, const GBuffer& buffer, bool withScalar,
                    double scalarTolerance)
{
    const reference::PixelImage found = reference::fromGBuffer(buffer);
    Differences d;
    for (int y = 0; y < expected.height; ++y)
        for (int x = 0; x < expected.width; ++x) {
            const reference::Pixel &a = expected.at(x, y), &b = found.at(x, y);
            if ((a.invDepth > 0) != (b.invDepth > 0)) ++d.coverage;
            if (!(a.invDepth > 0 && b.invDepth > 0)) continue;
            ++d.covered;
            d.depth += std::abs(a.invDepth - b.invDepth) > 1e-4 * a.invDepth;
            d.gradient += std::hypot(a.gradX - b.gradX, a.gradY - b.gradY) >
                          1e-3 * std::hypot(a.gradX, a.gradY) + 1e-6 * a.invDepth;
            d.light += std::abs(a.light - b.light) > 1e-3;
            d.hasFlow += a.hasFlow != b.hasFlow;
            if (withScalar)
                d.scalar +=
                    std::isnan(a.scalar) != std::isnan(b.scalar) || std::abs(a.scalar - b.scalar) > scalarTolerance;
            if (!a.hasFlow || !b.hasFlow) continue;
            // Half a unit of quantisation either way, and what single precision loses in long vectors.
            d.vector +=
                std::max(std::abs(a.vx - b.vx), std::abs(a.vy - b.vy)) > 0.75 * double(buffer.flowUnitPx) + 1e-3;
            d.noise += std::abs(a.noise - b.noise) > 0.5 / 127 + 0.004;
            for (int k = 0; k < 9; ++k) {
                const int sx = k % 3 - 1, sy = k / 3 - 1;
                if (k == 4 || !expected.contains(x + sx, y + sy)) continue;
                if (!expected.at(x + sx, y + sy).hasFlow || !found.at(x + sx, y + sy).hasFlow) continue;
                ++d.links;
                d.missedLinks += a.linked[std::size_t(k)] != b.linked[std::size_t(k)];
            }
        }
    return d;
}

/// Vertices are snapped to 1/256 pixel before drawing: a pixel centre that close to an edge may belong to either side.
void expectAgreement(const std::string& backend, Scene scene, const Camera& camera, double scalarTolerance = 0,
                     Style style = Style::dense, Magnitude magnitude = Magnitude::none,
                     std::optional<GrainValue> grains = std::nullopt)
{
    Stages stages(backend, std::move(scene));
    const bool withScalar = stages.scene.hasScalar;
    LicOptions lic = directLic(16);
    lic.style = style;
    lic.magnitude = magnitude;
    stages.project(camera, lic);
    if (grains) {
        stages.view.noise.grains = *grains;
        const Extent whole = wholeImage(camera);
        stages.backend->projectGrains(stages.view, whole, whole);
        stages.backend->complete(stages.view, whole);
        stages.buffer = &stages.backend->probe().gbuffer();
    }
    const reference::PixelImage expected = reference::project(stages.view, stages.scene, stages.noise);
    const Differences d = compare(expected, *stages.buffer, withScalar, scalarTolerance);
    const double few = 0.01 * d.covered, outlinePixels = 6 * std::sqrt(double(d.covered));
    EXPECT_GT(d.covered, 0);
    EXPECT_LE(d.coverage, 0.02 * outlinePixels);
    EXPECT_LE(d.depth, 0.002 * d.covered);
    EXPECT_LE(d.gradient, few);
    EXPECT_LE(d.light, 0.002 * d.covered);
    EXPECT_LE(d.hasFlow, 0.002 * d.covered);
    EXPECT_LE(d.vector, few);
    EXPECT_LE(d.noise, 0.002 * d.covered);
    EXPECT_LE(d.scalar, few);
    EXPECT_LE(d.missedLinks, 0.005 * d.links);
}

glm::vec3 swirl(const glm::dvec3& p)
{
    return glm::vec3(-p.y + 0.2 * p.z, p.x, 0.4 * p.z - 0.1);
}

class ProjectionConformance : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, ProjectionConformance, allBackends, backendName);

TEST_P(ProjectionConformance, GridFieldOnTheBuiltinSurfaces)
{
    for (const char* surface : {"teapot:2000", "sphere:2000", "torus:2000"}) {
        SCOPED_TRACE(surface);
        Scene scene = makeBuiltinScene(surface, "abc:24,24,24");
        scene.hasScalar = true;
        scene.ofVectors = ArrayPart::length;
        const Camera camera = fitCamera(scene, {}, 120, 90);
        expectAgreement(GetParam(), std::move(scene), camera, 2e-3);
    }
}

TEST_P(ProjectionConformance, GrainsOfOrientedStreaks)
{
    forEachSimdTarget([&] {
        for (const double zoom : {0.7, 1.0, 1.4}) {  // The finer grains, both, the coarser.
            SCOPED_TRACE(zoom);
            Scene scene = makeBuiltinScene("torus:800", "abc:24,24,24");
            CameraOptions view;
            view.zoom = zoom;
            const Camera camera = fitCamera(scene, view, 120, 90);
            expectAgreement(GetParam(), std::move(scene), camera, 0, Style::oriented);
        }
    });
}

TEST_P(ProjectionConformance, PhasesOfGrains)
{
    forEachSimdTarget([&] {
        for (const GrainValue value : {GrainValue::cosine, GrainValue::sine})
            for (const double zoom : {0.7, 1.4}) {
                SCOPED_TRACE(zoom);
                Scene scene = makeBuiltinScene("torus:800", "abc:24,24,24");
                CameraOptions view;
                view.zoom = zoom;
                const Camera camera = fitCamera(scene, view, 120, 90);
                expectAgreement(GetParam(), std::move(scene), camera, 0, Style::oriented, Magnitude::none, value);
            }
    });
}

TEST_P(ProjectionConformance, NoiseThatFadesWithTheVectors)
{
    forEachSimdTarget([&] {
        for (const Style style : {Style::dense, Style::oriented}) {
            Scene scene = makeBuiltinScene("torus:800", "abc:24,24,24");
            const Camera camera = fitCamera(scene, {}, 120, 90);
            expectAgreement(GetParam(), std::move(scene), camera, 0, style, Magnitude::contrast);
        }
    });
}

TEST_P(ProjectionConformance, PartsOfTheVectorsByTheNormal)
{
    forEachSimdTarget([&] {
        for (const ArrayPart part : {ArrayPart::normal, ArrayPart::tangential})
            for (const char* carries : {"field", "points", "triangles"}) {
                SCOPED_TRACE(std::string(suffixOf(part)) + " of " + carries);
                Scene scene = makeBuiltinScene("torus:800", "abc:24,24,24");
                scene.hasScalar = true;
                scene.ofVectors = part;
                SurfaceMesh& mesh = scene.surface;
                if (carries != std::string("field")) scene.field = nullptr;
                if (carries == std::string("points"))
                    for (const glm::vec3& p : mesh.positions) mesh.pointVectors.push_back(swirl(glm::dvec3(p)));
                if (carries == std::string("triangles"))
                    for (const auto& t : mesh.triangles)
                        mesh.cellVectors.push_back(swirl(glm::dvec3(mesh.positions[t[0]])));
                const Camera camera = fitCamera(scene, {}, 120, 90);
                expectAgreement(GetParam(), std::move(scene), camera, 2e-3);
            }
    });
}

/// A torus in a field, and a ball in its middle that carries vectors, scalar, or both.
TEST_P(ProjectionConformance, SurfacesWithTheirOwnBesideThoseInAField)
{
    const auto draw = [&](int own, ArrayPart part) {
        SCOPED_TRACE(std::to_string(own) + std::string(suffixOf(part)));
        Scene scene = makeBuiltinScene("torus:800", "abc:24,24,24");
        SurfaceMesh ball = makeBuiltinScene("sphere:800", "abc:2,2,2").surface;
        for (glm::vec3& p : ball.positions) p *= 0.3f;
        for (const glm::vec3& p : ball.positions) {
            ball.pointVectors.push_back(swirl(glm::dvec3(p)));
            ball.pointScalars.push_back(5 + p.x);
        }
        scene.surface = joinMeshes({&scene.surface, &ball}, scene.surface.originWorld);
        scene.surfaces = {{"torus", true, 0}, {"ball", true, 0, true, (own & 1) != 0, (own & 2) != 0}};
        scene.colors.resize(1);
        scene.hasScalar = true;
        scene.ofVectors = part;
        const Camera camera = fitCamera(scene, {}, 120, 90);
        expectAgreement(GetParam(), std::move(scene), camera, 2e-3);
    };
    for (const int own : {1, 2, 3})
        for (const ArrayPart part : {ArrayPart::length, ArrayPart::normal, ArrayPart::tangential}) draw(own, part);
}

TEST_P(ProjectionConformance, EverySimdTarget)
{
    forEachSimdTarget([&] {
        Scene scene = makeBuiltinScene("torus:800", "tornado:17,18,19");
        scene.hasScalar = true;
        scene.ofVectors = ArrayPart::length;
        const Camera camera = fitCamera(scene, {}, 75, 60);
        expectAgreement(GetParam(), std::move(scene), camera, 2e-3);
    });
}

TEST_P(ProjectionConformance, OddImageSizes)
{
    for (const auto& [width, height] :
         {std::pair(1, 1), std::pair(17, 5), std::pair(1, 800), std::pair(800, 1), std::pair(65, 63)}) {
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
        Scene scene = makeBuiltinScene("sphere:800", "rotation:8,8,8");
        CameraOptions options;
        options.zoom = std::max(1.0, 0.1 * std::max(width, height) / std::min(width, height));
        const Camera camera = fitCamera(scene, options, width, height);
        expectAgreement(GetParam(), std::move(scene), camera);
    }
}

TEST_P(ProjectionConformance, PointVectorsAndPointScalars)
{
    SurfaceMesh mesh = makeBuiltinScene("teapot:2000", "uniform:2,2,2").surface;
    setPointVectors(mesh, swirl);
    for (const glm::vec3& p : mesh.positions) mesh.pointScalars.push_back(p.x + 2 * p.z);
    Scene scene = makeScene(std::move(mesh));
    const Camera camera = fitCamera(scene, {}, 120, 90);
    expectAgreement(GetParam(), std::move(scene), camera, 1e-3);
}

TEST_P(ProjectionConformance, CellVectorsAndCellScalars)
{
    SurfaceMesh mesh = makeBuiltinScene("torus:2000", "uniform:2,2,2").surface;
    setCellVectors(mesh, swirl);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) mesh.cellScalars.push_back(float(i % 5));
    Scene scene = makeScene(std::move(mesh));
    const Camera camera = fitCamera(scene, {}, 120, 90);
    expectAgreement(GetParam(), std::move(scene), camera, 1e-5);
}

TEST_P(ProjectionConformance, ScalarOnTheFieldsGrid)
{
    Scene scene = makeBuiltinScene("sphere:2000", "abc:16,16,16");
    auto scalar = std::make_shared<GridField>(
        *makeField(scene.boundsWorld, {9, 10, 11}, [](const glm::dvec3&) { return glm::vec3(0); }));
    const std::size_t count = scalar->sampleCount();
    const auto samples = std::shared_ptr<float[]>(new float[count]);
    for (std::size_t i = 0; i < count; ++i) samples[i] = float(i * 7919 % 101) / 101;
    samples[count / 2] = std::numeric_limits<float>::quiet_NaN();
    scalar->components = 1;
    scalar->samples = std::shared_ptr<const void>(samples, samples.get());
    scene.scalarField = scalar;
    scene.hasScalar = true;
    const Camera camera = fitCamera(scene, {}, 120, 90);
    expectAgreement(GetParam(), std::move(scene), camera, 1e-3);
}

/// Wide angles, close by, rolled: where a wrong term of the projection shows.
TEST_P(ProjectionConformance, CloseWideAndRolledViews)
{
    for (const double zoom : {0.3, 1.0, 3.0}) {
        CameraOptions options;
        options.azimuth = -70;
        options.elevation = 65;
        options.roll = 33;
        options.fov = 110;
        options.zoom = zoom;
        SCOPED_TRACE(zoom);
        Scene scene = makeBuiltinScene("sphere:2000", "abc:16,16,16");
        const Camera camera = fitCamera(scene, options, 120, 90);
        expectAgreement(GetParam(), std::move(scene), camera);
    }
}

TEST_P(ProjectionConformance, VectorsInProportionToTheirMagnitude)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4);
    setPointVectors(mesh, [](const glm::dvec3& p) { return glm::vec3(1 + p.x, 0, 0); });
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    LicOptions lic = directLic(8);
    lic.normalize = false;
    lic.step = 2;
    const GBuffer& buffer = stages.project(frontCamera(stages.scene, 6, 80, 60), lic);
    for (int x = 0; x < 80; ++x) {
        if (buffer.invDepth.at(x, 30) <= 0) continue;
        // The largest vector, of length 2, takes one step of 2 pixels.
        const double vector = 1 + positionAt(stages.view.camera, double(buffer.invDepth.at(x, 30)), x, 30).x;
        const double expected = vector / stages.view.stepParts;
        EXPECT_NEAR(flow_texel::dx(buffer.flow.at(x, 30)) * double(buffer.flowUnitPx), expected,
                    double(buffer.flowUnitPx))
            << x;
        EXPECT_EQ(flow_texel::dy(buffer.flow.at(x, 30)), 0) << x;
    }
}

/// Only the part of a vector along the surface counts.
TEST_P(ProjectionConformance, NoiseIsLessWhereVectorsAreShort)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4);
    setPointVectors(mesh, [](const glm::dvec3& p) { return glm::vec3(1 + p.x, 0, 5); });
    Stages others(GetParam(), makeScene(mesh)), stages(GetParam(), makeScene(std::move(mesh)));
    LicOptions lic = directLic(8);
    const Camera camera = frontCamera(stages.scene, 6, 80, 60);
    const Image<std::uint32_t>& whole = others.project(camera, lic).flow;
    lic.magnitude = Magnitude::contrast;
    const GBuffer& buffer = stages.project(camera, lic);
    int compared = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            if (buffer.invDepth.at(x, y) <= 0) continue;
            const double along = 1 + positionAt(stages.view.camera, double(buffer.invDepth.at(x, y)), x, y).x;
            const double part = std::sqrt(along / stages.scene.maxVector);
            const int before = flow_texel::noise(whole.at(x, y)) - flow_texel::kNoiseZero,
                      after = flow_texel::noise(buffer.flow.at(x, y)) - flow_texel::kNoiseZero;
            if (std::abs(before) < flow_texel::kNoiseMost) {
                EXPECT_NEAR(after, part * before, 1.1) << x << ' ' << y;
            }
            EXPECT_EQ(flow_texel::dx(buffer.flow.at(x, y)), flow_texel::dx(whole.at(x, y)));
            ++compared;
        }
    EXPECT_GT(compared, 500);
}

/// The image direction of a tangent vector is where its ends are projected, perspective included: not its components
/// along the camera's axes, which are up to 30 degrees off in the corners of a wide view.
TEST_P(ProjectionConformance, DirectionsAreThoseOfProjectedPoints)
{
    const glm::dvec3 u(1, 0, 0.8), v(0.1, 1.2, -0.3);
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, 3.0 * u, 3.0 * v);
    setPointVectors(mesh, [&](const glm::dvec3&) { return glm::vec3(u + 0.5 * v); });
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    const GBuffer& buffer = stages.project(frontCamera(stages.scene, 7, 90, 70, 70), directLic(8));
    const Camera& camera = stages.view.camera;
    const glm::dvec3 step = glm::normalize(u + 0.5 * v) * (camera.pixelSizeAtBody() / stages.view.stepParts);
    int compared = 0;
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 90; ++x) {
            if (buffer.invDepth.at(x, y) <= 0) continue;
            const glm::dvec3 p = positionAt(camera, double(buffer.invDepth.at(x, y)), x, y);
            const glm::dvec3 moved = (imageOf(camera, p + 1e-3 * step) - imageOf(camera, p - 1e-3 * step)) / 2e-3;
            const double vx = flow_texel::dx(buffer.flow.at(x, y)) * double(buffer.flowUnitPx);
            const double vy = flow_texel::dy(buffer.flow.at(x, y)) * double(buffer.flowUnitPx);
            EXPECT_NEAR(vx, moved.x, 1e-3 + double(buffer.flowUnitPx)) << x << "," << y;
            EXPECT_NEAR(vy, moved.y, 1e-3 + double(buffer.flowUnitPx)) << x << "," << y;
            ++compared;
        }
    EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace aeolic
