#include <gtest/gtest.h>

#include <algorithm>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "data/vtk/testing/sample_files.h"
#include "reader/openfoam/testing/sample_case.h"

/// Vectors of a surface's own that are turned round, and those that should be.
namespace aeolic {
namespace {

using namespace test;

bool mentionsReversed(const Renderer& renderer)
{
    const auto& warnings = renderer.info().warnings;
    return std::any_of(warnings.begin(), warnings.end(),
                       [](const std::string& line) { return line.find("'reversed(") != std::string::npos; });
}

class ReversedVectors : public testing::Test {
protected:
    ReversedVectors()
    {
        writeSampleCase(folder_.file("case"));
        scene_.surface.spec = folder_.file("case") + ":floor";
        scene_.field.vectors = "wallShearStress";
        scene_.output.width = scene_.output.height = 80;
        scene_.lic.steps = 8;
        scene_.camera.elevation = 60;
        scene_.run.backend = BackendChoice::cpu;
    }

    TempFolder folder_;
    SceneDescription scene_;
};

TEST_F(ReversedVectors, LeadTheOtherWay)
{
    const auto stored = Renderer(scene_).pick(40, 40);
    scene_.field.vectors = "reversed(wallShearStress)";
    const auto reversed = Renderer(scene_).pick(40, 40);
    ASSERT_TRUE(stored && stored->vector && reversed && reversed->vector);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ((*reversed->vector)[i], -(*stored->vector)[i]);
    EXPECT_GT((*stored->vector)[0], 0);
    EXPECT_EQ(reversed->vectorName, "reversed(wallShearStress)");
    SurfaceItem& item = scene_.surfaces.emplace_back();
    item.spec = scene_.surface.spec;
    item.vectors = "reversed(wallShearStress)";
    scene_.field.vectors = {};
    EXPECT_EQ(Renderer(scene_).pick(40, 40)->vector, reversed->vector) << "an item of several";
}

TEST_F(ReversedVectors, AreColouredByWhatTheyAre)
{
    scene_.shading.colorBy = "wallShearStress:normal";
    const auto stored = Renderer(scene_).pick(40, 40);
    scene_.field.vectors = "reversed(wallShearStress)";
    const auto reversed = Renderer(scene_).pick(40, 40);
    ASSERT_TRUE(stored && stored->scalar && reversed && reversed->scalar);
    EXPECT_EQ(*reversed->scalar, -*stored->scalar);
    EXPECT_NE(reversed->scalarName, stored->scalarName);
}

/// A still of dense streaks does not tell which way the flow goes.
TEST_F(ReversedVectors, AreProposedWhereThePictureShowsTheDirection)
{
    EXPECT_FALSE(mentionsReversed(Renderer(scene_)));
    SceneDescription shows = scene_;
    shows.lic.style = Style::oriented;
    EXPECT_TRUE(mentionsReversed(Renderer(shows)));
    for (const char* overlay : {"streamlines", "topology", "separation"}) {
        shows = scene_;
        shows.shading.overlay = overlay;
        EXPECT_TRUE(mentionsReversed(Renderer(shows))) << overlay;
        shows.field.vectors = "reversed(wallShearStress)";
        EXPECT_FALSE(mentionsReversed(Renderer(shows))) << overlay;
    }
    shows.field.vectors = "U";
    EXPECT_FALSE(mentionsReversed(Renderer(shows)));
    shows = scene_;
    shows.shading.overlay = "outline";
    EXPECT_FALSE(mentionsReversed(Renderer(shows)));
}

/// Walls and other patches follow different arrays by themselves.
TEST_F(ReversedVectors, AreProposedForTheSurfaceThatNeedsThem)
{
    scene_.field.vectors = {};
    scene_.lic.style = Style::oriented;
    for (const char* part : {":inlet", ":floor"}) {
        SurfaceItem item;
        item.spec = folder_.file("case") + part;
        scene_.surfaces.push_back(item);
    }
    const Renderer renderer(scene_);
    const auto& warnings = renderer.info().warnings;
    EXPECT_EQ(
        std::count(warnings.begin(), warnings.end(),
                   folder_.file("case") + ":floor: OpenFOAM's 'wallShearStress' points against the flow; \"vectors\": "
                                          "\"reversed(wallShearStress)\" of this surface turns it round"),
        1)
        << (warnings.empty() ? "" : warnings.front());
}

TEST_F(ReversedVectors, OfAFieldAreRefused)
{
    scene_.surface.spec = "sphere:500";
    scene_.field.spec = "abc:9,9,9";
    scene_.field.vectors = "reversed(abc)";
    try {
        Renderer renderer(scene_);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "--vectors: found 'reversed(abc)' of a field; expected reversed(NAME) of vectors that the surface "
                     "has itself, without --field");
    }
}

}  // namespace
}  // namespace aeolic
