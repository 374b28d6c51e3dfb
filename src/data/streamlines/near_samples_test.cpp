#include "data/streamlines/near_samples.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

constexpr glm::vec3 kUp{0, 0, 1}, kDown{0, 0, -1};

TEST(NearSamples, AreThoseWithinTheRadius)
{
    NearSamples near(1, 4);
    near.add({{0.1f, 0.2f, 0.3f}, kUp, 0, 0});
    for (const glm::vec3& way : {glm::vec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}) {
        const glm::vec3 from(0.1f, 0.2f, 0.3f);
        EXPECT_FALSE(near.isFree({from + 0.99f * way, kUp, 1, 0}, 1, 0));
        EXPECT_TRUE(near.isFree({from + 1.01f * way, kUp, 1, 0}, 1, 0));
        EXPECT_TRUE(near.isFree({from + 0.51f * way, kUp, 1, 0}, 0.5f, 0));
    }
}

TEST(NearSamples, DoNotCountOnTheOtherSideOfASheet)
{
    NearSamples near(1, 4);
    near.add({{0, 0, 0}, kUp, 0, 0});
    EXPECT_TRUE(near.isFree({{0, 0, -0.01f}, kDown, 1, 0}, 1, 0));
    EXPECT_FALSE(near.isFree({{0, 0, -0.01f}, kUp, 1, 0}, 1, 0));
}

TEST(NearSamples, OfOneLineCountFarAlongItOnly)
{
    NearSamples near(1, 4);
    near.add({{0, 0, 0}, kUp, 7, 10});
    EXPECT_TRUE(near.isFree({{0.1f, 0, 0}, kUp, 7, 11}, 1, 1.5f));
    EXPECT_FALSE(near.isFree({{0.1f, 0, 0}, kUp, 7, 12}, 1, 1.5f));
    EXPECT_FALSE(near.isFree({{0.1f, 0, 0}, kUp, 8, 11}, 1, 1.5f));
}

TEST(NearSamples, GoInTheOrderInWhichTheyCame)
{
    NearSamples near(1, 1);
    near.add({{0, 0, 0}, kUp, 0, 0});
    for (int i = 0; i < 5000; ++i) near.add({{5 + 0.001f * float(i % 10), 0, 0}, kUp, 1, float(i)});
    EXPECT_FALSE(near.isFree({{5, 0, 0}, kUp, 2, 0}, 1, 0));
    near.shrinkTo(1);
    EXPECT_EQ(near.count(), 1u);
    EXPECT_TRUE(near.isFree({{5, 0, 0}, kUp, 2, 0}, 1, 0));
    EXPECT_FALSE(near.isFree({{0, 0, 0}, kUp, 2, 0}, 1, 0));
}

TEST(NearSamples, AFarPlaceIsInOrder)
{
    NearSamples near(1e-9f, 4);
    near.add({{3, -3, 0}, kUp, 0, 0});
    EXPECT_TRUE(near.isFree({{0, 0, 0}, kUp, 1, 0}, 1e-9f, 0));
    EXPECT_FALSE(near.isFree({{3, -3, 0}, kUp, 1, 0}, 1e-9f, 0));
}

}  // namespace
}  // namespace aeolic
