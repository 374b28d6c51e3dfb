#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "test_paths.h"
#include "version.h"

/// The built program, from outside: what it writes, where, and how it ends.
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

    bool oneLineError() const
    {
        return err.starts_with("aeolic: ") && err.ends_with('\n') && std::count(err.begin(), err.end(), '\n') == 1;
    }
};

class Cli : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    /// Runs `ENVIRONMENT aeolic ARGUMENTS` through the shell in the test's own folder.
    Outcome aeolic(const std::string& arguments, const std::string& environment = "") const
    {
        const fs::path out = folder_ / ".out", err = folder_ / ".err";
        const std::string command = "cd '" + folder_.string() + "' && " + environment + " '" AEOLIC_PROGRAM "' " +
                                    arguments + " >.out 2>.err </dev/null";
        const int status = std::system(command.c_str());
        Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, fileText(out), fileText(err)};
        fs::remove(out);
        fs::remove(err);
        return outcome;
    }

    /// A small scene, quick to draw.
    Outcome render(const std::string& arguments, const std::string& environment = "") const
    {
        return aeolic("render --surface teapot:2000 --field uniform:8,8,8 --size 64x48 --steps 8 " + arguments,
                      environment);
    }

    std::size_t filesLeft() const { return std::size_t(std::distance(fs::directory_iterator(folder_), {})); }

    fs::path folder_ = fs::temp_directory_path() / ("aeolic_cli_" + std::to_string(getpid()));
};

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

TEST_F(Cli, HelpAndVersionGoToStandardOutput)
{
    const Outcome version = aeolic("--version");
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_TRUE(version.out.starts_with("aeolic ")) << version.out;
    EXPECT_EQ(version.out.find("GNU General Public License") != std::string::npos, builtWithLzo) << version.out;
    EXPECT_EQ(version.err, "");
    for (const char* arguments : {"--help", "render --help", "info --help", "render -h"}) {
        const Outcome help = aeolic(arguments);
        EXPECT_EQ(help.exitCode, 0) << arguments;
        EXPECT_NE(help.out.find("Usage:"), std::string::npos) << arguments;
        EXPECT_EQ(help.err, "") << arguments;
    }
}

TEST_F(Cli, OutputThatCannotBeWrittenIsAFailure)
{
    for (const std::string arguments : {"--help", "--version", "render --list-colormaps"}) {
        const fs::path err = folder_ / ".err";
        EXPECT_NE(std::system(("'" AEOLIC_PROGRAM "' " + arguments + " >/dev/full 2>'" + err.string() + "'").c_str()),
                  0)
            << arguments;
        EXPECT_EQ(fileText(err), "aeolic: standard output: cannot be written\n") << arguments;
    }
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

TEST_F(Cli, HelpShowsEveryOptionWithItsDefault)
{
    const std::string help = aeolic("render --help").out;
    for (const char* option : {"--surface",     "--field",    "--field-precision", "--vectors",
                               "--color-by",    "--colormap", "--color-range",     "--scalar-bar",
                               "--size",        "--lic",      "--integrator",      "--steps",
                               "--step ",       "--kernel",   "--phase",           "--normalize",
                               "--noise-scale", "--seed",     "--contrast",        "--blend",
                               "--background",  "--lighting", "--camera",          "--frames",
                               "--orbit",       "--backend",  "--threads",         "--device",
                               "--stats",       "--output",   "--time ",           "--times"})
        EXPECT_NE(help.find(option), std::string::npos) << option;
    EXPECT_NE(help.find("[128]"), std::string::npos);
    EXPECT_NE(help.find("[hierarchical]"), std::string::npos);
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

TEST_F(Cli, WrongOptionsEndWithTwoAndOneLineAndNoFile)
{
    const std::pair<const char*, const char*> faults[] = {
        {"", "no command"},
        {"paint", "paint: unknown command"},
        {"render", "-o: missing"},
        {"render -o", "--output: no value"},
        {"render -o a.gif", "-o: found 'a.gif'; expected a name ending in .png, .jpg or .webp, or with --frames also"},
        {"render -o a.apng", "-o: found 'a.apng'; expected a name ending in .png, .jpg or .webp, or with --frames"},
        {"render -o a.gif --frames 2", "-o: found 'a.gif'; expected a name ending in .png, .jpg, .webp, .apng or .mp4"},
        {"render -o a.jpg --background transparent",
         "-o: found a JPEG file of a picture that is transparent; expected"},
        {"render -o a.webp --size 16384x9", "-o: found a WebP file of 16384x9 pixels; expected at most 16383 a side"},
        {"render -o a.mp4 --frames 2 --background transparent", "-o: found a video of pictures that are transparent"},
        {"render -o .png", "-o: found '.png'"},
        {"render -o no/such/a.png", "no/such/a.png: the folder no/such does not exist"},
        {"render -o a.png --stats no/such/s.json", "no/such/s.json: the folder no/such does not exist"},
        {"render -o a.png --stats a.png", "--stats: found the picture's own name"},
        {"render -o a.png --nonsense", "--nonsense: unknown option; expected one of those in 'aeolic render --help'"},
        {"render -o a.png --colorby p", "--colorby: unknown option; did you mean --color-by?"},
        {"render -o a.png --Steps=3", "--Steps=3: unknown option; did you mean --steps?"},
        {"rendr -o a.png", "rendr: unknown command; did you mean render?"},
        {"render -o a.png --lic hierachical",
         "--lic: found 'hierachical'; expected one of none, direct, hierarchical; did you mean hierarchical?"},
        {"render -o a.png --surface taepot",
         "taepot: no such file; expected a file that can be read; did you mean teapot?"},
        {"render -o a.png --field Tornado:8,8,8",
         "Tornado:8,8,8: no such file; expected a file that can be read; did you mean tornado?"},
        {"render -o a.png one.json two.json", "two.json: one argument too many"},
        {"render -o a.png car.vtp", "car.vtp: not a scene file"},
        {"render -o a.png none.json", "none.json: cannot be opened"},
        {"render -o a.png --size 0x10", "--size width: found 0; expected a whole number from 1 to 32768"},
        {"render -o a.png --size 10x32769", "--size height: found 32769; expected a whole number from 1 to 32768"},
        {"render -o a.png --size ten", "--size: found 'ten'"},
        {"render -o a.png --steps -5", "--steps: found -5; expected a whole number from 1 to 65536"},
        {"render -o a.png --steps 1.5", "--steps: found 1.5"},
        {"render -o a.png --steps many", "--steps: found 'many'"},
        {"render -o a.png --step 0", "--step: found 0; expected a number above 0, up to 8"},
        {"render -o a.png --step nan", "--step: found 'nan'"},
        {"render -o a.png --lic fast", "--lic: found 'fast'; expected one of none, direct, hierarchical"},
        {"render -o a.png --integrator rk3", "--integrator: found 'rk3'"},
        {"render -o a.png --kernel cone", "--kernel: found 'cone'"},
        {"render -o a.png --phase x", "--phase: found 'x'"},
        {"render -o a.png --normalize yes", "--normalize: found 'yes'; expected on or off"},
        {"render -o a.png --noise-scale 17", "--noise-scale: found 17"},
        {"render -o a.png --seed -1", "--seed: found -1"},
        {"render -o a.png --field-precision double", "--field-precision: found 'double'; expected one of float, half"},
        {"render -o a.png --resample-spacing 0", "--resample-spacing: found 0"},
        {"render -o a.png --feature-angle 181", "--feature-angle: found 181"},
        {"render -o a.png --colormap jet", "--colormap: found 'jet'; expected one of viridis"},
        {"render -o a.png --color-range 1", "--color-range: found '1'; expected 2 numbers"},
        {"render -o a.png --color-range 2,1", "--color-range: found 2,1"},
        {"render -o a.png --color-scale bands:1",
         "--color-scale: found 'bands:1'; expected one of linear, log, or bands"},
        {"render -o a.png --color-range 0,1 --color-scale log",
         "--color-range: found a low end of 0; expected one above"},
        {"render -o a.png --colormap none.json", "none.json: cannot be opened (No such file or directory)"},
        {"render -o a.png --nan-color red", "--nan-color: found 'red'; expected six hexadecimal digits RRGGBB"},
        {"render -o a.png --mask-below -1", "--mask-below: found -1; expected a finite number from 0"},
        {"render -o a.png --title 'two\nlines'", "--title: found 'two\\x0alines'; expected text without control"},
        {"render -o a.png --axes yes", "--axes: found 'yes'; expected on or off"},
        {"render -o a.png --fps 0", "--fps: found 0; expected a number from 0.1 to 240"},
        {"render -o a.png --scalar-bar maybe", "--scalar-bar: found 'maybe'"},
        {"render -o a.png --contrast 11", "--contrast: found 11"},
        {"render -o a.png --blend 1.1", "--blend: found 1.1"},
        {"render -o a.png --background white", "--background: found 'white'"},
        {"render -o a.png --lighting dim", "--lighting: found 'dim'"},
        {"render -o a.png --camera tilt=3", "--camera: found 'tilt=3'"},
        {"render -o a.png --camera zoom=0", "--camera zoom: found 0"},
        {"render -o a.png --frames 0", "--frames: found 0"},
        {"render -o a.png --orbit far", "--orbit: found 'far'"},
        {"render -o a.png --time noon", "--time: found 'noon'"},
        {"render -o a.png --times 1", "--times: found '1'; expected 2 numbers separated by commas"},
        {"render -o a.png --times 0,1 --time 1", "--times: found together with --time; expected one or the other"},
        {"render -o a.png --field none.pvd", "none.pvd: no such file"},
        {"render -o a.png --field 'none_*.vti'", "none_*.vti: no file has such a name"},
        {"render -o a.png --backend metal", "--backend: found 'metal'; expected one of auto, cpu, gl"},
        {"render -o a.png --threads -1", "--threads: found -1"},
        {"render -o a.png --device 999", "--device: found 999"},
        {"render -o a.png --surface ''", "--surface: found ''"},
        {"render -o a.png --surface none.vtp --field abc", "none.vtp"},
        {"render -o a.png --surface sphere:-3", "sphere:-3"},
        {"render -o a.png --surface sphere --field none.vti", "none.vti"},
        {"render -o a.png --surface sphere --field uniform:1,2", "uniform:1,2"},
        {"render '' -o a.png", "SCENE.json: found ''; expected a scene file, or none"},
        {"render -o a.png --context ''", "--context: found ''"},
        {"render -o a.png --surface slice", "did you mean slice:OX,OY,OZ:NX,NY,NZ?"},
        {"render -o a.png --color-range=-1e308,1e308", "--color-range: found -1e+308; expected a number from -1e+37"},
        {"serve --port x", "--port: found 'x'; expected a number"},
        {"serve --tls-cert none.pem --tls-key none.key", "--tls-cert: none.pem: No such file or directory"},
        {"grab http://127.0.0.1:1/ -o a.png --size 4294967297x10", "--size width: found 4294967297"},
        {"grab http://127.0.0.1:1/ -o a.png --timeout -1", "--timeout: found -1; expected"},
        {"grab http://127.0.0.1:1/ -o a.png --timeout nan", "--timeout: found nan; expected"},
        {"grab http://127.0.0.1:1/ -o a.png --view '{'", "--view: line 1, column 2"},
        {"grab http://127.0.0.1:1/ -o a.png --view '{\"camra\":{}}'", "did you mean camera?"},
        {"grab http://127.0.0.1:1/ -o a.png --view '{\"surface\":{}}'", "--view: surface: found in a view"},
        {"grab http://127.0.0.1:99999/ -o a.png", "address: found 'http://127.0.0.1:99999/'"},
        {"info ''", "FILE: found ''"},
        {"info", "FILE: missing"},
        {"info none.vtp", "none.vtp"},
    };
    for (const auto& [arguments, message] : faults) {
        const Outcome outcome = aeolic(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << arguments << "\n" << outcome.err;
        EXPECT_TRUE(outcome.oneLineError()) << arguments << "\n" << outcome.err;
        EXPECT_NE(outcome.err.find(message), std::string::npos) << arguments << "\n" << outcome.err;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_EQ(filesLeft(), 0u) << arguments;
    }
}

TEST_F(Cli, AFaultInASceneFileNamesFileAndField)
{
    std::ofstream(folder_ / "scene.json") << R"({"lic": {"steps": -3}})";
    const Outcome outcome = aeolic("render scene.json -o a.png");
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(outcome.err, "aeolic: scene.json: lic.steps: found -3; expected a whole number from 1 to 65536\n");
    EXPECT_FALSE(fs::exists(folder_ / "a.png"));
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
        "lic": {"method": "direct", "steps": 12, "stepPx": 0.75, "kernel": "hann", "phaseRad": 1.5, "seed": 9},
        "shading": {"blend": 0.6, "background": "102030"},
        "camera": {"azimuthDeg": 50, "elevationDeg": -10, "zoom": 1.25},
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
    const Outcome outcome = aeolic(scene + "--frames 3 --times 0,2.5 -o w.png --stats stats.json");
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
    const Outcome outcome =
        aeolic("render --surface s%d.obj --field uniform:2,2,2 --frames 5 --times 0,2 --size 64x48 --steps 8 -o s.png");
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
    EXPECT_EQ(aeolic("render case/scene.json --times 0.5,1 --size 64x48 -o b.png").err, "") << "options win";
    EXPECT_EQ(fileText(folder_ / "b.png"), fileText(folder_ / "a.png"));
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

TEST_F(Cli, AnExistingPictureSurvivesAFailure)
{
    std::ofstream(folder_ / "a.png") << "precious";
    EXPECT_EQ(aeolic("render --surface none.stl --field abc -o a.png").exitCode, 2);
    EXPECT_EQ(fileText(folder_ / "a.png"), "precious");
}

TEST_F(Cli, LastOfARepeatedOptionCounts)
{
    const Outcome outcome = render("--steps 3 --steps 5 -o a.png --stats -");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["lic"]["steps"], 5);
}

TEST_F(Cli, ListsColourMaps)
{
    const Outcome outcome = aeolic("render --list-colormaps");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_TRUE(outcome.out.starts_with("viridis\nturbo\n")) << outcome.out;
}

}  // namespace
}  // namespace aeolic
