#include "description/overlays.h"

#include <gtest/gtest.h>

#include <regex>

namespace aeolic {
namespace {

TEST(Overlays, AreReadFromAList)
{
    const auto all = parseOverlays("edges,streamlines:12.5,topology,outline");
    ASSERT_TRUE(all);
    EXPECT_TRUE(all->edges && all->topology && all->outline);
    EXPECT_EQ(all->streamlinesPx, 12.5);
    EXPECT_EQ(parseOverlays("streamlines")->streamlinesPx, Overlays::kUsualSpacingPx);
    EXPECT_FALSE(parseOverlays("none")->any());
    EXPECT_FALSE(parseOverlays("outline,edges")->needsFlow());
    EXPECT_TRUE(parseOverlays("topology")->needsFlow());
}

TEST(Overlays, NothingElseIsAList)
{
    for (const char* text : {"", "lines", "none,edges", "edges,", ",edges", "edges,edges", "streamlines,streamlines:9",
                             "streamlines:", "streamlines:3.9", "streamlines:1001", "streamlines:nan", "streamlines:1e",
                             "streamlines: 9", "edges topology", "Edges", "topology:3"})
        EXPECT_FALSE(isOverlayList(text)) << text;
}

TEST(Overlays, ThePageIsToldOfTheLists)
{
    const std::regex pattern(overlayListPattern);
    for (const char* text : {"edges", "streamlines:9", "streamlines,topology", "outline,streamlines:12.5,edges"})
        EXPECT_TRUE(std::regex_match(text, pattern) && isOverlayList(text)) << text;
    for (const char* text : {"lines", "edges,", "streamlines:x", "none,edges"})
        EXPECT_FALSE(std::regex_match(text, pattern)) << text;
}

}  // namespace
}  // namespace aeolic
