#include "stream/gateway/hub/pace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace aeolic::stream {
namespace {

constexpr double kPixels = 800 * 800;

/// A machine and a line: what a frame of that scale and quality takes on them.
struct World {
    double drawMsFull = 0;       ///< For a picture of full size.
    double fixedMs = 0;          ///< For any frame, however small.
    double bytesPerMs = 1e6;     ///< What the line carries.
    double bytesPerPixel = 0.2;  ///< At quality 80.
    double latencyMs = 1;

    FrameTiming frame(const Pace& pace) const
    {
        const double share = pace.scale() * pace.scale();
        const double bytes = kPixels * share * bytesPerPixel * pace.quality() / 80;
        return {fixedMs + drawMsFull * share, latencyMs + bytes / bytesPerMs, bytes, true};
    }
};

void run(Pace& pace, const World& world, int frames)
{
    for (int i = 0; i < frames; ++i) pace.add(world.frame(pace));
}

/// How often scale or quality change within so many frames.
int changes(Pace& pace, const World& world, int frames)
{
    int count = 0;
    for (int i = 0; i < frames; ++i) {
        const double scale = pace.scale();
        const int quality = pace.quality();
        pace.add(world.frame(pace));
        count += scale != pace.scale() || quality != pace.quality();
    }
    return count;
}

TEST(Pace, AQuickMachineOnAQuickLineGetsFullPictures)
{
    Pace pace;
    run(pace, {.drawMsFull = 30}, 500);
    EXPECT_EQ(pace.scale(), 1);
    EXPECT_EQ(pace.quality(), 80);
}

TEST(Pace, SlowDrawingMakesPicturesSmallerNotWorse)
{
    Pace pace;
    run(pace, {.drawMsFull = 120}, 50);
    EXPECT_EQ(pace.scale(), 0.5) << "120 ms at full size are 30 ms at half of it";
    EXPECT_EQ(pace.quality(), 80);
}

TEST(Pace, ASlowLineMakesPicturesWorseFirstThenSmaller)
{
    const World slow{.drawMsFull = 10, .bytesPerMs = 1250};  // 10 Mbit/s; a full picture of quality 80 takes 102 ms.
    Pace pace;
    pace.add(slow.frame(pace));
    EXPECT_LT(pace.quality(), 80);
    EXPECT_EQ(pace.scale(), 1);
    run(pace, slow, 50);
    EXPECT_EQ(pace.quality(), 40);
    EXPECT_LT(pace.scale(), 1);
    EXPECT_LE(slow.frame(pace).showMs, Pace::targetMs);
}

TEST(Pace, WhatIsTooSlowAtAnySizeEndsAtTheSmallest)
{
    Pace pace;
    run(pace, {.drawMsFull = 5000, .fixedMs = 500}, 100);
    EXPECT_EQ(pace.scale(), 0.25);
    EXPECT_EQ(pace.quality(), 80) << "packing worse would not help";
}

TEST(Pace, FindsASizeAndStaysThere)
{
    for (double drawMs = 20; drawMs < 800; drawMs *= 1.1)
        for (const double fixedMs : {0.0, 8.0, 25.0})
            for (const double bytesPerMs : {1e6, 5000.0, 1250.0}) {
                const World world{.drawMsFull = drawMs, .fixedMs = fixedMs, .bytesPerMs = bytesPerMs};
                Pace pace;
                run(pace, world, 100);
                // One look at the next larger size in a few seconds may be; going to and fro is not.
                EXPECT_LE(changes(pace, world, 240), 4)
                    << drawMs << " ms, " << fixedMs << " ms fixed, " << bytesPerMs << " bytes/ms, scale "
                    << pace.scale() << " quality " << pace.quality();
            }
}

TEST(Pace, ComesBackWhenTheLoadHasGone)
{
    Pace pace;
    run(pace, {.drawMsFull = 500, .bytesPerMs = 1250}, 100);
    EXPECT_LT(pace.scale(), 1);
    run(pace, {.drawMsFull = 10}, 6 * 12);
    EXPECT_EQ(pace.scale(), 1) << "within three seconds";
    EXPECT_EQ(pace.quality(), 80);
}

TEST(Pace, OneHiccupCostsOneStepForAMoment)
{
    Pace pace;
    run(pace, {.drawMsFull = 20}, 20);
    pace.add({.drawMs = 400, .showMs = 1, .bytes = 1e5, .moving = true});
    EXPECT_EQ(pace.scale(), 0.75);
    run(pace, {.drawMsFull = 20}, 10);
    EXPECT_EQ(pace.scale(), 1);
}

/// Quick frames before a hiccup say nothing about those after it.
TEST(Pace, CalmIsCountedAnewAfterEveryHiccup)
{
    constexpr FrameTiming hiccup{.drawMs = 1, .showMs = 400, .bytes = 1e4, .moving = true};
    const auto framesToGrow = [](Pace& pace) {
        const int quality = pace.quality();
        int frames = 0;
        for (; pace.quality() == quality && frames < 1000; ++frames) run(pace, {.drawMsFull = 20}, 1);
        return frames;
    };
    Pace once;
    run(once, {.drawMsFull = 20}, 20);
    once.add(hiccup);
    const int needed = framesToGrow(once);
    ASSERT_GE(needed, 4);
    Pace twice;
    run(twice, {.drawMsFull = 20}, 20);
    twice.add(hiccup);
    run(twice, {.drawMsFull = 20}, needed - 1);
    EXPECT_EQ(twice.quality(), 70);
    twice.add(hiccup);
    EXPECT_EQ(twice.quality(), 60);
    EXPECT_GE(framesToGrow(twice), needed);
}

/// Growing in vain makes the next try wait. That is over once full pictures have been quick for long.
TEST(Pace, OldFailuresAreForgotten)
{
    Pace pace;
    for (int i = 0; i < 3000; ++i)  // Full pictures take longer than smaller ones promise.
        run(pace, {.fixedMs = pace.scale() == 1 ? 60.0 : 15.0}, 1);
    run(pace, {.drawMsFull = 20}, 1000);
    ASSERT_EQ(pace.scale(), 1);
    pace.add({.drawMs = 400, .showMs = 1, .bytes = 1e5, .moving = true});
    EXPECT_EQ(pace.scale(), 0.75);
    run(pace, {.drawMsFull = 20}, 10);
    EXPECT_EQ(pace.scale(), 1);
}

TEST(Pace, PicturesAtRestSayNothingAboutMoving)
{
    Pace pace;
    for (int i = 0; i < 50; ++i) pace.add({.drawMs = 900, .showMs = 900, .bytes = 1e6});
    EXPECT_EQ(pace.scale(), 1);
    EXPECT_EQ(pace.quality(), 80);
}

TEST(Pace, PacksFastOnAFastLineAndSmallOnASlowOne)
{
    Pace unknown;
    EXPECT_EQ(unknown.lossless(true), Codec::png) << "nothing is known of the line";
    Pace fast;
    for (int i = 0; i < 10; ++i) fast.add({.drawMs = 30, .showMs = 5, .bytes = 1e6});
    EXPECT_EQ(fast.lossless(true), Codec::lz4);
    EXPECT_EQ(fast.lossless(false), Codec::png) << "the viewer cannot";
    Pace slow;
    for (int i = 0; i < 10; ++i) slow.add({.drawMs = 30, .showMs = 800, .bytes = 1e6});
    EXPECT_EQ(slow.lossless(true), Codec::png);
    for (int i = 0; i < 1000; ++i) fast.add({.drawMs = 30, .showMs = 100, .bytes = 2000});
    EXPECT_EQ(fast.lossless(true), Codec::lz4) << "small pictures say little about the line";
}

TEST(Pace, AClockThatStandsStillOrGoesBackDoesNoHarm)
{
    Pace pace;
    for (int i = 0; i < 100; ++i) {
        pace.add({.drawMs = 0, .showMs = 0, .bytes = 1e6, .moving = true});
        pace.add({.drawMs = -5, .showMs = -5, .bytes = 1e6, .moving = true});
    }
    EXPECT_EQ(pace.scale(), 1);
    EXPECT_EQ(pace.quality(), 80);
}

}  // namespace
}  // namespace aeolic::stream
