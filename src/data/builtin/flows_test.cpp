#include "data/builtin/flows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "aeolic/error.h"

namespace aeolic {
namespace {

const Bounds teapotBox{{-3, -2, 0}, {3.434, 2, 3.15}};

void expectVector(const glm::dvec3& found, const glm::dvec3& expected, double tolerance = 1e-12)
{
    EXPECT_LT(glm::distance(found, expected), tolerance) << found.x << " " << found.y << " " << found.z;
}

/// d velocity[component] / d axis by central differences.
double slope(const char* flow, const Bounds& box, const glm::dvec3& at, int component, int axis)
{
    constexpr double h = 1e-5;
    glm::dvec3 step(0);
    step[axis] = h;
    return (builtinFlow(flow, at + step, box)[component] - builtinFlow(flow, at - step, box)[component]) / (2 * h);
}

TEST(BuiltinFlows, KnownValues)
{
    const Bounds box{{-1, -1, -1}, {1, 1, 1}};
    expectVector(builtinFlow("uniform", {0.3, -7, 2}, box), {1, 0, 0});
    expectVector(builtinFlow("rotation", {0.5, 0.25, 0.9}, box), {-0.25, 0.5, 0});
    expectVector(builtinFlow("rotation", {2, 4, 0}, {{1, 1, 1}, {3, 5, 2}}), {-1, 0, 0});
    // At the centre all sines are 0 and all cosines 1: (C, A, B).
    expectVector(builtinFlow("abc", {0, 0, 0}, box), {1, std::numbers::sqrt3, std::numbers::sqrt2});
    // A quarter period along x, a period being 2 / 1.25: (C, B + A, 0).
    expectVector(builtinFlow("abc", {0.4, 0, 0}, box), {1, std::numbers::sqrt2 + std::numbers::sqrt3, 0});
}

TEST(BuiltinFlows, AbcIsFreeOfDivergenceAndParallelToItsCurl)
{
    const double wavenumber = 2 * std::numbers::pi * 1.25 / 6.434;
    for (const glm::dvec3 at : {glm::dvec3(0, 0, 0), glm::dvec3(1.3, -0.7, 2.1), glm::dvec3(-2.9, 1.9, 0.05)}) {
        const auto d = [&](int component, int axis) { return slope("abc", teapotBox, at, component, axis); };
        EXPECT_NEAR(d(0, 0) + d(1, 1) + d(2, 2), 0, 1e-8);
        const glm::dvec3 curl(d(2, 1) - d(1, 2), d(0, 2) - d(2, 0), d(1, 0) - d(0, 1));
        expectVector(curl, wavenumber * builtinFlow("abc", at, teapotBox), 1e-8);
    }
}

TEST(BuiltinFlows, TheTornadoTurnsAboutACoreThatWanders)
{
    const Bounds box{{-1, -1, 0}, {1, 1, 2}};
    double firstCoreX = 0;
    for (const double height : {0.0, 0.3, 1.1}) {
        const double turn = std::numbers::pi * height;
        const glm::dvec3 core(0.25 * std::sin(1.3 * turn), 0.2 * std::cos(turn), height);
        const glm::dvec3 inCore = builtinFlow("tornado", core, box);
        expectVector(inCore, {0, 0, 1.5});
        for (int i = 0; i < 8; ++i) {
            const double angle = i * std::numbers::pi / 4;
            const glm::dvec3 out(std::cos(angle), std::sin(angle), 0), along(-out.y, out.x, 0);
            const glm::dvec3 v = builtinFlow("tornado", core + 0.4 * out, box);
            EXPECT_GT(glm::dot(v, along), 0) << "counter-clockwise";
            EXPECT_LT(glm::dot(v, out), 0) << "inwards";
            EXPECT_GT(v.z, 0) << "upwards";
            EXPECT_LT(v.z, inCore.z);
        }
        if (height > 0) {
            EXPECT_GT(std::abs(core.x - firstCoreX), 0.05);
        } else {
            firstCoreX = core.x;
        }
    }
}

TEST(BuiltinFlows, TheGridSpansTheBoundsAndHoldsTheFlow)
{
    for (const std::string name : {"abc", "tornado", "rotation", "uniform"}) {
        SCOPED_TRACE(name);
        const auto grid = makeBuiltinFlow(name + ":7,5,9", teapotBox);
        ASSERT_EQ(grid->dims, (std::array<std::int64_t, 3>{7, 5, 9}));
        EXPECT_EQ(grid->components, 3);
        EXPECT_EQ(grid->precision, FieldPrecision::float32);
        EXPECT_EQ(grid->name, name);
        EXPECT_EQ(grid->originWorld, teapotBox.lo);
        expectVector(grid->originWorld + grid->spacingWorld * glm::dvec3(6, 4, 8), teapotBox.hi);
        double largest = 0;
        for (int z = 0; z < 9; ++z) {
            for (int y = 0; y < 5; ++y) {
                for (int x = 0; x < 7; ++x) {
                    const float* const s = grid->floats() + ((z * 5 + y) * 7 + x) * 3;
                    const glm::dvec3 stored(s[0], s[1], s[2]);
                    const glm::dvec3 at = grid->originWorld + grid->spacingWorld * glm::dvec3(x, y, z);
                    expectVector(stored, builtinFlow(name, at, teapotBox), 1e-5);
                    largest = std::max(largest, glm::length(stored));
                }
            }
        }
        EXPECT_NEAR(grid->maxMagnitude, largest, 1e-12);
        EXPECT_GE(grid->maxMagnitude, largest);
    }
}

TEST(BuiltinFlows, TheDefaultGridHas128SamplesEachWay)
{
    const auto grid = makeBuiltinFlow("uniform", teapotBox);
    EXPECT_EQ(grid->dims, (std::array<std::int64_t, 3>{128, 128, 128}));
    EXPECT_EQ(grid->maxMagnitude, 1);
}

TEST(BuiltinFlows, AFlatSurfaceGetsAThinGridAroundIt)
{
    const auto grid = makeBuiltinFlow("tornado:4,4,3", {{-1, -1, 5}, {1, 1, 5}});
    EXPECT_GT(grid->spacingWorld.z, 0);
    EXPECT_NEAR(grid->originWorld.z + grid->spacingWorld.z, 5, 1e-12) << "the surface lies in the middle";
    EXPECT_NEAR(2 * grid->spacingWorld.z, 2e-3, 1e-12);
    const auto point = makeBuiltinFlow("abc:2,2,2", {{1, 2, 3}, {1, 2, 3}});
    EXPECT_EQ(point->spacingWorld, glm::dvec3(1));
    EXPECT_TRUE(std::isfinite(point->maxMagnitude));
}

TEST(BuiltinFlows, NamesAreRecognisedByThePartBeforeTheColon)
{
    EXPECT_TRUE(isBuiltinFlow("abc"));
    EXPECT_TRUE(isBuiltinFlow("tornado:64,64,64"));
    EXPECT_TRUE(isBuiltinFlow("uniform:nonsense"));
    EXPECT_FALSE(isBuiltinFlow("abc.vti"));
    EXPECT_FALSE(isBuiltinFlow(""));
}

TEST(BuiltinFlows, BadSpecsAreRefusedWithOneLineThatNamesThem)
{
    for (const std::string spec : {"vortex", "", "abc:", "abc:64", "abc:64,64", "abc:64,64,64,64", "abc:64,64,1",
                                   "abc:0,64,64", "abc:-4,64,64", "abc:64,4097,64", "abc:a,b,c", "abc:64;64;64",
                                   "abc:64,64,64 ", "abc:64.5,64,64", "abc:99999999999999999999,2,2"}) {
        SCOPED_TRACE(spec);
        try {
            makeBuiltinFlow(spec, teapotBox);
            FAIL() << "accepted";
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()).find("--field: '" + spec + "'; expected "), 0u) << error.what();
        }
    }
    EXPECT_THROW(builtinFlow("vortex", {0, 0, 0}, teapotBox), InputError);
}

TEST(BuiltinFlows, AGridThatNoMachineHoldsIsRefusedBeforeItIsAllocated)
{
    try {
        makeBuiltinFlow("abc:4096,4096,4096", teapotBox);  // 768 GiB.
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("768.0 GiB"), std::string::npos) << error.what();
    }
}

TEST(BuiltinFlows, BoundsWithoutAnInsideAreAProgrammingError)
{
    EXPECT_THROW(makeBuiltinFlow("abc", Bounds{}), std::invalid_argument);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(makeBuiltinFlow("abc", Bounds{{0, 0, nan}, {1, 1, nan}}), std::invalid_argument);
}

/// The double gyre on its own [0, 2] x [0, 1]: shadden2005lcs.
TEST(BuiltinFlows, TheGyreSwaysWithAPeriodOfTen)
{
    const Bounds box{{0, 0, -1}, {2, 1, 1}};
    const double speed = std::numbers::pi * 0.1;
    for (const double time : {0.0, 5.0, 10.0, -5.0}) {  // f = x: the border stands in the middle, x = 1.
        expectVector(builtinFlow("gyre", {1, 0.5, 0.3}, box, time), {0, -speed, 0});
        expectVector(builtinFlow("gyre", {0.5, 0.5, 0}, box, time), {0, 0, 0});
        expectVector(builtinFlow("gyre", {0.5, 0, 0}, box, time), {-speed, 0, 0});
        expectVector(builtinFlow("gyre", {0.5, 1, 0}, box, time), {speed, 0, 0});
    }
    // At a quarter of the period f = x^2 / 4 + x / 2, and f = 1 at x = sqrt 5 - 1, where df/dx = sqrt(5) / 2.
    const double border = std::sqrt(5.0) - 1;
    expectVector(builtinFlow("gyre", {border, 0.5, 0}, box, 2.5), {0, -speed * std::sqrt(5.0) / 2, 0});
    expectVector(builtinFlow("gyre", {border, 0.5, 0}, box, 1002.5), {0, -speed * std::sqrt(5.0) / 2, 0}, 1e-11);
    // It never leaves the box, and does not change its volume.
    for (const double time : {0.7, 3.1}) {
        EXPECT_NEAR(builtinFlow("gyre", {0, 0.3, 0}, box, time).x, 0, 1e-15);
        EXPECT_NEAR(builtinFlow("gyre", {2, 0.3, 0}, box, time).x, 0, 1e-15);
        EXPECT_NEAR(builtinFlow("gyre", {0.3, 1, 0}, box, time).y, 0, 1e-15);
        const auto d = [&](int c, const glm::dvec3& h) {
            const glm::dvec3 at(1.3, 0.4, 0);
            return (builtinFlow("gyre", at + h, box, time)[c] - builtinFlow("gyre", at - h, box, time)[c]) / 2e-5;
        };
        EXPECT_NEAR(d(0, {1e-5, 0, 0}) + d(1, {0, 1e-5, 0}), 0, 1e-8);
    }
}

TEST(BuiltinFlows, TheGyreIsStretchedWithItsBox)
{
    const Bounds box{{-1, -1, -1}, {1, 1, 1}};  // As long along x, twice as long along y.
    expectVector(builtinFlow("gyre", {0, 0, 0}, box), {0, -2 * std::numbers::pi * 0.1, 0});
    const auto grid = makeBuiltinFlow("gyre:3,3,2", box, {}, 2.5);
    const glm::dvec3 expected = builtinFlow("gyre", {0, 1, 1}, box, 2.5);
    const float* last = grid->floats() + 3 * ((1 * 3 + 2) * 3 + 1);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(last[c], float(expected[c]));
}

TEST(BuiltinFlows, OnlyTheGyreChangesInTime)
{
    EXPECT_EQ(builtinFlowTimes("gyre:4,4,4").front(), 0);
    EXPECT_EQ(builtinFlowTimes("gyre").back(), 10);
    for (const char* name : {"abc", "tornado", "rotation", "uniform"}) {
        EXPECT_TRUE(builtinFlowTimes(name).empty());
        const Bounds box{{-1, -1, -1}, {1, 1, 1}};
        expectVector(builtinFlow(name, {0.1, 0.2, 0.3}, box, 7), builtinFlow(name, {0.1, 0.2, 0.3}, box), 0.0 + 1e-300);
    }
}

}  // namespace
}  // namespace aeolic
