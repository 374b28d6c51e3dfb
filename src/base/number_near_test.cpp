#include "base/number_near.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

TEST(NumberNear, HasTheDigitsThatTheSizeNeeds)
{
    EXPECT_EQ(numberNear(0.375, 2, 4), "0.375");
    EXPECT_EQ(numberNear(1.0 / 3, 2, 4), "0.3333");
    EXPECT_EQ(numberNear(512346.5, 3, 4), "512346.5");
    EXPECT_EQ(numberNear(5312342.25, 10, 4), "5312342.25");
    EXPECT_EQ(numberNear(-1e6 - 1.0 / 3, 1, 4), "-1000000.3333");
    EXPECT_EQ(numberNear(0.1, 0, 4), "0.1");
    EXPECT_EQ(numberNear(1 + 1e-15, 1e-15, 6), "1.000000000000001");
}

}  // namespace
}  // namespace aeolic
