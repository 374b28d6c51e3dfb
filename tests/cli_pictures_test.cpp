#include "cli_testing.h"

#include <nlohmann/json.hpp>

/// The built program, from outside: which files it writes.
namespace aeolic {
namespace {

using namespace cli_testing;

/// Users who always draw on processors are not told so every time.

TEST_F(Cli, AutoSaysWhyNoGpuDrawsToWhoAsks)
{
    const std::string noDriver = "__EGL_VENDOR_LIBRARY_FILENAMES=/none";
    const auto unused = [&](const char* stats) {
        return nlohmann::json::parse(fileText(folder_ / stats))["unused_gpu"].get<std::string>();
    };
    const Outcome asked = render("-o a.png --verbose --stats a.json", noDriver);
    EXPECT_EQ(asked.exitCode, 0) << asked.err;
    const std::string why = unused("a.json");
    if (asked.err.find(" on gl (") != std::string::npos) {  // This EGL finds its drivers in another way.
        EXPECT_EQ(why, "") << "a GPU draws";
        EXPECT_EQ(asked.err.find("no GPU is used"), std::string::npos) << asked.err;
        return;
    }
    EXPECT_TRUE(why.starts_with("--backend: gl, ")) << why;
    EXPECT_TRUE(asked.err.ends_with("\nno GPU is used: " + why + "\n")) << asked.err;
    EXPECT_EQ(render("-o a.png", noDriver).err, "");
    const Outcome processor = render("--backend cpu -o b.png --verbose --stats b.json", noDriver);
    EXPECT_EQ(processor.err.find("GPU"), std::string::npos) << processor.err;
    EXPECT_EQ(unused("b.json"), "");
    EXPECT_EQ(fileText(folder_ / "a.png"), fileText(folder_ / "b.png"));
    const Outcome gpu = render("--backend gl -o c.png", noDriver);
    EXPECT_EQ(gpu.exitCode, 2);
    EXPECT_EQ(gpu.err, "aeolic: " + why + "\n");
}

/// A picture without the surface is made as it was asked for, and not in silence.

TEST_F(Cli, ABlankPictureHasAWarning)
{
    const Outcome away = render("--camera 'position=9,0,0;focal=20,0,0' --background 000000 -o a.png");
    EXPECT_EQ(away.exitCode, 0);
    EXPECT_TRUE(away.err.starts_with("aeolic: warning: the picture shows nothing of the surface")) << away.err;
    EXPECT_TRUE(away.oneLineError()) << away.err;
    const Outcome turning = render("--camera 'position=9,0,0;focal=20,0,0' --frames 2 --orbit 0 -o b.png");
    EXPECT_EQ(turning.exitCode, 0);
    EXPECT_TRUE(turning.err.starts_with("aeolic: warning: 2 of 2 pictures show nothing")) << turning.err;
}

/// A stand-in for ffmpeg, which is not to be had on every machine: counts what it reads, and writes its words.
constexpr const char* fakeFfmpeg = R"(#!/bin/sh
printf '%s ' "$@" > words.txt
for last; do :; done
bytes=$(wc -c)
case $FAIL in yes) echo "Unknown encoder 'x'" >&2; exit 1;; esac
echo "$bytes" > "${last#file:}"
)";

TEST_F(Cli, VideosAreWrittenByAnInstalledFfmpeg)
{
    std::ofstream(folder_ / "ffmpeg") << fakeFfmpeg;
    fs::permissions(folder_ / "ffmpeg", fs::perms::owner_all);
    const std::string path = "PATH='" + folder_.string() + "':/usr/bin:/bin";
    const Outcome made = render("--frames 3 --fps 12.5 -o ./-odd.mp4", path);
    EXPECT_EQ(made.exitCode, 0) << made.err;
    EXPECT_EQ(fileText(folder_ / "-odd.mp4"), std::to_string(3 * 64 * 48 * 3) + "\n");
    EXPECT_NE(fileText(folder_ / "words.txt").find("-pix_fmt rgb24 -s 64x48 -r 12.5 -i pipe:0"), std::string::npos);
    fs::remove(folder_ / "words.txt");
    EXPECT_EQ(filesLeft(), 2u) << "nothing but the video and the program";

    fs::remove(folder_ / "-odd.mp4");
    const Outcome failed = render("--frames 3 -o a.mp4", "FAIL=yes " + path);
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_EQ(failed.err, "aeolic: a.mp4: ffmpeg failed: Unknown encoder 'x'\n");
    fs::remove(folder_ / "words.txt");
    EXPECT_EQ(filesLeft(), 1u) << "nothing half-written";

    // Killed while it draws, by its own program, which it has as parent.
    std::ofstream(folder_ / "ffmpeg")
        << "#!/bin/sh\nfor last; do :; done\necho half > \"${last#file:}\"\nkill -9 $PPID\n";
    EXPECT_NE(render("--frames 3 -o a.mp4", path).exitCode, 0);
    EXPECT_EQ(filesLeft(), 1u) << "nothing of a video whose maker was killed";

    fs::remove(folder_ / "ffmpeg");
    const Outcome missing = render("--frames 3 -o a.mp4", "PATH='" + folder_.string() + "'");
    EXPECT_EQ(missing.exitCode, 2);
    EXPECT_EQ(missing.err,
              "aeolic: -o: found a .mp4, and no ffmpeg in PATH; expected an installed ffmpeg, or .webp or .apng\n");
    EXPECT_EQ(filesLeft(), 0u);
}

TEST_F(Cli, PicturesAndAnimationsByTheEndOfTheName)
{
    EXPECT_EQ(render("-o a.jpg").exitCode, 0);
    EXPECT_EQ(render("-o b.WEBP --background transparent").exitCode, 0);
    EXPECT_EQ(render("-o c.webp --frames 3").exitCode, 0);
    EXPECT_EQ(render("-o d.apng --frames 3").exitCode, 0);
    EXPECT_EQ(render("-o e.jpeg --frames 2").exitCode, 0);
    EXPECT_TRUE(fileText(folder_ / "a.jpg").starts_with("\xff\xd8\xff"));
    EXPECT_EQ(fileText(folder_ / "b.WEBP").substr(8, 8), "WEBPVP8L");
    EXPECT_NE(fileText(folder_ / "c.webp").find("ANIM"), std::string::npos);
    EXPECT_NE(fileText(folder_ / "d.apng").find("acTL"), std::string::npos);
    EXPECT_TRUE(fs::exists(folder_ / "e-0001.jpeg"));
    EXPECT_EQ(filesLeft(), 6u);
}

TEST_F(Cli, AFigureOfSixteenPixelsIsDrawn)
{
    for (const char* size : {"16x16", "1x1", "3000x20", "20x300"}) {
        const Outcome outcome =
            render("-o a.png --color-by uniform:mag --title T --axes on --time-stamp on --size " + std::string(size));
        EXPECT_EQ(outcome.exitCode, 0) << size << outcome.err;
    }
}

TEST_F(Cli, PictureOfTheSizeAskedForAndNothingElse)
{
    const Outcome outcome = render("-o a.png");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "");  // No terminal: no progress, no summary.
    EXPECT_EQ(filesLeft(), 1u);
    const std::string png = fileText(folder_ / "a.png");
    ASSERT_GT(png.size(), 24u);
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(png.substr(16, 8), std::string("\0\0\0\x40\0\0\0\x30", 8));  // Big-endian width and height.
}

TEST_F(Cli, SceneFileAndFlagsGiveTheSameBytes)
{
    std::ofstream(folder_ / "scene.json") << R"({"version": 1,
        "surface": {"spec": "torus:3000"}, "field": {"spec": "rotation:8,8,8"},
        "lic": {"method": "direct", "steps": 12, "step": 0.75, "kernel": "hann", "phase": 1.5, "seed": 9},
        "shading": {"blend": 0.6, "background": "102030"},
        "camera": {"azimuth": 50, "elevation": -10, "zoom": 1.25},
        "output": {"width": 72, "height": 60}})";
    const Outcome fromFile = aeolic("render scene.json -o file.png");
    ASSERT_EQ(fromFile.exitCode, 0) << fromFile.err;
    const Outcome fromFlags = aeolic(
        "render --surface torus:3000 --field rotation:8,8,8 --lic direct --steps 12 --step 0.75 --kernel hann --phase "
        "1.5 --seed 9 "
        "--blend 0.6 --background 102030 --camera azimuth=50,elevation=-10,zoom=1.25 --size 72x60 -o flags.png");
    ASSERT_EQ(fromFlags.exitCode, 0) << fromFlags.err;
    EXPECT_EQ(fileText(folder_ / "file.png"), fileText(folder_ / "flags.png"));
    const Outcome overridden = aeolic("render scene.json --seed 10 -o other.png");
    ASSERT_EQ(overridden.exitCode, 0) << overridden.err;
    EXPECT_NE(fileText(folder_ / "file.png"), fileText(folder_ / "other.png"));
}

TEST_F(Cli, ThreadsDoNotChangeTheBytes)
{
    ASSERT_EQ(render("--threads 1 -o one.png").exitCode, 0);
    ASSERT_EQ(render("--threads 3 -o three.png").exitCode, 0);
    EXPECT_EQ(fileText(folder_ / "one.png"), fileText(folder_ / "three.png"));
}

TEST_F(Cli, AnimationNumbersItsFilesBeforeTheExtension)
{
    const Outcome outcome = render("--frames 3 --orbit 90 -o turn.PNG --stats stats.json");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const char* name : {"turn-0000.PNG", "turn-0001.PNG", "turn-0002.PNG"})
        EXPECT_TRUE(fs::exists(folder_ / name)) << name;
    EXPECT_EQ(filesLeft(), 4u);
    EXPECT_NE(fileText(folder_ / "turn-0000.PNG"), fileText(folder_ / "turn-0001.PNG"));
    EXPECT_EQ(nlohmann::json::parse(fileText(folder_ / "stats.json"))["frames"].size(), 3u);
}

TEST_F(Cli, FramesOverTimeShowItsMoments)
{
    const std::string scene = "render --surface wave:800 --field gyre:16,16,2 --size 64x48 --steps 8 ";
    const Outcome outcome = aeolic(scene + "--frames 3 --time-range 0,2.5 -o w.png --stats stats.json");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const auto frames = nlohmann::json::parse(fileText(folder_ / "stats.json"))["frames"];
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_EQ(frames[1]["time"], 1.25);
    EXPECT_GE(frames[1]["step_ms"].get<double>(), 0);
    ASSERT_EQ(aeolic(scene + "--time 1.25 -o still.png").exitCode, 0);
    EXPECT_EQ(fileText(folder_ / "still.png"), fileText(folder_ / "w-0001.png"));
    EXPECT_NE(fileText(folder_ / "still.png"), fileText(folder_ / "w-0002.png"));
}

TEST_F(Cli, AWarningOfALaterMomentIsGivenOnce)
{
    for (const int i : {0, 1, 2}) {  // A sheet with one triangle, then with two.
        std::ofstream file(folder_ / ("s" + std::to_string(i) + ".obj"));
        file << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\n" << (i > 0 ? "f 2 4 3\n" : "");
    }
    const Outcome outcome = aeolic(
        "render --surface s%d.obj --field uniform:2,2,2 --frames 5 --time-range 0,2 --size 64x48 --steps 8 -o s.png");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err,
              "aeolic: warning: s%d.obj: its steps are different meshes: between two the earlier one is shown\n");
}

TEST_F(Cli, SceneFilesNameSeriesBesideThem)
{
    fs::create_directory(folder_ / "case");
    for (const int i : {0, 1})
        std::ofstream(folder_ / "case" / ("s" + std::to_string(i) + ".obj"))
            << "v 0 0 " << i << "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::ofstream(folder_ / "case" / "scene.json")
        << R"({"surface": {"spec": "s*.obj"}, "field": {"spec": "abc:4,4,4"}, "time": {"moment": 0.5}})";
    EXPECT_EQ(aeolic("render case/scene.json --size 64x48 -o a.png").err, "");
    EXPECT_TRUE(fs::exists(folder_ / "a.png"));
    EXPECT_EQ(aeolic("render case/scene.json --time-range 0.5,1 --size 64x48 -o b.png").err,
              "aeolic: warning: --time-range shows its first moment alone without --frames\n");
    EXPECT_EQ(fileText(folder_ / "b.png"), fileText(folder_ / "a.png")) << "options win";
}

/// A scene file without a surface is completed by an option, and refused without.
TEST_F(Cli, ASceneFileOfAFieldNeedsASurface)
{
    std::ofstream(folder_ / "scene.json") << R"({"field": {"spec": "wind.vti"}})";
    EXPECT_NE(aeolic("render scene.json -o a.png").err.find("--surface: found none"), std::string::npos);
    EXPECT_NE(aeolic("render scene.json --surface boundary -o a.png").err.find("wind.vti: no such file"),
              std::string::npos);
    std::ofstream(folder_ / "scene.json") << R"({"surface": {"spec": "teapot"}, "field": {"spec": "wind.vti"}})";
    EXPECT_NE(aeolic("render scene.json -o a.png").err.find("wind.vti: no such file"), std::string::npos);
}

TEST_F(Cli, OptionsWithoutEffectAreWarnedOf)
{
    const Outcome outcome = render("--legend 'p [Pa]' --orbit 90 -o a.png --stats stats.json");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err,
              "aeolic: warning: --legend has no effect without --color-by\n"
              "aeolic: warning: --orbit has no effect without --frames\n");
    EXPECT_EQ(nlohmann::json::parse(fileText(folder_ / "stats.json"))["warnings"].size(), 2u);
    EXPECT_EQ(render("--legend 'p [Pa]' --color-by uniform:mag --scalar-bar off --orbit 90 --frames 2 -o a.png").err,
              "");
}

TEST_F(Cli, StatsFileHasTheFieldsToolsRead)
{
    const Outcome outcome = render("-o a.png --stats stats.json --threads 2");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(filesLeft(), 2u);
    const auto stats = nlohmann::json::parse(fileText(folder_ / "stats.json"));
    EXPECT_EQ(stats["threads"], 2);
    EXPECT_EQ(stats["image"]["width"], 64);
    EXPECT_EQ(stats["image"]["height"], 48);
    const int covered = stats["image"]["covered_pixels"];
    EXPECT_GT(covered, 64 * 48 / 20);
    EXPECT_LT(covered, 64 * 48);
    EXPECT_EQ(stats["lic"]["steps"], 8);
    EXPECT_EQ(stats["field_bytes_per_rank"][0], 8 * 8 * 8 * 3 * 4);
    EXPECT_GT(stats["peak_rss_bytes_per_rank"][0], 1 << 20);
    const auto& frame = stats["frames"][0];
    double stages = 0;
    for (const auto& [name, ms] : frame["stages_ms"].items()) stages += ms.get<double>();
    EXPECT_GT(stages, 0);
    EXPECT_LE(stages, frame["total_ms"].get<double>() * 1.01);
    EXPECT_EQ(frame["stripes"][0]["rows"], 48);
    EXPECT_EQ(stats["summary"]["median_total_ms"], frame["total_ms"]);
}

TEST_F(Cli, StatsOnStandardOutput)
{
    const Outcome outcome = render("-o a.png --stats -");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["ranks"], 1);
}

TEST_F(Cli, WithoutAnySourceItDrawsTheTeapot)
{
    const Outcome outcome = aeolic("render --size 64x64 --steps 8 -o a.png --stats -");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_GT(nlohmann::json::parse(outcome.out)["image"]["covered_pixels"], 200);
}

TEST_F(Cli, TransparentBackgroundGivesRgba)
{
    ASSERT_EQ(render("--background transparent -o a.png").exitCode, 0);
    ASSERT_EQ(render("-o b.png").exitCode, 0);
    EXPECT_EQ(fileText(folder_ / "a.png").at(25), 6);  // PNG colour types: RGBA, RGB.
    EXPECT_EQ(fileText(folder_ / "b.png").at(25), 2);
}

}  // namespace
}  // namespace aeolic
