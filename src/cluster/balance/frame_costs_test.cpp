#include "cluster/balance/frame_costs.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

LicOptions licOf(LicMethod method, int steps, Integrator integrator = Integrator::rk2)
{
    LicOptions lic;
    lic.method = method;
    lic.steps = steps;
    lic.integrator = integrator;
    return lic;
}

/// So slow that a message costs more than any computing.
constexpr NetworkModel kCarrierPigeon{10, 1e9};

TEST(FrameCosts, DirectStepsCostInProportionAndByLookups)
{
    const double rk2 = frameCosts(licOf(LicMethod::direct, 100)).convolveNs;
    EXPECT_GT(rk2, 0);
    EXPECT_DOUBLE_EQ(frameCosts(licOf(LicMethod::direct, 200)).convolveNs, 2 * rk2);
    EXPECT_DOUBLE_EQ(frameCosts(licOf(LicMethod::direct, 100, Integrator::euler)).convolveNs, rk2 / 2);
    EXPECT_DOUBLE_EQ(frameCosts(licOf(LicMethod::direct, 100, Integrator::rk4)).convolveNs, 2 * rk2);
    EXPECT_EQ(frameCosts(licOf(LicMethod::none, 100)).convolveNs, 0);
}

TEST(FrameCosts, DoublingTheLengthAddsTheSameToTheHierarchicalMethod)
{
    const auto costOf = [](int steps) { return frameCosts(licOf(LicMethod::hierarchical, steps)).convolveNs; };
    EXPECT_DOUBLE_EQ(costOf(256) - costOf(128), costOf(1024) - costOf(512));
    EXPECT_GT(costOf(256), costOf(128));
    EXPECT_GT(costOf(1), 0);
    EXPECT_LT(costOf(1024), frameCosts(licOf(LicMethod::direct, 1024)).convolveNs / 10);
}

TEST(FrameCosts, ReceivingTakesTheBytesOverTheNetwork)
{
    const NetworkModel slow{1e6, 0};
    const double direct = frameCosts(licOf(LicMethod::direct, 64), slow).receiveNs,
                 hierarchical = frameCosts(licOf(LicMethod::hierarchical, 64), slow).receiveNs;
    EXPECT_NEAR(direct, 5 * 1000, 1) << "flow and links, a microsecond a byte";
    EXPECT_GT(hierarchical, direct + 16 * 1000) << "and levels of jumps";
}

TEST(CheaperGuard, WithoutGuardRowsThereIsNothingToReceive)
{
    EXPECT_EQ(cheaperGuard({}, licOf(LicMethod::none, 1), 800, 0, 6), GuardSource::project);
}

TEST(CheaperGuard, LevelsOfJumpsAreReceivedOverAFastNetworkAndDrawnAgainOverASlowOne)
{
    const LicOptions lic = licOf(LicMethod::hierarchical, 128);
    EXPECT_EQ(cheaperGuard(frameCosts(lic), lic, 800, 140, 8), GuardSource::receive);
    EXPECT_EQ(cheaperGuard(frameCosts(lic, kCarrierPigeon), lic, 800, 140, 8, kCarrierPigeon), GuardSource::project);
}

TEST(CheaperGuard, AFewRowsAreNotWorthAMessage)
{
    const LicOptions lic = licOf(LicMethod::hierarchical, 8);
    const NetworkModel faraway{12.5e9, 1000};
    EXPECT_EQ(cheaperGuard(frameCosts(lic, faraway), lic, 100, 1, 8, faraway), GuardSource::project);
    EXPECT_EQ(cheaperGuard(frameCosts(lic, faraway), lic, 8000, 1000, 8, faraway), GuardSource::receive);
}

TEST(CheaperShared, ManyTrianglesAreCountedInPartsAndFewOverASlowNetworkByEveryone)
{
    EXPECT_TRUE(cheaperShared(25000, 4000, 8));
    EXPECT_TRUE(cheaperShared(1000000, 4000, 1000));
    EXPECT_FALSE(cheaperShared(100, 4000, 8));
    EXPECT_FALSE(cheaperShared(25000, 4000, 8, kCarrierPigeon));
    EXPECT_FALSE(cheaperShared(25000, 1000000, 1024)) << "ten megabytes for a quarter of a millisecond";
    EXPECT_FALSE(cheaperShared(0, 0, 1));
}

TEST(StripeCosts, AreInUnitsOfAPixelAndAGuardPixelCostsLess)
{
    for (const LicMethod method : {LicMethod::none, LicMethod::direct, LicMethod::hierarchical})
        for (const GuardSource source : {GuardSource::project, GuardSource::receive})
            for (const int steps : {1, 128, 65536}) {
                const LicOptions lic = licOf(method, steps);
                const StripeCosts costs = stripeCosts(frameCosts(lic), lic, source, 800, 37);
                EXPECT_EQ(costs.guardRows, 37);
                EXPECT_GE(costs.guardPixel, 0);
                EXPECT_LE(costs.guardPixel, 1);
                EXPECT_GE(costs.row, 0);
                EXPECT_LT(costs.row, 800) << "an empty row costs less than a covered one";
            }
}

TEST(StripeCosts, WhatIsReceivedCostsByItsPart)
{
    const LicOptions lic = licOf(LicMethod::hierarchical, 128);
    const auto guardPixel = [&](GuardSource source, const NetworkModel& network, double part) {
        return stripeCosts(frameCosts(lic, network), lic, source, 800, 9, part).guardPixel;
    };
    const double whole = guardPixel(GuardSource::receive, {}, 1);
    EXPECT_GT(whole, 0);
    EXPECT_DOUBLE_EQ(guardPixel(GuardSource::receive, {}, 0.25), whole / 4);
    EXPECT_DOUBLE_EQ(guardPixel(GuardSource::receive, kCarrierPigeon, 1), whole) << "nobody is busy with the network";
    EXPECT_EQ(guardPixel(GuardSource::project, {}, 0.25), guardPixel(GuardSource::project, {}, 1));
}

TEST(StripeCosts, ARunCostsTheHierarchicalMethodMore)
{
    const auto run = [](LicMethod method) {
        const LicOptions lic = licOf(method, 128);
        return stripeCosts(frameCosts(lic), lic, GuardSource::receive, 800, 9).run;
    };
    EXPECT_DOUBLE_EQ(run(LicMethod::hierarchical), run(LicMethod::none)) << "both by whole pixels";
    EXPECT_LT(run(LicMethod::direct), 1);
    EXPECT_GT(run(LicMethod::direct), 0);
}

/// The direct method only projects guards again; of the hierarchical one levels have to be computed there as well.
TEST(StripeCosts, AGuardDrawnAgainCostsTheHierarchicalMethodNearlyAWholePixel)
{
    const LicOptions direct = licOf(LicMethod::direct, 128), hierarchical = licOf(LicMethod::hierarchical, 128);
    EXPECT_LT(stripeCosts(frameCosts(direct), direct, GuardSource::project, 800, 9).guardPixel, 0.1);
    EXPECT_GT(stripeCosts(frameCosts(hierarchical), hierarchical, GuardSource::project, 800, 9).guardPixel, 0.9);
    EXPECT_LT(stripeCosts(frameCosts(hierarchical), hierarchical, GuardSource::receive, 800, 9).guardPixel, 0.1);
}

}  // namespace
}  // namespace aeolic
