#include <fmt/format.h>

#include "cli_testing.h"
#include "data/vtk/testing/sample_files.h"

/// What the built program says leads on to what to type next.
namespace aeolic {
namespace {

using namespace cli_testing;
using test::GridSample;
using test::writeGridFile;

class CliWords : public Cli {
protected:
    std::string file(const std::string& name) const { return (folder_ / name).string(); }
};

TEST_F(CliWords, AFileInThePlaceOfACommandIsToldToInfo)
{
    GridSample sample;
    writeGridFile(file("wake.vti"), sample);
    for (const char* name : {"wake.vti", "none.cgns", "wake.pvd"}) {
        const Outcome outcome = aeolic(name);
        EXPECT_EQ(outcome.exitCode, 2);
        EXPECT_EQ(outcome.err,
                  fmt::format("aeolic: {0}: a file, not a command; expected 'aeolic info {0}', which tells "
                              "what it holds and how 'aeolic render' draws it\n",
                              name));
    }
    EXPECT_NE(aeolic("scene.json").err.find("expected 'aeolic render scene.json -o OUT.png'"), std::string::npos);
    EXPECT_NE(aeolic("wake").err.find("wake: unknown command"), std::string::npos);
}

TEST_F(CliWords, HelpIsACommandToo)
{
    EXPECT_EQ(aeolic("help").out, aeolic("--help").out);
    EXPECT_EQ(aeolic("help render").out, aeolic("render --help").out);
    EXPECT_NE(aeolic("help render").out.find("--color-by"), std::string::npos);
    const Outcome unknown = aeolic("help rendr");
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_EQ(unknown.err, "aeolic: rendr: unknown command; did you mean render?\n");
}

TEST_F(CliWords, EndingsAreListedOnce)
{
    std::ofstream(file("a.foo")) << "something";
    const std::string err = aeolic("info a.foo").err;
    for (const char* ending : {" .cgns ", " .vtu ", " .stl ", "OpenFOAM case's folder"}) {
        const std::size_t at = err.find(ending);
        ASSERT_NE(at, std::string::npos) << ending << err;
        EXPECT_EQ(err.find(ending, at + 1), std::string::npos) << ending << err;
    }
}

TEST_F(CliWords, NumberedPicturesAreNamedAsTheyAre)
{
    EXPECT_TRUE(render("-o turn.png --frames 3 --verbose").err.starts_with("turn-0000.png to turn-0002.png: "));
    EXPECT_TRUE(render("-o turn.webp --frames 3 --verbose").err.starts_with("turn.webp: "));
    EXPECT_TRUE(render("-o turn.png --verbose").err.starts_with("turn.png: "));
}

/// A run that starts from rest shows nothing at its first moment, which is the default.
TEST_F(CliWords, ASeriesThatStartsFromRestSaysSo)
{
    for (int step = 0; step < 3; ++step) {
        GridSample sample;
        sample.scale = step;
        writeGridFile(file(fmt::format("u_{}.vti", step)), sample);
    }
    const std::string scene = "render --field 'u_*.vti' --surface slice:0,0.4,1:0,0,1 --size 32x32 -o a.png ";
    EXPECT_EQ(aeolic(scene).err,
              "aeolic: warning: slice:0,0.4,1:0,0,1: at the moment 0 all vectors are zero; try --time 2\n");
    EXPECT_EQ(aeolic(scene + "--time 1").err, "");
    EXPECT_EQ(aeolic(scene + "--time 2").err, "");
    EXPECT_EQ(aeolic(scene + "--frames 2 --time-range 0,2").err, "");
}

TEST_F(CliWords, TheLastMomentIsShownByItsName)
{
    for (int step = 0; step < 3; ++step) {
        GridSample sample;
        sample.scale = step + 1;
        writeGridFile(file(fmt::format("u_{}.vti", step)), sample);
    }
    const std::string scene =
        "render --field 'u_*.vti' --surface slice:0,0.4,1:0,0,1 --color-by p --scalar-bar off --size 48x48 ";
    ASSERT_EQ(aeolic(scene + "--time last -o last.png").err, "");
    ASSERT_EQ(aeolic(scene + "--time 2 -o two.png").err, "");
    ASSERT_EQ(aeolic(scene + "--time first -o first.png").err, "");
    EXPECT_EQ(fileText(folder_ / "last.png"), fileText(folder_ / "two.png"));
    EXPECT_NE(fileText(folder_ / "last.png"), fileText(folder_ / "first.png"));
    EXPECT_EQ(aeolic(scene + "--time last --time-range 0,1 -o a.png").err,
              "aeolic: --time-range: found together with --time last; expected one or the other\n");
}

/// A run that diverged in a few cells leaves one colour for all else.
TEST_F(CliWords, WildValuesAreToldWithTheRangeToType)
{
    std::string text =
        "# vtk DataFile Version 3.0\nwild\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 40 40 1\n"
        "ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 1600\nSCALARS p float 1\nLOOKUP_TABLE default\n";
    for (int i = 0; i < 1600; ++i) text += i == 817 ? "4e18\n" : fmt::format("{}\n", i % 40);
    text += "VECTORS U float\n";
    for (int i = 0; i < 1600; ++i) text += "1 0.5 0\n";
    std::ofstream(file("wild.vtk")) << text;
    const std::string scene =
        "render --field wild.vtk --vectors U --surface boundary --color-by p --scalar-bar off --size 48x48 ";
    const Outcome plain = aeolic(scene + "-o data.png");
    EXPECT_EQ(plain.exitCode, 0);
    EXPECT_EQ(plain.err,
              "aeolic: warning: boundary: 'p' is from 0 to 4e+18, but on 96 % of the area from 1 to 38, which have one "
              "colour; try --color-range 1,38, or robust\n");
    EXPECT_EQ(aeolic(scene + "--color-range robust -o robust.png").err, "");
    EXPECT_EQ(aeolic(scene + "--color-range 1,38 -o typed.png").err, "");
    EXPECT_EQ(fileText(folder_ / "robust.png"), fileText(folder_ / "typed.png"));
    EXPECT_NE(fileText(folder_ / "robust.png"), fileText(folder_ / "data.png"));
}

TEST_F(CliWords, AMeshOfGmshIsCalledSo)
{
    for (const char* version : {"2.2 0 8", "4.1 1 8"}) {
        std::ofstream(file("a.msh")) << "$MeshFormat\n" << version << "\n$EndMeshFormat\n";
        const std::string err = aeolic("info a.msh").err;
        EXPECT_TRUE(
            err.starts_with(fmt::format("aeolic: a.msh: it is a mesh of Gmsh (format {:.3}), not of Fluent; "
                                        "expected a Fluent mesh ('gmsh NAME.msh -save",
                                        version)))
            << err;
    }
}

}  // namespace
}  // namespace aeolic
