#include "render/lic/fresh_rows.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

constexpr Extent kWindow{0, 100, 9, 400};

TEST(FreshRows, AllAreToBeComputed)
{
    const FreshRows all;
    EXPECT_EQ(all.changedFrom(16, 2, kWindow), 100);
    EXPECT_EQ(all.readFrom(16, 2, kWindow), 100);
}

TEST(FreshRows, TakeMemoryForTheRowsThatAreRead)
{
    Image<int> image;
    const FreshRows fresh(300, 1);
    fresh.prepare(image, kWindow, 350);
    const std::size_t some = image.bytes();
    FreshRows().prepare(image, kWindow, 350);
    EXPECT_EQ(image.valid(), kWindow);
    EXPECT_LT(some, image.bytes());
    image.at(0, 399) = 7;
    fresh.prepare(image, {0, 150, 9, 450}, 340);
    EXPECT_EQ(image.at(0, 399), 7);
}

TEST(FreshRows, ChangeTheJumpsThatReadThem)
{
    const FreshRows fresh(300, 1);
    const int read = guardRowsBound(16, 1, 2);
    EXPECT_EQ(fresh.changedFrom(16, 2, kWindow), 300 - read);
    EXPECT_EQ(fresh.readFrom(16, 2, kWindow), 300 - 2 * read);
    EXPECT_EQ(fresh.changedFrom(1000, 2, kWindow), 100);
    EXPECT_EQ(fresh.readFrom(150, 2, kWindow), 100);
}

TEST(FreshRows, ChangeWhatIsNearFlowHoweverShortTheSteps)
{
    EXPECT_EQ(FreshRows(300, 0.01).changedFrom(0, 0, kWindow), 300 - NearFlow::kRows);
}

}  // namespace
}  // namespace aeolic
