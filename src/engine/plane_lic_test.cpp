#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <future>
#include <limits>
#include <random>
#include <stop_token>
#include <thread>

#include "aeolic/error.h"
#include "aeolic/plane.h"
#include "engine/testing/plane_testing.h"
#include "reference/reference.h"

namespace aeolic {
namespace {

using namespace testkit;

/// The mean of value(x, y) * value(x + dx, y + dy), where both are in the plane.
double alike(const Plane& plane, const std::vector<float>& values, int dx, int dy)
{
    double sum = 0;
    int count = 0;
    for (int y = 0; y + dy < plane.height; ++y)
        for (int x = 0; x + dx < plane.width; ++x, ++count)
            sum += double(values[std::size_t(y * plane.width + x)]) *
                   double(values[std::size_t((y + dy) * plane.width + x + dx)]);
    return sum / count;
}

TEST(PlaneLic, StreaksFollowUniformFlow)
{
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        const Plane right(200, 150, 3, 0), down(200, 150, 0, 0.001F);
        const auto along = licOfPlane(right.flow(), options(method, 20));
        const auto across = licOfPlane(down.flow(), options(method, 20));
        const double alongVariance = alike(right, along, 0, 0), acrossVariance = alike(down, across, 0, 0);
        EXPECT_NEAR(alongVariance, 1, 0.5);
        EXPECT_GT(alike(right, along, 8, 0), 0.6 * alongVariance);
        EXPECT_LT(std::abs(alike(right, along, 0, 8)), 0.2 * alongVariance);
        EXPECT_GT(alike(down, across, 0, 8), 0.6 * acrossVariance);
        EXPECT_LT(std::abs(alike(down, across, 8, 0)), 0.2 * acrossVariance);
    }
}

TEST(PlaneLic, OwnTextureIsSmearedAlongTheFlowAlone)
{
    Plane plane(60, 40, 1, 0);
    plane.texture.assign(plane.pixels(), 5);
    for (int x = 0; x < 60; ++x) plane.texture[std::size_t(20 * 60 + x)] = 9;  // A bright row along the flow.
    const auto values = licOfPlane(plane.flow(), options(LicMethod::direct, 10));
    for (int x = 0; x < 60; ++x) {
        EXPECT_GT(values[std::size_t(20 * 60 + x)], 0.9F);
        EXPECT_LT(values[std::size_t(18 * 60 + x)], -0.9F);
    }
    plane.texture[0] = nan;  // The middle of the texture's span.
    EXPECT_GT(licOfPlane(plane.flow(), options(LicMethod::direct, 10))[0], values[0]);
    plane.texture.assign(plane.pixels(), 5);
    for (const float value : licOfPlane(plane.flow(), options(LicMethod::direct, 10))) EXPECT_NEAR(value, 0, 1e-6);
}

TEST(PlaneLic, NothingCrossesLand)
{
    Plane plane(61, 21, 1, 0);
    for (int y = 0; y < 21; ++y) plane.u[std::size_t(y * 61 + 30)] = nan;
    Plane other = plane;
    plane.texture.assign(plane.pixels(), 0);
    for (std::size_t i = 0; i < plane.pixels(); ++i) plane.texture[i] = float(i * 7919 % 101);
    other.texture = plane.texture;
    for (int y = 0; y < 21; ++y)  // All that is beyond the land.
        for (int x = 31; x < 61; ++x) other.texture[std::size_t(y * 61 + x)] = float((x + y) % 101);
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        const auto a = licOfPlane(plane.flow(), options(method, 40)), b = licOfPlane(other.flow(), options(method, 40));
        bool differs = false;
        for (int y = 0; y < 21; ++y)
            for (int x = 0; x < 61; ++x) {
                const auto i = std::size_t(y * 61 + x);
                EXPECT_EQ(std::isnan(a[i]), x == 30);
                if (x < 30) {
                    EXPECT_EQ(a[i], b[i]) << x << "," << y;
                }
                if (x > 30) differs |= a[i] != b[i];
            }
        EXPECT_TRUE(differs);
    }
}

TEST(PlaneLic, PeriodicPlanesHaveNoEnds)
{
    Plane plane(50, 30, 2, 1);
    plane.periodic = true;
    for (std::size_t i = 0; i < plane.pixels(); ++i) plane.texture.push_back(float(i * 7919 % 101));
    Plane turned = plane;  // The same plane, begun elsewhere.
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 50; ++x)
            turned.texture[std::size_t(y * 50 + x)] = plane.texture[std::size_t((y + 11) % 30 * 50 + (x + 17) % 50)];
    const LicOptions lic = options(LicMethod::direct, 70);  // Farther than it is wide.
    const auto a = licOfPlane(plane.flow(), lic), b = licOfPlane(turned.flow(), lic);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 50; ++x)
            EXPECT_NEAR(b[std::size_t(y * 50 + x)], a[std::size_t((y + 11) % 30 * 50 + (x + 17) % 50)], 2e-3);
    plane.periodic = false;
    EXPECT_NE(licOfPlane(plane.flow(), lic), a);
}

/// The plane is small, and its border is not.
TEST(PlaneLic, PeriodicStreaksThatNoMemoryHoldsAreNamed)
{
    Plane plane(64, 48, 1, 0);
    plane.periodic = true;
    LicOptions lic = options(LicMethod::hierarchical, 65536);
    lic.step = 8;
    try {
        licOfPlane(plane.flow(), lic);
        FAIL();
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.rfind("lic2d: steps=65536 of step=8 with boundary=\"periodic\" need ", 0), 0u) << message;
        EXPECT_NE(message.find(" pixels with the border, and "), std::string::npos) << message;
        EXPECT_NE(message.find("; expected at most "), std::string::npos) << message;
    }
    plane.periodic = false;
    EXPECT_EQ(licOfPlane(plane.flow(), lic).size(), plane.pixels());
}

TEST(PlaneLic, WhatIsAskedToStopWritesNoMore)
{
    const Plane plane(300, 200, 1, 0.3F);
    const float before = -7;
    std::vector<float> values(plane.pixels(), before);
    std::stop_source stop;
    stop.request_stop();
    licOfPlane(plane.flow(), options(LicMethod::hierarchical, 40), values.data(), stop.get_token());
    EXPECT_EQ(std::count(values.begin(), values.end(), before), std::ptrdiff_t(plane.pixels()));
    std::stop_source none;
    licOfPlane(plane.flow(), options(LicMethod::hierarchical, 40), values.data(), none.get_token());
    EXPECT_EQ(values, licOfPlane(plane.flow(), options(LicMethod::hierarchical, 40)));
}

TEST(PlaneLic, StopsWhileItIsAtWork)
{
    const Plane plane(1000, 1000, 1, 0.3F);
    const float before = -7;
    std::vector<float> values(plane.pixels(), before);
    std::stop_source stop;
    const auto asked = std::async(std::launch::async, [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        stop.request_stop();
    });
    licOfPlane(plane.flow(), options(LicMethod::direct, 65536), values.data(), stop.get_token());  // Else minutes.
    EXPECT_EQ(values.back(), before);
}

/// The reference's picture of a plane, of numbers as they are given.
reference::PixelImage imageOf(const Plane& plane, double stepPx)
{
    reference::PixelImage image(plane.width, plane.height);
    for (std::size_t i = 0; i < plane.pixels(); ++i) {
        const double u = double(plane.u[i]), v = double(plane.v[i]), length = std::hypot(u, v);
        if (!std::isfinite(length)) continue;
        image.pixels[i].hasFlow = true;
        image.pixels[i].vx = u / length * stepPx;
        image.pixels[i].vy = v / length * stepPx;
        image.pixels[i].noise = double(plane.texture[i]);
    }
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x)
            for (int sy = -1; sy <= 1; ++sy)
                for (int sx = -1; sx <= 1; ++sx)
                    image.at(x, y).linked[std::size_t((sy + 1) * 3 + sx + 1)] =
                        image.at(x, y).hasFlow && image.contains(x + sx, y + sy) && image.at(x + sx, y + sy).hasFlow;
    return image;
}

/// Values have a deviation of about 1. Vectors are kept as 32768ths of a step. More than that differs where a
/// streamline ends in one of the two alone, or where flow that parts takes them to two sides.
TEST(PlaneLic, HasTheReferencesValues)
{
    struct Case {
        double size, within;  // Of eddies; the share of the pixels that are within a thousandth.
    };
    for (const Case& each : {Case{1, 0.97}, Case{4, 0.996}, Case{16, 0.997}}) {
        const Plane plane = eddies(300, 220, each.size);
        const reference::PixelImage image = imageOf(plane, 1);
        for (const int steps : {8, 24, 64}) {
            const LicOptions lic = options(LicMethod::direct, steps);
            const auto values = licOfPlane(plane.flow(), lic);
            const auto expected = reference::smooth(image, reference::convolve(image, lic), lic);
            std::vector<double> off;
            for (std::size_t i = 0; i < values.size(); ++i)
                if (image.pixels[i].hasFlow) off.push_back(std::abs(double(values[i]) - expected[i]));
            std::sort(off.begin(), off.end());
            const auto within = std::lower_bound(off.begin(), off.end(), 0.001) - off.begin();
            EXPECT_GT(double(within), each.within * double(off.size())) << each.size << ", " << steps;
            EXPECT_LT(off[off.size() / 2], 0.00015) << each.size << ", " << steps;
        }
    }
}

/// Large planes go through in parts. A part's rows are those of the same rows in a plane that begins and ends
/// elsewhere.
TEST(PlaneLic, PartsAreSeenNowhere)
{
    const int width = 40, height = 2600, from = 150, rows = 2350, away = 60;
    Plane whole = eddies(width, height);
    for (std::size_t i = 0; i < whole.pixels(); ++i) whole.v[i] = std::abs(whole.v[i]) + 1;  // Mostly down.
    // Land everywhere, and rows of land alone. Below them flow begins again, and so do the pixels near flow.
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (y % 97 < 14 || (x - y % 40) * (x - y % 40) < 4) whole.u[std::size_t(y * width + x)] = nan;
    Plane part(width, rows, 0, 0);
    const auto begin = std::size_t(from * width);
    for (std::size_t i = 0; i < part.pixels(); ++i) {
        part.u[i] = whole.u[begin + i];
        part.v[i] = whole.v[begin + i];
        part.texture.push_back(whole.texture[begin + i]);
    }
    part.texture[0] = -1;
    part.texture[1] = 1;
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        const auto a = licOfPlane(whole.flow(), options(method, 40)), b = licOfPlane(part.flow(), options(method, 40));
        int differ = 0;
        for (int y = away; y < rows - away; ++y)
            differ +=
                std::memcmp(&a[begin + std::size_t(y * width)], &b[std::size_t(y * width)], width * sizeof(float)) != 0;
        EXPECT_EQ(differ, 0) << int(method);
        EXPECT_NE(std::memcmp(&a[begin], b.data(), width * sizeof(float)), 0) << "the upper end is another";
    }
}

/// Nor is where a periodic plane begins, however the window lies.
TEST(PlaneLic, PartsOfPeriodicPlanesAreSeenNowhere)
{
    const int width = 40, height = 1300, by = 517;
    Plane plane = eddies(width, height), turned = plane;
    plane.periodic = turned.periodic = true;
    for (int y = 0; y < height; ++y) {
        const auto row = std::size_t(y * width), there = std::size_t((y + by) % height * width);
        std::copy_n(&plane.u[there], width, &turned.u[row]);
        std::copy_n(&plane.v[there], width, &turned.v[row]);
        std::copy_n(&plane.texture[there], width, &turned.texture[row]);
    }
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical})
        for (const int steps : {5, 40, 250}) {
            LicOptions lic = options(method, steps);
            if (method == LicMethod::hierarchical) lic.kernel = Kernel::hann;
            const auto a = licOfPlane(plane.flow(), lic), b = licOfPlane(turned.flow(), lic);
            int differ = 0;
            for (int y = 0; y < height; ++y)
                differ += std::memcmp(&a[std::size_t((y + by) % height * width)], &b[std::size_t(y * width)],
                                      width * sizeof(float)) != 0;
            EXPECT_EQ(differ, 0) << int(method) << ", " << steps;
        }
}

/// Slopes along the flow are skewed: a streak rises slowly and ends at its head, whichever way the flow goes.
TEST(PlaneLic, OrientedStreaksRiseTowardsTheirHeads)
{
    constexpr int side = 300;
    for (const float sign : {1.0F, -1.0F})
        for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
            LicOptions lic = options(method, 128);
            lic.style = Style::oriented;
            const std::vector<float> values = licOfPlane(Plane(side, side, sign, 0).flow(), lic);
            double skew = 0;
            for (int y = 0; y < side; ++y)
                for (int x = 60; x + 60 < side; ++x) {
                    const auto at = std::size_t(y * side + x);
                    const double slope = double(values[at + 1]) - double(values[at - 1]);
                    skew += slope * slope * slope;
                }
            EXPECT_LT(skew * double(sign), -100) << sign << ", " << int(method);
        }
    Plane axial(9, 9, 1, 0);
    axial.axial = true;
    LicOptions lic = options(LicMethod::direct, 16);
    lic.style = Style::oriented;
    EXPECT_THROW(licOfPlane(axial.flow(), lic), InputError);
}

TEST(PlaneLic, TakesThePlanesNobodyDraws)
{
    const Plane one(1, 1, 1, 1), still(9, 9, 0, 0), land(5, 4, nan, 0), huge(8, 8, 3e38F, -3e38F);
    EXPECT_TRUE(std::isfinite(licOfPlane(one.flow(), {})[0]));
    for (const float value : licOfPlane(still.flow(), {})) EXPECT_TRUE(std::isfinite(value));
    for (const float value : licOfPlane(land.flow(), {})) EXPECT_TRUE(std::isnan(value));
    for (const float value : licOfPlane(huge.flow(), {})) EXPECT_TRUE(std::isfinite(value));
    LicOptions slow = options(LicMethod::direct, 10);
    slow.normalize = false;
    slow.step = 8;  // Is walked in parts.
    for (const float value : licOfPlane(huge.flow(), slow)) EXPECT_TRUE(std::isfinite(value));
    EXPECT_THROW(licOfPlane(Plane(0, 3, 1, 1).flow(), {}), InputError);
    EXPECT_THROW(licOfPlane(one.flow(), options(LicMethod::direct, 0)), InputError);
    EXPECT_THROW(licOfPlane(one.flow(), {}, nullptr), InputError);
    PlaneFlow nothing = one.flow();
    nothing.v = nullptr;
    EXPECT_THROW(licOfPlane(nothing, {}), InputError);
}

}  // namespace
}  // namespace aeolic
