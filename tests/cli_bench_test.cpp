#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "test_paths.h"

/// `aeolic-bench` from outside, with sizes that take no time.
namespace aeolic {
namespace {

namespace fs = std::filesystem;

std::string fileText(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Outcome {
    int exitCode = -1;
    std::string out, err;
};

class CliBench : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    Outcome bench(const std::string& arguments) const { return run(AEOLIC_BENCH_PROGRAM, arguments); }

    Outcome run(const std::string& program, const std::string& arguments) const
    {
        const std::string command =
            "cd '" + folder_.string() + "' && '" + program + "' " + arguments + " >.out 2>.err </dev/null";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, fileText(folder_ / ".out"), fileText(folder_ / ".err")};
    }

    Outcome smallStages(const std::string& arguments) const
    {
        return bench(
            "stages --surface teapot:2000 --field uniform:8,8,8 --sizes 64x48,32x32 --steps 8,20 "
            "--repeats 2 " +
            arguments);
    }

    static constexpr const char* smallCodecs =
        "--surface teapot:2000 --color-by abc:mag --size 90x70 --frames 3 --qualities 40,95 --band-rows 32 --repeats 2";
    fs::path folder_ = fs::temp_directory_path() / ("aeolic_cli_bench_" + std::to_string(getpid()));
};

TEST_F(CliBench, StagesPrintsATableOfAtMost110Columns)
{
    const Outcome outcome = smallStages("--threads 1");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err, "");  // No progress where nobody watches.
    int rows = 0;
    std::size_t rowWidth = 0;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 110u) << line;
        if (!line.starts_with("64x48 ") && !line.starts_with("32x32 ")) continue;
        ++rows;
        if (rowWidth == 0) rowWidth = line.size();
        EXPECT_EQ(line.size(), rowWidth) << line;
    }
    EXPECT_EQ(rows, 2 * 2 * 2);
    for (const char* text :
         {"threads: 1", "32-bit gather instruction", "128-bit block loads", "hierarchical", "total ms"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
}

TEST_F(CliBench, StagesWritesItsNumbersAsJson)
{
    const Outcome outcome = smallStages("--threads 2 --methods hierarchical --integrator euler --json numbers.json");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(fileText(folder_ / "numbers.json"));
    EXPECT_EQ(json["machine"]["backend"], "cpu");
    EXPECT_EQ(json["machine"]["threads"], 2);
    EXPECT_FALSE(json["machine"]["simd"].get<std::string>().empty());
    EXPECT_EQ(json["scene"]["surface"], "teapot:2000");
    EXPECT_EQ(json["scene"]["integrator"], "euler");
    EXPECT_EQ(json["repeats"], 2);
    for (const char* how : {"gather_instruction", "block_loads"})
        for (const char* threads : {"one_thread", "all_threads"}) EXPECT_GT(json["gather_rates"][how][threads], 0);
    ASSERT_EQ(json["rows"].size(), 4u);
    const auto& row = json["rows"][1];
    EXPECT_EQ(row["size"], nlohmann::json({64, 48}));
    EXPECT_EQ(row["method"], "hierarchical");
    EXPECT_EQ(row["steps"], 20);
    EXPECT_GT(row["covered_pixels"], 1000);
    for (const char* stage : {"project", "convolve", "shade", "total"}) EXPECT_GT(row["stages_ms"][stage], 0) << stage;
    for (const char* key : {"pixel_steps_per_s", "walked_share", "lanes_per_s", "lanes_per_s_at_most",
                            "share_of_gather_rate", "share_of_block_load_rate"})
        EXPECT_GT(row[key], 0) << key;
    EXPECT_EQ(nlohmann::json::parse(smallStages("--json -").out)["rows"].size(), 8u);
}

TEST_F(CliBench, CodecsPrintsBothWaysOfEachCodec)
{
    const Outcome outcome = bench("codecs " + std::string(smallCodecs));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    for (const char* codec : {"raw ", "lz4 ", "png ", "jpeg 40 ", "jpeg 95 "}) {
        int rows = 0;
        std::istringstream lines(outcome.out);
        for (std::string line; std::getline(lines, line);) {
            EXPECT_LE(line.size(), 110u) << line;
            rows += line.starts_with(codec);
        }
        EXPECT_EQ(rows, 2) << codec;
    }
    for (const char* text :
         {"bands of 32 rows", "one piece", "100 Mbit/s", "3 of 90x70, 3 bytes a pixel", "coloured by abc:mag"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
}

TEST_F(CliBench, CodecsWritesItsNumbersAsJson)
{
    const Outcome outcome = bench("codecs --json numbers.json " + std::string(smallCodecs));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(fileText(folder_ / "numbers.json"));
    EXPECT_EQ(json["scene"]["pixel_bytes"], 3 * 90 * 70 * 3);
    EXPECT_EQ(json["scene"]["views"], 3);
    EXPECT_GT(json["scene"]["covered"], 0.1);
    EXPECT_EQ(json["band_rows"], 32);
    std::map<std::string, nlohmann::json> rows;
    for (const auto& row : json["rows"])
        rows[row["codec"].get<std::string>() + (row["quality"].is_null() ? "" : std::to_string(int(row["quality"])))] =
            row;
    for (const char* codec : {"raw", "lz4", "png", "jpeg40", "jpeg95"})
        for (const char* way : {"one_piece", "bands"}) {
            ASSERT_TRUE(rows.count(codec)) << codec;
            const auto& cost = rows[codec][way];
            EXPECT_GT(cost["encode_mb_per_s"], 0) << codec << " " << way;
            EXPECT_GT(cost["decode_mb_per_s"], 0) << codec << " " << way;
            // No faster than the line carries the bytes, and the slower line takes longer by what it carries slower.
            const double bits = 8 * double(cost["encoded_bytes"]) / 3;
            const auto& ms = cost["ms_to_viewer"];
            EXPECT_GE(double(ms["10_mbit_s"]), bits / 10e6 * 1e3) << codec << " " << way;
            EXPECT_NEAR(double(ms["10_mbit_s"]) - double(ms["1_gbit_s"]), bits * (1e3 / 10e6 - 1e3 / 1e9), 1e-6);
        }
    EXPECT_EQ(rows["raw"]["bands"]["encoded_bytes"], json["scene"]["pixel_bytes"]);
    EXPECT_GT(rows["lz4"]["bands"]["ratio"], 1.2);
    EXPECT_GT(rows["jpeg40"]["bands"]["ratio"], rows["jpeg95"]["bands"]["ratio"]);
    EXPECT_GT(rows["jpeg95"]["psnr_db"], rows["jpeg40"]["psnr_db"]);
    EXPECT_TRUE(rows["png"]["psnr_db"].is_null());
}

TEST_F(CliBench, CodecsOfATransparentPictureLeaveJpegOut)
{
    const Outcome outcome = bench("codecs --background transparent --json - " + std::string(smallCodecs));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["scene"]["bytes_per_pixel"], 4);
    for (const auto& row : json["rows"]) EXPECT_NE(row["codec"], "jpeg");
    EXPECT_GE(json["rows"].size(), 3u);
}

/// The model's share of a frame's time, by its own formula: what is sent does not depend on the network.
TEST_F(CliBench, ScalingTakesTheNetworkThatIsGiven)
{
    const std::string small =
        "scaling --surface teapot:500 --field abc:8,8,8 --size 64x48 --steps 8 --frames 2 --ranks 2,1 "
        "--balance static --parts nodes ";
    const Outcome tables = bench(small + "--network 10,50");
    ASSERT_EQ(tables.exitCode, 0) << tables.err;
    for (const char* text :
         {"with a network of 10 Gbit/s and 50 us a message;",
          "theirs: with that of Bachthaler et al. 2006, 6.4 Gbit/s and 5 us a message; paper:", "\n       theirs "})
        EXPECT_NE(tables.out.find(text), std::string::npos) << text << " in\n" << tables.out;
    std::istringstream lines(tables.out);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 110u) << line;
        EXPECT_FALSE(std::regex_search(line, std::regex("\\)[0-9]"))) << "cells touch: " << line;
    }

    const auto json = nlohmann::json::parse(bench(small + "--network 0.008,1000 --json -").out);
    EXPECT_EQ(json["network"], nlohmann::json::parse(R"({"bytes_per_s":1e6,"latency_us":1000.0})"));
    EXPECT_EQ(json["papers_network"], nlohmann::json::parse(R"({"bytes_per_s":8e8,"latency_us":5.0})"));
    const auto& row = json["rows"].back();
    ASSERT_EQ(row["ranks"], 2);
    double expectedMs = 0;
    for (const char* stage : {"balance", "project", "composite", "convolve", "shade", "gather"}) {
        double slowestMs = 0;
        for (const auto& rank : row["ranks_of_median_frame"])
            for (const std::string way : {"sent", "received"})
                slowestMs = std::max(slowestMs, double(rank["stages"][stage][way + "_messages"]) +
                                                    double(rank["stages"][stage][way + "_bytes"]) / 1e3);
        expectedMs += slowestMs;
    }
    EXPECT_GT(expectedMs, 64 * 48 / 2 * 4 / 1e3) << "half of the picture travels";
    EXPECT_NEAR(double(row["critical_path"]["network_ms"]), expectedMs, 1e-9 * expectedMs);
    EXPECT_LT(double(row["modelled_ms_on_the_papers_network"]), double(row["modelled_ms"]));
}

TEST_F(CliBench, ScalingComparesBricksPictureByPicture)
{
    const std::string small =
        "scaling --surface teapot:500 --field abc:8,8,8 --large-field abc:16,16,16 --size 64x48 --steps 8 "
        "--frames 2 --ranks 2 --balance static,hybrid --parts bricks ";
    const Outcome tables = bench(small);
    ASSERT_EQ(tables.exitCode, 0) << tables.err;
    for (const char* text : {"teapot:500 in abc:8,8,8, on every node: ", "teapot:500 in abc:8,8,8, in bricks: ",
                             "teapot:500 in abc:16,16,16, in bricks: ", "load slower\n"})
        EXPECT_NE(tables.out.find(text), std::string::npos) << text << " in\n" << tables.out;
    std::istringstream lines(tables.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110u) << line;

    const auto json = nlohmann::json::parse(bench(small + "--json -").out);
    ASSERT_EQ(json["rows"].size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        const auto& row = json["rows"][i];
        EXPECT_EQ(row["part"], "bricks");
        EXPECT_EQ(row["balance"], i % 2 == 0 ? "static" : "hybrid");
        EXPECT_EQ(row["bricked"], i >= 2);
        EXPECT_EQ(row["field"], i < 4 ? "abc:8,8,8" : "abc:16,16,16");
        EXPECT_EQ(row.value("modelled_ms_by_that_of_the_rows_before", 0.0) > 0, i >= 2);
    }
}

TEST_F(CliBench, HelpShowsDefaultsAndUnits)
{
    const Outcome all = bench("--help"), stages = bench("stages --help");
    EXPECT_EQ(all.exitCode, 0);
    EXPECT_NE(all.out.find("stages"), std::string::npos);
    EXPECT_EQ(stages.exitCode, 0);
    for (const char* text :
         {"--sizes", "[800x800,1920x1080,3840x2160]", "--steps N,...", "[16,32,64,128,256,512,1024]", "--methods",
          "[direct,hierarchical]", "--repeats", "[5]", "--json", "--threads", "--surface", "pixels", "milliseconds"})
        EXPECT_NE(stages.out.find(text), std::string::npos) << text;
    for (const char* text : {"--size ", "--lic ", "--frames", "--orbit"})
        EXPECT_EQ(stages.out.find(text), std::string::npos) << text;
}

TEST_F(CliBench, WrongOptionsEndWithTwoAndOneLine)
{
    const std::pair<const char*, const char*> faults[] = {
        {"", "no command; expected one of those in 'aeolic-bench --help'"},
        {"paint", "paint: unknown command; expected one of those in 'aeolic-bench --help'"},
        {"stages --nonsense", "--nonsense: unknown option; expected one of those in 'aeolic-bench stages --help'"},
        {"stages --size 10x10", "--size: unknown option"},
        {"stages --sizes 10", "--sizes: found '10'; expected WIDTHxHEIGHT"},
        {"stages --sizes 10x10,", "--sizes: found ''"},
        {"stages --sizes 0x10", "--sizes width: found 0; expected a whole number from 1 to 32768"},
        {"stages --sizes 10x32769", "--sizes height: found 32769"},
        {"stages --steps 16,0", "--steps: found 0; expected a whole number from 1 to 65536"},
        {"stages --steps few", "--steps: found 'few'"},
        {"stages --methods none", "--methods: found 'none'; expected direct, hierarchical or both"},
        {"stages --repeats 0", "--repeats: found 0; expected a whole number from 1 to 1000"},
        {"stages --json no/such/b.json", "no/such/b.json: the folder no/such does not exist"},
        {"stages --surface none.vtp --field abc", "none.vtp"},
        {"codecs --qualities 0", "--qualities: found 0; expected a whole number from 1 to 100"},
        {"codecs --qualities 90,", "--qualities: found ''"},
        {"codecs --band-rows 24", "--band-rows: found 24; expected a multiple of 16"},
        {"codecs --band-rows 0", "--band-rows: found 0; expected a whole number from 16 to 32768"},
        {"codecs --repeats 0", "--repeats: found 0"},
        {"codecs --frames 100000 --size 4000x4000", "--frames: 100000 views"},
        {"codecs --size 8000x8000", "--size: found 8000x8000; expected at most 64 MiB of pixels of 3 bytes"},
        {"codecs --balance static", "--balance: unknown option"},
        {"codecs --json no/such/b.json", "no/such/b.json: the folder no/such does not exist"},
        {"scaling --network 100",
         "--network: found '100'; expected gigabits a second from 0.001 to 100000 and "
         "microseconds a message from 0 to 100000, as in 100,2"},
        {"scaling --network 0,2", "--network: found '0,2'"},
        {"scaling --network 100,-1", "--network: found '100,-1'"},
        {"scaling --network 100,2,3", "--network: found '100,2,3'"},
        {"scaling --network 1e300,2", "--network: found '1e300,2'"},
        {"scaling --network fast,2", "--network: found 'fast,2'"},
        {"stages --kernel cone", "--kernel: found 'cone'"},
    };
    for (const auto& [arguments, message] : faults) {
        const Outcome outcome = bench(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_TRUE(outcome.err.starts_with("aeolic-bench: ")) << outcome.err;
        EXPECT_NE(outcome.err.find(message), std::string::npos) << arguments << ": " << outcome.err;
    }
}

TEST_F(CliBench, TheFormerCommandSaysWhereItWent)
{
    for (const char* arguments : {"bench", "bench stages --sizes 64x48", "bench --help", "bench paint --nonsense"}) {
        const Outcome outcome = run(AEOLIC_PROGRAM, arguments);
        EXPECT_EQ(outcome.exitCode, 2) << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_EQ(outcome.err, "aeolic: bench is a program of its own now: aeolic-bench scaling | stages | codecs\n");
    }
    const Outcome help = run(AEOLIC_PROGRAM, "--help");
    EXPECT_EQ(help.out.find("bench"), std::string::npos) << help.out;
}

}  // namespace
}  // namespace aeolic
