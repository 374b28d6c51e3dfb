#include <nlohmann/json.hpp>

#include "cli_testing.h"
#include "version.h"

/// The built program, from outside: what it says, and how it ends.
namespace aeolic {
namespace {

using namespace cli_testing;

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
                               "--stats",       "--output",   "--time ",           "--time-range"})
        EXPECT_NE(help.find(option), std::string::npos) << option;
    EXPECT_NE(help.find("[128]"), std::string::npos);
    EXPECT_NE(help.find("[hierarchical]"), std::string::npos);
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
        {"render -o a.gif --frames 2",
         "-o: found 'a.gif'; expected a name ending in .png, .jpg, .webp, .apng, .mp4 or"},
        {"render -o a.html",
         "-o: found 'a.html'; expected a name ending in .png, .jpg or .webp, or with --frames also"},
        {"render -o a.html --frames 9", "-o: found a .html of pictures that are not one cycle; expected --flow loop"},
        {"render -o a.html --flow loop --orbit 90", "-o: found a .html of pictures that are not one cycle"},
        {"render -o a.html --flow loop --size 16384x9", "-o: found WebP pictures of 16384x9 pixels; expected at most"},
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
        {"render --surface teapot --axes --size 300x300 -o a.png", "--axes: no value before --size"},
        {"render --surface --field abc -o a.png", "--surface: no value before --field"},
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
        {"render -o a.png --overlay lines",
         "--overlay: found 'lines'; expected one of none, streamlines, topology, separation, edges, outline, or "
         "several "
         "of them with ',' between, as streamlines:PX,topology,through:X:Y:Z, with PX from 4 to 1000"},
        {"render -o a.png --persistence 2", "--persistence: found 2; expected a number from 0 to 1"},
        {"extract lines --surface sphere -o a.vtp",
         "WHAT: found 'lines'; expected topology, separation or streamlines"},
        {"extract streamline --surface sphere -o a.vtp", "; did you mean streamlines?"},
        {"extract topology --surface sphere -o a.obj", "-o: found 'a.obj'; expected a name ending in .vtp or .csv"},
        {"extract topology --surface sphere -o none/a.vtp", "none/a.vtp"},
        {"render -o a.png --frames 0", "--frames: found 0"},
        {"render -o a.png --orbit far", "--orbit: found 'far'"},
        {"render -o a.png --time noon", "--time: found 'noon'"},
        {"render -o a.png --time-range 1", "--time-range: found '1'; expected 2 numbers separated by commas"},
        {"render -o a.png --time-range 0,1 --time 1",
         "--time-range: found together with --time; expected one or the other"},
        {"render -o a.png --surface sphere --field none.pvd", "none.pvd: no such file"},
        {"render -o a.png --surface sphere --field 'none_*.vti'", "none_*.vti: no file has such a name"},
        {"render -o a.png --backend metal", "--backend: found 'metal'; expected one of auto, cpu, gl"},
        {"render -o a.png --threads -1", "--threads: found -1"},
        {"render -o a.png --device 999", "--device: found 999"},
        {"render -o a.png --surface ''", "--surface: found ''"},
        {"render -o a.png --surface none.vtp --field abc", "none.vtp"},
        {"render -o a.png --surface sphere:-3", "sphere:-3"},
        {"render -o a.png --surface sphere --field none.vti", "none.vti"},
        {"render -o a.png --surface sphere --field uniform:1,2", "uniform:1,2"},
        {"render -o a.png --field wind.vti", "--surface: found none; expected a file, boundary, slice:OX,OY,OZ"},
        {"serve --field wind.vti", "--surface: found none; expected a file, boundary, slice:OX,OY,OZ"},
        {"render -o a.png --context sphere", "--surface: found none beside --context; expected a surface"},
        {"render -o a.png --surface teapot --field wind.vti", "wind.vti"},
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

/// A reader whose library complains: nobody hears of it who does not ask.
TEST_F(Cli, InfoShowsTheReadersWordsToThoseWhoAsk)
{
    const fs::path reader = fs::path(AEOLIC_PROGRAM).parent_path() / "libexec/aeolic/aeolic-reader";
    std::ofstream(folder_ / "reader") << "#!/bin/sh\necho 'the library complains' >&2\nexec '" << reader.string()
                                      << "'\n";
    fs::permissions(folder_ / "reader", fs::perms::owner_all);
    std::ofstream(folder_ / "a.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string environment = "AEOLIC_READER=./reader";
    const Outcome quiet = aeolic("info a.obj", environment), loud = aeolic("info a.obj --verbose", environment);
    EXPECT_EQ(quiet.err, "");
    EXPECT_EQ(quiet.exitCode, 0);
    EXPECT_TRUE(loud.err.starts_with("aeolic-reader: a.obj: the library complains\n")) << loud.err;
    EXPECT_EQ(loud.exitCode, 0);
    EXPECT_EQ(loud.out, quiet.out);
    const Outcome sound = aeolic("info a.obj --verbose");
    EXPECT_EQ(sound.err, "");
    EXPECT_EQ(sound.out, loud.out);
    EXPECT_NE(sound.out, "");

    std::ofstream(folder_ / "reader") << "#!/bin/sh\necho 'and ends' >&2\nexit 1\n";
    const Outcome ended = aeolic("info a.obj --verbose", environment);
    EXPECT_EQ(ended.exitCode, 2);
    EXPECT_TRUE(ended.err.starts_with("aeolic-reader: a.obj: and ends\naeolic: a.obj: the reader ended (exit code 1)"))
        << ended.err;
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
