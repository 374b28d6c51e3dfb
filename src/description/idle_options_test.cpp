#include "description/idle_options.h"

#include <gtest/gtest.h>

#include "description/scene_text.h"

namespace aeolic {
namespace {

using Lines = std::vector<std::string>;
using Texts = std::map<std::string, std::string>;

Lines idle(const Texts& given, bool moves = true, SceneDescription scene = {})
{
    for (const auto& [name, text] : given) setOption(scene, name, text);
    return idleOptions(scene, given, moves);
}

TEST(IdleOptions, ColoursWithoutAnArray)
{
    EXPECT_EQ(idle({{"--legend", "p [Pa]"}}), Lines{"--legend has no effect without --color-by"});
    EXPECT_EQ(idle({{"--colormap", "viridis"}}), Lines{"--colormap has no effect without --color-by"});
    EXPECT_EQ(
        idle({{"--color-range", "0,1"}, {"--above-color", "ff0000"}}),
        (Lines{"--color-range has no effect without --color-by", "--above-color has no effect without --color-by"}));
    EXPECT_EQ(idle({{"--scalar-bar", "on"}}), Lines{"--scalar-bar has no effect without --color-by"});
    EXPECT_EQ(idle({{"--scalar-bar", "off"}}), Lines{});
    EXPECT_EQ(idle({{"--scalar-bar", "on"}, {"--magnitude", "contrast"}}), Lines{});
    EXPECT_EQ(idle({{"--magnitude", "contrast"}, {"--lic", "none"}}),
              Lines{"--magnitude has no effect with --lic none"});
    EXPECT_EQ(idle({{"--flow", "loop"}, {"--lic", "none"}}), Lines{"--flow has no effect with --lic none"});
    EXPECT_EQ(idle({{"--flow", "off"}, {"--lic", "none"}}), Lines{});
    EXPECT_EQ(idle({{"--normalize", "off"}, {"--magnitude", "length"}}),
              Lines{"--normalize has no effect with --magnitude length"});
    EXPECT_EQ(idle({{"--legend", "p [Pa]"}, {"--color-by", "p"}}), Lines{});
}

TEST(IdleOptions, PersistenceWithoutTopology)
{
    EXPECT_EQ(idle({{"--persistence", "0.1"}}),
              Lines{"--persistence has no effect without --overlay topology or separation"});
    EXPECT_EQ(idle({{"--persistence", "0.1"}, {"--overlay", "topology"}}), Lines{});
}

/// One of several surfaces is coloured, by what its own item says.
TEST(IdleOptions, ColoursOfOneSurfaceAreEnough)
{
    SceneDescription scene;
    scene.surfaces.resize(2);
    EXPECT_EQ(idle({{"--legend", "p"}}, true, scene).size(), 1u);
    scene.surfaces[1].colorBy = "p";
    EXPECT_EQ(idle({{"--legend", "p"}}, true, scene), Lines{});
    scene.surfaces[1].colorBy = "";
    scene.shading.colorBy = "p";
    EXPECT_EQ(idle({{"--legend", "p"}}, true, scene), Lines{}) << "the first surface is";
}

TEST(IdleOptions, AnimationsOfOnePicture)
{
    EXPECT_EQ(idle({{"--orbit", "90"}}), Lines{"--orbit has no effect without --frames"});
    EXPECT_EQ(idle({{"--fps", "10"}}), Lines{"--fps has no effect without --frames"});
    EXPECT_EQ(idle({{"--time-range", "0,1"}}), Lines{"--time-range shows its first moment alone without --frames"});
    EXPECT_EQ(idle({{"--orbit", "90"}, {"--fps", "10"}, {"--time-range", "0,1"}, {"--frames", "2"}}), Lines{});
}

TEST(IdleOptions, MomentsOfDataThatStandStill)
{
    const std::string still = " has no effect on data that do not change in time";
    EXPECT_EQ(idle({{"--time", "3"}}, false), Lines{"--time" + still});
    EXPECT_EQ(idle({{"--time-range", "0,1"}}, false), Lines{"--time-range" + still});
    EXPECT_EQ(idle({{"--time-stamp", "on"}}, false), Lines{"--time-stamp" + still});
    EXPECT_EQ(idle({{"--time-stamp", "off"}}, false), Lines{});
    EXPECT_EQ(idle({{"--time", "3"}, {"--time-stamp", "on"}}, true), Lines{});
}

TEST(IdleOptions, SamplingWithoutAField)
{
    const Texts given{{"--offset", "0.1"}, {"--resample-spacing", "0.1"}, {"--field-precision", "half"}};
    EXPECT_EQ(idle(given),
              (Lines{"--offset has no effect without --field", "--resample-spacing has no effect without --field",
                     "--field-precision has no effect without --field"}));
    SceneDescription scene;
    scene.field.spec = "wake.vti";
    EXPECT_EQ(idle(given, true, scene), Lines{});
}

TEST(IdleOptions, WhatBelongsToAnotherMethodOrKernel)
{
    EXPECT_EQ(idle({{"--integrator", "rk4"}}), Lines{"--integrator has no effect without --lic direct"});
    EXPECT_EQ(idle({{"--integrator", "rk4"}, {"--lic", "direct"}}), Lines{});
    EXPECT_EQ(idle({{"--phase", "1"}}), Lines{"--phase has no effect without --kernel hann"});
    EXPECT_EQ(idle({{"--phase", "1"}, {"--kernel", "hann"}}), Lines{});
    EXPECT_EQ(idle({{"--phase", "1"}, {"--kernel", "hann"}, {"--style", "oriented"}}),
              (Lines{"--kernel has no effect with --style oriented", "--phase has no effect with --style oriented"}));
    EXPECT_EQ(idle({{"--phase", "1"}, {"--kernel", "box"}, {"--flow", "loop"}}),
              Lines{"--kernel has no effect with --flow loop"});
    EXPECT_EQ(idle({{"--occlusion", "on"}, {"--lighting", "off"}}),
              Lines{"--occlusion has no effect with --lighting off"});
    EXPECT_EQ(idle({{"--occlusion", "off"}, {"--lighting", "off"}}), Lines{});
}

/// A scene file of an animation also serves for its first picture.
TEST(IdleOptions, WhatASceneFileSaysIsNotJudged)
{
    SceneDescription scene;
    scene.output.frames = 100;
    scene.output.orbit = 90;
    scene.output.fps = 10;
    scene.shading.legend = "p [Pa]";
    EXPECT_EQ(idle({{"--frames", "1"}}, true, scene), Lines{});
}

}  // namespace
}  // namespace aeolic
