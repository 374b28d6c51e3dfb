#include "output/stats_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace aeolic {
namespace {

RunStats threeFrames()
{
    RunStats stats;
    stats.scene.output.width = 640;
    stats.scene.output.height = 480;
    stats.info.backend = "cpu";
    stats.info.simd = "AVX3";
    stats.info.threads = 2;
    stats.info.threadsOfRank = {2, 1};
    stats.info.loadMs = 12.5;
    stats.info.fieldBytesOfRank = {5'000'000'000};
    for (double totalMs : {40.0, 10.0, 25.0}) {
        FrameStats frame;
        frame.totalMs = totalMs;
        frame.convolveMs = totalMs / 2;
        RankStats rank;
        rank.rows = 480;
        rank.pixels = 1234;
        rank.busyMs = totalMs * 1.8;
        frame.ranks.push_back(rank);
        frame.coveredPixels = 1234;
        stats.frames.push_back(frame);
    }
    stats.peakRssBytesOfRank = {77};
    return stats;
}

TEST(StatsJson, SaysWhatWasMeasured)
{
    const auto json = nlohmann::json::parse(statsToJson(threeFrames()));
    EXPECT_EQ(json["backend"], "cpu");
    EXPECT_EQ(json["ranks"], 1);
    EXPECT_EQ(json["image"], nlohmann::json::parse(R"({"width":640,"height":480,"covered_pixels":1234})"));
    EXPECT_EQ(
        json["lic"],
        nlohmann::json::parse(
            R"({"method":"hierarchical","style":"dense","flow":"off","integrator":"rk2","steps":128,"step_px":1.0,"kernel":"box"})"));
    EXPECT_EQ(json["threads_per_rank"], nlohmann::json({2, 1}));
    EXPECT_EQ(json["field_bytes_per_rank"][0], 5'000'000'000);
    EXPECT_EQ(json["peak_rss_bytes_per_rank"][0], 77);
    ASSERT_EQ(json["frames"].size(), 3u);
    EXPECT_EQ(json["frames"][0]["total_ms"], 40.0);
    for (const char* stage : {"balance", "project", "composite", "convolve", "shade", "gather"})
        EXPECT_TRUE(json["frames"][0]["stages_ms"].contains(stage)) << stage;
}

TEST(StatsJson, ASingleRanksStripeIsTheWholeImage)
{
    const auto json = nlohmann::json::parse(statsToJson(threeFrames()));
    EXPECT_EQ(
        json["frames"][1]["stripes"],
        nlohmann::json::parse(R"([{"rank":0,"first_row":0,"rows":480,"guard_rows":[0,0],"pixels":1234,"busy_ms":18.0,
                                         "sent_bytes":0,"sent_messages":0}])"));
}

TEST(StatsJson, SaysWhatWasWarnedOf)
{
    RunStats stats = threeFrames();
    EXPECT_EQ(nlohmann::json::parse(statsToJson(stats))["warnings"], nlohmann::json::array());
    stats.info.warnings = {"a.vti: array 'U': 1 masked of 8 points, left blank"};
    EXPECT_EQ(nlohmann::json::parse(statsToJson(stats))["warnings"], nlohmann::json(stats.info.warnings));
}

TEST(StatsJson, SaysWhyNoGpuDraws)
{
    RunStats stats = threeFrames();
    EXPECT_EQ(nlohmann::json::parse(statsToJson(stats))["unused_gpu"], "");
    stats.info.unusedGpu = "there is none";
    EXPECT_EQ(nlohmann::json::parse(statsToJson(stats))["unused_gpu"], "there is none");
}

TEST(StatsJson, SummaryIsTheMedian)
{
    RunStats stats = threeFrames();
    EXPECT_EQ(nlohmann::json::parse(statsToJson(stats))["summary"],
              nlohmann::json::parse(R"({"median_total_ms":25.0,"fps":40.0})"));
    stats.frames.pop_back();
    EXPECT_EQ(nlohmann::json::parse(statsToJson(stats))["summary"]["median_total_ms"], 25.0);
}

TEST(StatsJson, DeviceNameThatIsNotUtf8StillGivesJson)
{
    RunStats stats = threeFrames();
    stats.info.device = "GPU\xff";
    EXPECT_NO_THROW(nlohmann::json::parse(statsToJson(stats)));
}

TEST(PeakRss, IsAtLeastAMegabyteAndCountsWhatIsTouched)
{
    EXPECT_GT(peakRssBytes(), 1u << 20);
    const std::vector<char> touched(std::size_t(64) << 20, 1);
    EXPECT_GT(peakRssBytes(), touched.size());
}

}  // namespace
}  // namespace aeolic
