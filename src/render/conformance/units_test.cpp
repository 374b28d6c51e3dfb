#include "render/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "render_testing.h"

/// A body looks the same in any unit: from molecules in metres to galaxies, and whatever unit its vectors have.
namespace aeolic {
namespace {

using namespace testkit;

class Units : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Units, allBackends, backendName);

void scale(std::vector<glm::vec3>& values, double factor)
{
    for (glm::vec3& value : values) value = glm::vec3(glm::dvec3(value) * factor);
}

/// `scene` with lengths and vectors in other units.
Scene inUnits(Scene scene, double length, double vector)
{
    SurfaceMesh& mesh = scene.surface;
    scale(mesh.positions, length);
    mesh.originWorld *= length;
    scale(mesh.pointVectors, vector);
    scale(mesh.cellVectors, vector);
    scene.boundsWorld = {length * scene.boundsWorld.lo, length * scene.boundsWorld.hi};
    scene.maxVector *= vector;
    if (!scene.field) return scene;
    auto field = std::make_shared<GridField>(*scene.field);
    field->originWorld *= length;
    field->spacingWorld *= length;
    field->maxMagnitude *= vector;
    const std::size_t count = 3 * field->sampleCount();
    const auto samples = std::shared_ptr<float[]>(new float[count]);
    for (std::size_t i = 0; i < count; ++i) samples[i] = float(double(scene.field->floats()[i]) * vector);
    field->samples = std::shared_ptr<const void>(samples, samples.get());
    scene.field = std::move(field);
    scene.hasScalar = true;
    scene.ofVectors = ArrayPart::length;
    return scene;
}

std::vector<Scene> samples()
{
    SurfaceMesh points = makeCube({3, -2, 1}, 1), cells = makeCube({0, 0, 0}, 1);
    const auto flow = [](const glm::dvec3& p) { return glm::vec3(1 + p.y, 0.25 - p.x, 0.5 + p.z * p.x); };
    setPointVectors(points, flow);
    setCellVectors(cells, flow);
    return {makeBuiltinScene("teapot:2000", "abc:12,12,12"), makeScene(std::move(points)), makeScene(std::move(cells))};
}

void expectSame(Stages& one, Stages& other, const LicOptions& lic, double vector)
{
    const GBuffer &a = *one.buffer, &b = *other.buffer;
    int covered = 0, flowing = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            ASSERT_EQ(a.invDepth.at(x, y) == 0, b.invDepth.at(x, y) == 0) << x << ',' << y;
            ASSERT_EQ(a.flow.at(x, y), b.flow.at(x, y)) << x << ',' << y;
            if (a.invDepth.at(x, y) == 0) continue;
            ++covered;
            flowing += a.flow.at(x, y) != 0;
            ASSERT_EQ(a.light.at(x, y), b.light.at(x, y)) << x << ',' << y;
            ASSERT_EQ(a.links.at(x, y), b.links.at(x, y)) << x << ',' << y;
            const bool colored = one.scene.ofVectors == ArrayPart::length && a.flow.at(x, y) != 0;
            if (!colored) continue;
            ASSERT_EQ(float(double(a.scalar.at(x, y)) * vector), b.scalar.at(x, y)) << x << ',' << y;
        }
    EXPECT_GT(covered, 500);
    EXPECT_GT(flowing, 400);
    const Image<float>&u = one.convolve(lic), &v = other.convolve(lic);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) ASSERT_EQ(u.at(x, y), v.at(x, y)) << x << ',' << y;
}

/// A power of two rounds nothing, so not a bit may differ.
TEST_P(Units, NeitherLengthsNorVectorsChangeTheStreaks)
{
    struct Unit {
        double length, vector;
    };
    const Unit units[] = {{0x1p-50, 1}, {0x1p-40, 1},       {0x1p-12, 1},      {0x1p21, 1},
                          {0x1p47, 1},  {0x1p50, 1},        {0x1p90, 1},       {0x1p-90, 1},
                          {1, 0x1p70},  {1, 0x1p120},       {1, 0x1p-70},      {1, 0x1p-100},
                          {1, 0x1p31},  {0x1p-50, 0x1p-80}, {0x1p50, 0x1p100}, {0x1p-45, 0x1p64}};
    for (const bool normalize : {true, false})
        for (const Scene& scene : samples()) {
            LicOptions lic = directLic(20);
            lic.normalize = normalize;
            const double mask = 0.4 * scene.maxVector;
            lic.maskBelow = mask;
            CameraOptions options;
            options.focal = Vec3{1.5, -1, 0.5};
            Stages ordinary(GetParam(), inUnits(scene, 1, 1));
            ordinary.project(fitCamera(ordinary.scene, options, 80, 60), lic);
            for (const Unit& unit : units) {
                SCOPED_TRACE(testing::Message() << "lengths " << unit.length << ", vectors " << unit.vector);
                Stages other(GetParam(), inUnits(scene, unit.length, unit.vector));
                CameraOptions there = options;
                for (double& x : *there.focal) x *= unit.length;
                LicOptions same = lic;
                same.maskBelow = mask * unit.vector;
                other.project(fitCamera(other.scene, there, 80, 60), same);
                expectSame(ordinary, other, same, unit.vector);
                if (HasFatalFailure()) return;
            }
        }
}

TEST(KernelUnits, AreOnesForOrdinaryScenes)
{
    for (const double length : {0.001, 1.0, 1e5})
        for (const double vector : {1e-8, 1.0, 1e8}) {
            const Scene scene = inUnits(makeBuiltinScene("sphere:200", "rotation:8,8,8"), length, vector);
            EXPECT_EQ(lengthUnit(scene), 1) << length;
            EXPECT_EQ(vectorUnit(scene), 1) << vector;
        }
}

TEST(KernelUnits, ArePowersOfTwoThatFloatsHoldWithTheirInverses)
{
    Scene scene;
    EXPECT_EQ(lengthUnit(scene), 1);
    EXPECT_EQ(vectorUnit(scene), 1);
    for (const double size : {1e-300, 1e-45, 1e-38, 1e-12, 1e14, 1e30, 1e38, 1e300}) {
        scene.boundsWorld = {glm::dvec3(0), glm::dvec3(size)};
        scene.maxVector = size;
        for (const double unit : {lengthUnit(scene), vectorUnit(scene)}) {
            int exponent = 0;
            EXPECT_EQ(std::frexp(unit, &exponent), 0.5) << size;
            EXPECT_TRUE(std::isnormal(float(unit)) && std::isnormal(float(1 / unit))) << size;
        }
    }
}

}  // namespace
}  // namespace aeolic
