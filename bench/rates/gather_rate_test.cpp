#include "rates/gather_rate.h"

#include <gtest/gtest.h>

#include "render_testing.h"

namespace aeolic::cpu {
namespace {

/// No build on any machine takes a microsecond for a lane, none fetches a thousand in a nanosecond: the units are
/// right.
TEST(GatherRate, IsOfTheMachinesOrderOnEverySimdTarget)
{
    testkit::forEachSimdTarget([] {
        const GatherRates rates = measureGatherRates(2, 2);
        for (const LaneRate& rate : {rates.gather, rates.blocks})
            for (const double lanesPerS : {rate.oneThread, rate.allThreads}) {
                EXPECT_GT(lanesPerS, 1e6);
                EXPECT_LT(lanesPerS, 1e12);
            }
    });
}

}  // namespace
}  // namespace aeolic::cpu
