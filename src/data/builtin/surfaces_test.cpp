#include "data/builtin/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "aeolic/error.h"
#include "data/mesh/mesh_tools.h"
#include "data/mesh/testing/mesh_topology_testing.h"

namespace aeolic {
namespace {

using std::numbers::pi;

void expectBounds(const Bounds& bounds, const glm::dvec3& lo, const glm::dvec3& hi, double tolerance)
{
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(bounds.lo[axis], lo[axis], tolerance) << "axis " << axis;
        EXPECT_NEAR(bounds.hi[axis], hi[axis], tolerance) << "axis " << axis;
    }
}

TEST(BuiltinSurfaces, TheSphereIsClosedAndHasTheAreaAndVolumeOfASphere)
{
    const SurfaceMesh sphere = makeBuiltinSurface("sphere");
    const MeshTopology topology = topologyOf(sphere);
    EXPECT_EQ(topology.eulerCharacteristic, 2);
    EXPECT_EQ(topology.boundaryEdges, 0u);
    EXPECT_EQ(topology.unevenEdges, 0u);
    // An inscribed mesh of N triangles falls short by O(1 / N).
    EXPECT_NEAR(areaOf(sphere), 4 * pi, 4 * pi * 2e-3);
    EXPECT_LT(areaOf(sphere), 4 * pi);
    EXPECT_NEAR(volumeOf(sphere), 4 * pi / 3, 4 * pi / 3 * 2e-3);
    expectBounds(sphere.bounds(), glm::dvec3(-1), glm::dvec3(1), 1e-7);
}

TEST(BuiltinSurfaces, TheSphereNormalIsItsPosition)
{
    const SurfaceMesh sphere = makeBuiltinSurface("sphere:1000");
    for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(sphere.positions[i]), 1, 2e-7);
        EXPECT_NEAR(glm::distance(sphere.positions[i], sphere.normals[i]), 0, 2e-7);
    }
    EXPECT_LT(worstNormalLength(sphere), 1e-6);
}

TEST(BuiltinSurfaces, TheTorusIsClosedWithOneHoleAndHasTheAreaAndVolumeOfATorus)
{
    const SurfaceMesh torus = makeBuiltinSurface("torus");
    const MeshTopology topology = topologyOf(torus);
    EXPECT_EQ(topology.eulerCharacteristic, 0);
    EXPECT_EQ(topology.boundaryEdges, 0u);
    EXPECT_EQ(topology.unevenEdges, 0u);
    EXPECT_NEAR(areaOf(torus), 4 * pi * pi * 0.4, 4 * pi * pi * 0.4 * 2e-3);
    EXPECT_NEAR(volumeOf(torus), 2 * pi * pi * 0.16, 2 * pi * pi * 0.16 * 4e-3);
    expectBounds(torus.bounds(), {-1.4, -1.4, -0.4}, {1.4, 1.4, 0.4}, 1e-6);
}

TEST(BuiltinSurfaces, TheTorusNormalPointsFromItsCoreCircle)
{
    const SurfaceMesh torus = makeBuiltinSurface("torus:2000");
    for (std::size_t i = 0; i < torus.positions.size(); ++i) {
        const glm::dvec3 p(torus.positions[i]);
        const glm::dvec3 core = glm::normalize(glm::dvec3(p.x, p.y, 0));
        EXPECT_NEAR(glm::distance(glm::dvec3(torus.normals[i]), (p - core) / 0.4), 0, 1e-6);
    }
}

TEST(BuiltinSurfaces, ThePlaneIsASquareOfAreaFourFacingUp)
{
    const SurfaceMesh plane = makeBuiltinSurface("plane");
    EXPECT_EQ(plane.triangles.size(), 512u);
    EXPECT_EQ(topologyOf(plane).eulerCharacteristic, 1);
    EXPECT_EQ(topologyOf(plane).boundaryEdges, 4u * 16u);
    EXPECT_NEAR(areaOf(plane), 4, 1e-6);
    EXPECT_EQ(worstNormalAgreement(plane), 1);
    EXPECT_EQ(plane.bounds().lo, glm::dvec3(-1, -1, 0));
    EXPECT_EQ(plane.bounds().hi, glm::dvec3(1, 1, 0));
}

TEST(BuiltinSurfaces, EveryShapeOfEverySizeIsSoundAndAboutAsFineAsAsked)
{
    for (const std::string name : {"teapot", "sphere", "torus", "plane"}) {
        for (const std::size_t asked : {2u, 9u, 100u, 777u, 10'000u, 300'000u}) {
            SCOPED_TRACE(name + ":" + std::to_string(asked));
            SurfaceMesh mesh = makeBuiltinSurface(name + ":" + std::to_string(asked));
            EXPECT_GE(mesh.triangles.size(), asked);
            if (asked >= 777) {
                EXPECT_LE(double(mesh.triangles.size()), 1.4 * double(asked));
            }
            if (asked >= 10'000) {
                EXPECT_LE(double(mesh.triangles.size()), 1.1 * double(asked));
            }
            EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
            EXPECT_LT(worstNormalLength(mesh), 1e-6);
            if (asked >= 10'000 || name != "teapot") {  // A coarser teapot's lip is a mere wedge.
                EXPECT_GT(worstNormalAgreement(mesh), 0);
            }
            EXPECT_EQ(dropDegenerateTriangles(mesh), 0u);
            EXPECT_EQ(mesh.name, name);
            EXPECT_LT(glm::distance(mesh.bounds().center(), mesh.originWorld), 1e-6);
        }
    }
}

TEST(BuiltinSurfaces, NamesAreRecognisedByThePartBeforeTheColon)
{
    EXPECT_TRUE(isBuiltinSurface("teapot"));
    EXPECT_TRUE(isBuiltinSurface("sphere:100"));
    EXPECT_TRUE(isBuiltinSurface("torus:nonsense"));
    EXPECT_FALSE(isBuiltinSurface("teapot.vtp"));
    EXPECT_FALSE(isBuiltinSurface("Teapot"));
    EXPECT_FALSE(isBuiltinSurface(""));
    EXPECT_FALSE(isBuiltinSurface(":100"));
}

TEST(BuiltinSurfaces, BadSpecsAreRefusedWithOneLineThatNamesThem)
{
    for (const std::string spec :
         {"cube", "", "teapot:", "teapot:abc", "teapot:1", "teapot:-5", "sphere:1e6", "torus:10x", "plane: 10",
          "sphere:10:10", "teapot:50000001", "teapot:99999999999999999999"}) {
        SCOPED_TRACE(spec);
        try {
            makeBuiltinSurface(spec);
            FAIL() << "accepted";
        } catch (const InputError& error) {
            const std::string what = error.what();
            EXPECT_EQ(what.find("--surface: '" + spec + "'; expected "), 0u) << what;
            EXPECT_EQ(what.find('\n'), std::string::npos);
        }
    }
}

TEST(BuiltinSurfaces, TheWaveTravelsAlongX)
{
    for (const double time : {0.0, 1.25, 3.0, 5.0, 1005.0, -2.0}) {
        const SurfaceMesh wave = makeBuiltinSurface("wave:2000", time);
        for (std::size_t i = 0; i < wave.positions.size(); ++i) {
            const glm::dvec3 p = wave.positions[i], n = wave.normals[i];
            const double phase = 2 * pi * (p.x - time / 5);
            EXPECT_NEAR(p.z, 0.1 * std::sin(phase), 1e-6);
            EXPECT_NEAR(-n.x / n.z, 0.1 * 2 * pi * std::cos(phase), 1e-5);
            EXPECT_EQ(n.y, 0);
        }
        const Bounds always = builtinSurfaceBounds("wave:2000", wave), now = wave.bounds();
        EXPECT_LE(always.lo.z, now.lo.z);
        EXPECT_GE(always.hi.z, now.hi.z);
        EXPECT_EQ(always.hi.x, now.hi.x);
        EXPECT_LT(worstNormalLength(wave), 1e-6);
    }
}

TEST(BuiltinSurfaces, TheWaveKeepsItsTriangles)
{
    const SurfaceMesh a = makeBuiltinSurface("wave:500", 0), b = makeBuiltinSurface("wave:500", 2);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_NE(a.positions, b.positions);
    EXPECT_EQ(topologyOf(a).unevenEdges, 0u);
    EXPECT_EQ(builtinSurfaceTimes("wave").back(), 5);
    EXPECT_TRUE(builtinSurfaceTimes("plane").empty());
    EXPECT_TRUE(builtinSurfaceTimes("wave.vtp").empty());
}

}  // namespace
}  // namespace aeolic
