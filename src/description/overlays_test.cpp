#include "description/overlays.h"

#include <gtest/gtest.h>

#include <regex>

namespace aeolic {
namespace {

TEST(Overlays, AreReadFromAList)
{
    const auto all = parseOverlays("edges,streamlines:12.5,topology,outline,separation");
    ASSERT_TRUE(all);
    EXPECT_TRUE(all->edges && all->topology && all->outline && all->separation);
    EXPECT_EQ(all->streamlinesPx, 12.5);
    EXPECT_EQ(parseOverlays("streamlines")->streamlinesPx, Overlays::kUsualSpacingPx);
    EXPECT_FALSE(parseOverlays("none")->any());
    EXPECT_EQ(parseOverlays("edges,through:1:-2.5:3e-4")->through, (std::array{1.0, -2.5, 3e-4}));
}

TEST(Overlays, NothingElseIsAList)
{
    for (const char* text : {"",
                             "lines",
                             "none,edges",
                             "edges,",
                             ",edges",
                             "edges,edges",
                             "separation,topology,separation",
                             "streamlines,streamlines:9",
                             "streamlines:",
                             "streamlines:3.9",
                             "streamlines:1001",
                             "streamlines:nan",
                             "streamlines:1e",
                             "streamlines: 9",
                             "edges topology",
                             "Edges",
                             "topology:3",
                             "through",
                             "through:1:2",
                             "through:1:2:3:4",
                             "through:1:2:nan",
                             "through:1:2:",
                             "through:1:2:1e999",
                             "through:0:0:0,through:1:0:0"})
        EXPECT_FALSE(isOverlayList(text)) << text;
}

TEST(Overlays, ThePageIsToldOfTheLists)
{
    const std::regex pattern(overlayListPattern);
    for (const char* text :
         {"edges", "separation,topology", "streamlines:9", "streamlines,topology", "outline,streamlines:12.5,edges",
          "through:-1:0.25:3e-07,edges", "topology,through:1e+20:2:0"})
        EXPECT_TRUE(std::regex_match(text, pattern) && isOverlayList(text)) << text;
    for (const char* text : {"lines", "edges,", "streamlines:x", "none,edges", "through:1:2", "through:1:2:x"})
        EXPECT_FALSE(std::regex_match(text, pattern)) << text;
}

}  // namespace
}  // namespace aeolic
