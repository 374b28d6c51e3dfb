#include "codecs/codecs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "codecs/codecs_report.h"

namespace aeolic {
namespace {

CodecsBenchPlan smallPlan()
{
    CodecsBenchPlan plan;
    plan.scene.surface.spec = "sphere:200";
    plan.scene.field.spec = "rotation:8,8,8";
    plan.scene.output.width = 50;
    plan.scene.output.height = 40;
    plan.scene.output.frames = 2;
    plan.scene.run.threads = 2;
    plan.qualities = {60, 90};
    plan.bandRows = 16;
    plan.repeats = 1;
    return plan;
}

/// A server sends bands, so that their table comes first; the other one follows row by row.
TEST(BenchCodecs, RowsAreShownAsTheyAreMeasured)
{
    const CodecsBenchPlan plan = smallPlan();
    CodecsTables tables(plan);
    std::vector<std::string> shown;
    std::vector<double> fractions;
    const CodecsBench bench =
        benchCodecs(plan, {[&](const std::string&, double fraction) { fractions.push_back(fraction); },
                           [&](const CodecsBench& soFar) { shown.push_back(tables.next(soFar)); }});
    const std::size_t codecs = bench.rows.size();
    ASSERT_GE(codecs, 5u) << "raw, lz4, png and two of jpeg";
    ASSERT_EQ(shown.size(), 1 + 2 * codecs);
    EXPECT_NE(shown[0].find("views: 2 of 50x40"), std::string::npos) << shown[0];
    for (std::size_t i = 0; i < 2 * codecs; ++i) {
        const std::string& text = shown[i + 1];
        const bool firstWhole = i == codecs;
        EXPECT_EQ(text.find("In one piece") != std::string::npos, firstWhole) << text;
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), firstWhole ? 5 : 1) << text;
        EXPECT_NE(text.find(stream::codecName(bench.rows[i % codecs].codec)), std::string::npos) << text;
    }
    EXPECT_EQ(tables.next(bench), "") << "everything was shown";
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_LT(fractions.back(), 1);
}

TEST(BenchCodecs, BothWaysBringTheSamePixelsBack)
{
    const CodecsBench bench = benchCodecs(smallPlan());
    EXPECT_EQ(bench.pixelBytes, 2 * 50 * 40 * 3);
    for (const CodecsBenchRow& row : bench.rows) {
        ASSERT_TRUE(row.whole);
        EXPECT_GT(row.whole->encodedBytes, 0);
        EXPECT_GE(row.bands.encodedBytes, row.whole->encodedBytes) << "every band has a beginning of its own";
        EXPECT_EQ(row.psnrDb > 0, row.quality > 0);
    }
}

}  // namespace
}  // namespace aeolic
