#include "data/tally.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

using Lines = std::vector<std::string>;

TEST(Tally, NothingFoundIsNothingToWarnOf)
{
    for (const auto of :
         {Tally::Of::maskedPoints, Tally::Of::maskedCells, Tally::Of::halves, Tally::Of::corners, Tally::Of::areas})
        EXPECT_EQ(warningsOf({of, "a.vti", 0, 0, 100}), Lines());
}

TEST(Tally, OneLineSaysHowManyOfHowMany)
{
    EXPECT_EQ(warningsOf({Tally::Of::maskedPoints, "a.vti: array 'U'", 4, 3, 504}),
              Lines{"a.vti: array 'U': 4 masked, 3 not finite of 504 points, left blank"});
    EXPECT_EQ(warningsOf({Tally::Of::maskedCells, "a.vti: array 'p'", 0, 3, 336}),
              Lines{"a.vti: array 'p': 3 not finite of 336 cells, left blank"});
    EXPECT_EQ(warningsOf({Tally::Of::maskedPoints, "a.vti: array 'p'", 5, 0, 504}),
              Lines{"a.vti: array 'p': 5 masked of 504 points, left blank"});
    EXPECT_EQ(warningsOf({Tally::Of::corners, "s.vtk", 6, 0, 32}),
              Lines{"s.vtk: 6 of 32 cells left out: a corner is not finite"});
    EXPECT_EQ(warningsOf({Tally::Of::areas, "s.vtp", 3, 0, 35}),
              Lines{"s.vtp: 3 of 35 triangles left out: they have no area"});
}

TEST(Tally, WhatHalfPrecisionLoses)
{
    EXPECT_EQ(warningsOf({Tally::Of::halves, "a.vti: array 'U'", 7, 0, 0, 1e6}),
              Lines{"a.vti: array 'U': 7 values beyond 65504, the largest half, were set to it"});
    EXPECT_EQ(warningsOf({Tally::Of::halves, "a.vti: array 'U'", 0, 0, 0, 1e-4}),
              Lines{"a.vti: array 'U': the longest vector is 0.0001; in half precision vectors this short lose "
                    "accuracy"});
    EXPECT_EQ(warningsOf({Tally::Of::halves, "a.vti: array 'U'", 0, 0, 0, 1}), Lines());
}

}  // namespace
}  // namespace aeolic
