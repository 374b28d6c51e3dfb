#include <gtest/gtest.h>

#include "stream/requests.h"

namespace aeolic::stream {
namespace {

/// A viewer moves the time slider: its moment takes the place of what the command line said about time.
TEST(RequestsTime, AChangeOfTimeIsTheScenesMoment)
{
    SceneDescription scene;
    scene.time.range = {0.0, 4.0};
    const SceneDescription changed = withChange(scene, scene, changeFrom(Json::parse(R"({"time": 0.25})")));
    EXPECT_EQ(changed.time.moment, 0.25);
    EXPECT_FALSE(changed.time.range);
    const SceneDescription other = withChange(scene, scene, changeFrom(Json::parse(R"({"vectors": "U"})")));
    EXPECT_EQ(other.time.range, scene.time.range);
}

}  // namespace
}  // namespace aeolic::stream
