#include "data/load/series/interpolate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/half.h"

namespace aeolic {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

GridField field(const std::vector<float>& values, FieldPrecision precision = FieldPrecision::float32)
{
    GridField f;
    f.dims = {2, 2, 2};
    f.components = 1;
    f.precision = precision;
    const auto floats = std::make_shared<std::vector<float>>(values);
    f.samples = std::shared_ptr<const void>(floats, floats->data());
    if (precision == FieldPrecision::float32) return f;
    const auto halves = std::make_shared<std::vector<std::uint16_t>>();
    for (const float value : values) halves->push_back(halfFromFloat(value));
    f.samples = std::shared_ptr<const void>(halves, halves->data());
    return f;
}

TEST(Interpolate, FieldsLinearlyInTime)
{
    const GridField a = field({0, 1, -2, 3, 0, 0, 7, 1e38f}), b = field({4, 1, 2, -1, 0, 1, 7, -1e38f});
    const auto c = interpolated(a, b, 0.25);
    const float expected[] = {1, 1, -1, 2, 0, 0.25f, 7, 5e37f};
    for (int i = 0; i < 8; ++i) EXPECT_FLOAT_EQ(c->floats()[i], expected[i]);
}

TEST(Interpolate, WhatDoesNotChangeKeepsItsBits)
{
    std::vector<float> values;
    for (int i = 0; i < 8; ++i) values.push_back(std::sqrt(float(i)) - 1.3f);
    for (const double weight : {0.1, 1.0 / 3, 0.999}) {
        const auto c = interpolated(field(values), field(values), weight);
        for (int i = 0; i < 8; ++i) EXPECT_EQ(c->floats()[i], values[std::size_t(i)]);
    }
}

TEST(Interpolate, WhatEitherStepMasksIsMasked)
{
    const auto c = interpolated(field({kNan, 1, 1, 1, 1, 1, 1, 1}), field({1, kNan, 1, 1, 1, 1, 1, 1}), 0.5);
    EXPECT_TRUE(std::isnan(c->floats()[0]));
    EXPECT_TRUE(std::isnan(c->floats()[1]));
    EXPECT_EQ(c->floats()[2], 1);
}

TEST(Interpolate, HalvesStayHalves)
{
    const auto half = FieldPrecision::float16;
    const auto c = interpolated(field({0, 1, 2, 3, 4, 5, 6, kNan}, half), field({1, 1, 2, 5, 4, 5, 6, 0}, half), 0.5);
    EXPECT_EQ(floatFromHalf(c->halves()[0]), 0.5f);
    EXPECT_EQ(floatFromHalf(c->halves()[3]), 4.0f);
    EXPECT_TRUE(std::isnan(floatFromHalf(c->halves()[7])));
}

TEST(Interpolate, MemoryIsUsedAgain)
{
    const GridField a = field({0, 0, 0, 0, 0, 0, 0, 0}), b = field({1, 1, 1, 1, 1, 1, 1, 1});
    const auto first = interpolated(a, b, 0.5);
    const void* memory = first->samples.get();
    const auto second = interpolated(a, b, 0.75, first);
    EXPECT_EQ(second->samples.get(), memory);
    EXPECT_EQ(second->floats()[0], 0.75f);
}

/// Nothing between two steps is longer than the longest of both, whichever has it.
TEST(Interpolate, TheLongestVectorIsThatOfBothSteps)
{
    GridField a = field({0, 0, 0, 0, 0, 0, 0, 0}), b = a;
    a.maxMagnitude = 3;
    b.maxMagnitude = 5;
    for (const double weight : {0.0, 0.5, 1.0}) {
        EXPECT_EQ(interpolated(a, b, weight)->maxMagnitude, 5);
        EXPECT_EQ(interpolated(b, a, weight)->maxMagnitude, 5);
    }
    const auto reused = interpolated(a, a, 0.5);
    EXPECT_EQ(reused->maxMagnitude, 3);
    EXPECT_EQ(interpolated(a, b, 0.5, reused)->maxMagnitude, 5) << "and not that of the memory used again";
}

TEST(Interpolate, MemoryOfAnotherGridIsNotUsedAgain)
{
    const GridField a = field({0, 0, 0, 0, 0, 0, 0, 0}), b = field({1, 1, 1, 1, 1, 1, 1, 1});
    auto half = interpolated(field({0, 0, 0, 0, 0, 0, 0, 0}, FieldPrecision::float16),
                             field({0, 0, 0, 0, 0, 0, 0, 0}, FieldPrecision::float16), 0.5);
    const void* memory = half->samples.get();
    const std::shared_ptr<const void> kept = half->samples;  // So that nothing else comes to lie there.
    const auto c = interpolated(a, b, 0.5, std::move(half));
    EXPECT_NE(c->samples.get(), memory);
    EXPECT_EQ(c->precision, FieldPrecision::float32);
    for (int i = 0; i < 8; ++i) EXPECT_EQ(c->floats()[i], 0.5f);
}

TEST(Interpolate, OtherGridsAreNotTheSame)
{
    const GridField a = field({0, 0, 0, 0, 0, 0, 0, 0});
    GridField b = a;
    EXPECT_TRUE(sameGrid(a, b));
    b.originWorld.x = 1e-9;
    EXPECT_FALSE(sameGrid(a, b));
    b = a;
    b.brick = Brick{{0, 0, 0}, {1, 1, 1}};
    EXPECT_FALSE(sameGrid(a, b));
    b = a;
    b.precision = FieldPrecision::float16;
    EXPECT_FALSE(sameGrid(a, b));
    b = a;
    b.dims = {2, 4, 1};
    EXPECT_FALSE(sameGrid(a, b));
    b = a;
    b.spacingWorld.z = 2;
    EXPECT_FALSE(sameGrid(a, b));
    b = a;
    b.components = 3;
    EXPECT_FALSE(sameGrid(a, b));
    b = a;
    b.tiled = true;
    EXPECT_FALSE(sameGrid(a, b));
}

LoadedSurface triangle()
{
    LoadedSurface s;
    s.topology = 42;
    s.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    s.mesh.triangles = {{0, 1, 2}};
    s.pointIds = {0, 1, 2};
    s.mesh.pointScalars = {0, 1, 2};
    return s;
}

TEST(Interpolate, SurfacesWithTheirArraysAndOrigins)
{
    const LoadedSurface a = triangle();
    LoadedSurface b = triangle();
    b.mesh.originWorld = {10, 0, 2};
    b.mesh.pointScalars = {4, 1, 0};
    const auto c = interpolated(a, b, 0.5);
    ASSERT_TRUE(c);
    EXPECT_EQ(c->mesh.originWorld, a.mesh.originWorld);
    EXPECT_EQ(c->mesh.positions[1], glm::vec3(6, 0, 1));
    EXPECT_EQ(c->mesh.pointScalars, (std::vector<float>{2, 1, 1}));
    EXPECT_TRUE(c->mesh.normals.empty());
}

TEST(Interpolate, EveryArrayOfASurface)
{
    LoadedSurface a = triangle(), b = triangle();
    a.mesh.pointVectors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    b.mesh.pointVectors = {{5, 0, 0}, {0, 5, 0}, {0, 0, 5}};
    a.mesh.cellVectors = {{0, 4, 8}};
    b.mesh.cellVectors = {{4, 4, 0}};
    a.mesh.cellScalars = {8};
    b.mesh.cellScalars = {12};
    b.mesh.positions[1] = {5, 4, -4};
    const auto c = interpolated(a, b, 0.25);
    ASSERT_TRUE(c);
    EXPECT_EQ(c->mesh.positions[1], glm::vec3(2, 1, -1));
    EXPECT_EQ(c->mesh.pointVectors, (std::vector<glm::vec3>{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}));
    EXPECT_EQ(c->mesh.cellVectors, (std::vector<glm::vec3>{{1, 4, 6}}));
    EXPECT_EQ(c->mesh.cellScalars, (std::vector<float>{9}));
}

TEST(Interpolate, PointsInAnotherOrderAreMatched)
{
    const LoadedSurface a = triangle();
    LoadedSurface b = triangle();
    b.pointIds = {2, 0, 1};
    b.mesh.positions = {{0, 3, 0}, {0, 0, 0}, {1, 0, 0}};
    b.mesh.pointScalars = {4, 0, 1};
    b.mesh.triangles = {{1, 2, 0}};
    LoadedSurface flowing = a, flowing2 = b;
    flowing.mesh.pointVectors = flowing.mesh.normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    flowing2.mesh.pointVectors = flowing2.mesh.normals = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    const auto still = interpolated(flowing, flowing2, 0.5);
    ASSERT_TRUE(still);
    EXPECT_EQ(still->mesh.pointVectors, flowing.mesh.pointVectors);
    EXPECT_EQ(still->mesh.normals, flowing.mesh.normals);
    const auto c = interpolated(a, b, 0.5);
    ASSERT_TRUE(c);
    EXPECT_EQ(c->mesh.positions[2], glm::vec3(0, 2, 0));
    EXPECT_EQ(c->mesh.pointScalars, (std::vector<float>{0, 1, 3}));
    EXPECT_EQ(c->mesh.triangles, a.mesh.triangles);
}

TEST(Interpolate, NormalsStayOfUnitLengthEvenWhereTheyCancel)
{
    LoadedSurface a = triangle(), b = triangle();
    a.mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    b.mesh.normals = {{1, 0, 0}, {0, 0, -1}, {0, 0, 1}};
    const auto c = interpolated(a, b, 0.5);
    ASSERT_TRUE(c);
    for (const glm::vec3& n : c->mesh.normals) EXPECT_NEAR(glm::length(n), 1, 1e-6);
    EXPECT_NEAR(c->mesh.normals[0].x, std::sqrt(0.5), 1e-6);
    EXPECT_EQ(c->mesh.normals[1], glm::vec3(0, 0, 1));
}

TEST(Interpolate, NotBetweenOtherPolygonsOrArrays)
{
    const LoadedSurface a = triangle();
    LoadedSurface b = triangle();
    b.topology = 43;
    EXPECT_FALSE(interpolated(a, b, 0.5));
    b = triangle();
    b.mesh.pointScalars.clear();
    EXPECT_FALSE(interpolated(a, b, 0.5));
    b = triangle();
    b.pointIds = {0, 1, 3};
    EXPECT_FALSE(interpolated(a, b, 0.5));
    b.pointIds = {0, 1, 1};
    EXPECT_FALSE(interpolated(a, b, 0.5));
    LoadedSurface unknown = triangle();
    unknown.topology = 0;
    EXPECT_FALSE(interpolated(unknown, unknown, 0.5));
}

}  // namespace
}  // namespace aeolic
