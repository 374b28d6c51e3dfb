#include "data/cells/near_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "data/cells/testing/volume_testing.h"
#include "data/cells/volume_message.h"

namespace aeolic {
namespace {

using namespace testing_volumes;

/// One triangle in the plane x = 0.5 of the unit box.
SurfaceMesh acrossTheMiddle()
{
    SurfaceMesh mesh;
    mesh.originWorld = {0.5, 0, 0};
    mesh.positions = {{0, 0.1, 0.1}, {0, 0.9, 0.1}, {0, 0.1, 0.9}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

TEST(NearSurface, DistancesToCornersEdgesAndTheInside)
{
    const std::array<glm::dvec3, 3> triangle{glm::dvec3(0), {1, 0, 0}, {0, 1, 0}};
    EXPECT_DOUBLE_EQ(distanceSquared({0.25, 0.25, 2}, triangle), 4);
    EXPECT_DOUBLE_EQ(distanceSquared({-1, -1, 0}, triangle), 2);
    EXPECT_DOUBLE_EQ(distanceSquared({3, 0, 0}, triangle), 4);
    EXPECT_DOUBLE_EQ(distanceSquared({0, 3, 1}, triangle), 5);
    EXPECT_DOUBLE_EQ(distanceSquared({0.5, -2, 0}, triangle), 4);
    EXPECT_DOUBLE_EQ(distanceSquared({1, 1, 0}, triangle), 0.5);
    EXPECT_DOUBLE_EQ(distanceSquared({-1, 0.5, 0}, triangle), 1);
    const std::array<glm::dvec3, 3> line{glm::dvec3(0), {1, 0, 0}, {2, 0, 0}}, point{};
    EXPECT_DOUBLE_EQ(distanceSquared({1.5, 1, 0}, line), 1) << "without an area";
    EXPECT_DOUBLE_EQ(distanceSquared({0, 2, 0}, point), 4);
}

TEST(NearSurface, EachTriangleHasItsOwnReach)
{
    SurfaceMesh mesh = acrossTheMiddle();
    const NearSurface near(SurfaceZone(mesh, {}));
    EXPECT_TRUE(near.isNear({0.5, 0.2, 0.2}, 0));
    EXPECT_FALSE(near.isNear({0.6, 0.2, 0.2}, 0.09));
    EXPECT_TRUE(near.isNear({0.6, 0.2, 0.2}, 0.11));
    for (int i = 0; i < 3; ++i) mesh.positions.push_back(mesh.positions[std::size_t(i)] + glm::vec3(10, 0, 0));
    mesh.triangles.push_back({3, 4, 5});
    const NearSurface both(SurfaceZone(mesh, {0, 0, 0, 2, 0, 0}));
    EXPECT_TRUE(both.isNear({12.4, 0.2, 0.2}, 0));
    EXPECT_FALSE(both.isNear({2.4, 0.2, 0.2}, 0)) << "the first has none";
    EXPECT_FALSE(NearSurface(SurfaceZone(SurfaceMesh{}, {})).isNear({0, 0, 0}, 1e9));
}

TEST(NearSurface, PreparingChangesNoAnswer)
{
    SurfaceMesh mesh = acrossTheMiddle();
    for (int i = 0; i < 3; ++i) mesh.positions.push_back(0.3F * mesh.positions[std::size_t(i)] + glm::vec3(0.2, 0, 0));
    mesh.triangles.push_back({3, 4, 5});
    const std::vector<double> reach{0.05, 0.1, 0, 0.2, 0, 0};
    const NearSurface plain(SurfaceZone(mesh, reach));
    Bounds box;
    box.add(glm::dvec3(0.1));
    box.add(glm::dvec3(0.9));
    std::vector<NearSurface::Question> questions;
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 p(std::fmod(i * 0.7548776662, 1), std::fmod(i * 0.5698402910, 1), std::fmod(i * 0.32, 1));
        for (const double more : {0.0, 0.05, 0.2}) questions.push_back({p, more * (i % 7) / 3});
    }
    for (const std::size_t count : {std::size_t{100}, std::size_t{3000}, questions.size()}) {
        NearSurface prepared(SurfaceZone(mesh, reach));
        prepared.prepare(box, count, [&](std::size_t i) { return questions[i]; });
        for (const NearSurface::Question& asked : questions)
            EXPECT_EQ(prepared.isNear(asked.pointWorld, asked.more), plain.isNear(asked.pointWorld, asked.more));
    }
}

class Shells : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, Shells,
                         testing::Values(Shape::tetra, Shape::pyramid, Shape::wedge, Shape::hexahedron,
                                         Shape::polyhedron));

/// Whatever is looked up within the reach is the same, to the bit, and the cells that are chosen are the same ones.
TEST_P(Shells, HoldAllThatCanBeFoundWithinTheReach)
{
    const auto volume = makeVolume({16, 9, 8}, unitBox, linearFlow, GetParam());
    const SurfaceMesh mesh = acrossTheMiddle();
    const double reach = 0.07;
    const auto shell =
        std::make_shared<VolumeCells>(shellOf(*volume, NearSurface(SurfaceZone(mesh, std::vector<double>(3, reach)))));
    EXPECT_LT(shell->count(), volume->count() * 3 / 4);
    EXPECT_LT(shell->points.size(), volume->points.size() * 3 / 4);
    EXPECT_EQ(shell->maxVector, volume->maxVector) << "what counts as at rest is the same";
    const CellSampler all(volume), some(shell, all.bounds());
    int found = 0;
    for (int i = 0; i < 2000; ++i) {
        const double u = std::fmod(i * 0.7548776662, 1), v = std::fmod(i * 0.5698402910, 1) * (1 - u),
                     h = (std::fmod(i * 0.3247179572, 1) - 0.5) * 2 * reach;
        const glm::dvec3 p(0.5 + h, 0.1 + 0.8 * u, 0.1 + 0.8 * v);
        CellPlace a, b;
        ASSERT_EQ(all.find(p, {1, 0, 0}, a), some.find(p, {1, 0, 0}, b)) << i;
        ++found;
        EXPECT_EQ(all.vectorAt(a), some.vectorAt(b)) << i;
        EXPECT_EQ(all.scalarAt(a), some.scalarAt(b)) << i;
        EXPECT_EQ(all.pointOf(a), some.pointOf(b)) << i;
        EXPECT_EQ(all.widthOf(a, {0, 1, 0}), some.widthOf(b, {0, 1, 0})) << i;
    }
    EXPECT_EQ(found, 2000);
}

/// Two halves of a volume that other ranks send are the volume.
TEST_P(Shells, MessagesPutTogetherAreTheWhole)
{
    const auto volume = makeVolume({4, 3, 3}, unitBox, linearFlow, GetParam());
    VolumeCells twice;
    twice.maxVector = volume->maxVector;
    const Bytes message = messageOf(*volume);
    appendCells(message, twice);
    appendCells(message, twice);
    ASSERT_EQ(twice.count(), 2 * volume->count());
    ASSERT_EQ(twice.points.size(), 2 * volume->points.size());
    const CellSampler one(volume), both(std::make_shared<VolumeCells>(twice));
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p(std::fmod(i * 0.7548776662, 1), std::fmod(i * 0.5698402910, 1), std::fmod(i * 0.32, 1));
        CellPlace a, b;
        ASSERT_TRUE(one.find(p, glm::dvec3(0), a) && both.find(p, glm::dvec3(0), b));
        EXPECT_EQ(a.cell, b.cell) << "the first of cells in the same place";
        b.cell += volume->count();
        EXPECT_EQ(one.vectorAt(a), both.vectorAt(b));
    }
}

TEST(VolumeShells, DamagedMessagesAreRefused)
{
    const auto volume = makeVolume({2, 2, 2}, unitBox, linearFlow);
    Bytes message = messageOf(*volume);
    for (const std::size_t size : {std::size_t(0), std::size_t(7), message.size() / 2, message.size() - 1}) {
        VolumeCells cells;
        EXPECT_THROW(appendCells(std::span(message).first(size), cells), std::runtime_error) << size;
    }
    message.push_back(std::byte(0));
    VolumeCells cells;
    EXPECT_THROW(appendCells(message, cells), std::runtime_error);
}

TEST(VolumeShells, AnEmptyOneFindsNothing)
{
    const auto volume = makeVolume({2, 2, 2}, unitBox, linearFlow);
    SurfaceMesh far = acrossTheMiddle();
    far.originWorld = {100, 0, 0};
    const auto shell = std::make_shared<VolumeCells>(shellOf(*volume, NearSurface(SurfaceZone(far, {}))));
    EXPECT_EQ(shell->count(), 0u);
    const CellSampler sampler(shell, CellSampler(volume).bounds());
    CellPlace place;
    EXPECT_FALSE(sampler.find({0.5, 0.5, 0.5}, glm::dvec3(0), place));
    EXPECT_EQ(sampler.meanDistanceOfCenters({0.5, 0.5, 0.5}, {0, 0, 1}), 0);
}

}  // namespace
}  // namespace aeolic
