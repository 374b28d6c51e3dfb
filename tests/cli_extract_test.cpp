#include <fmt/format.h>

#include "cli_testing.h"

namespace aeolic {
namespace {

using namespace cli_testing;

const std::string kScene = "extract topology --surface torus:2000 --field abc:16,16,16 ";

TEST_F(Cli, ExtractWritesPointsAndLines)
{
    const Outcome csv = aeolic(kScene + "--color-by abc:mag -o a.csv"), vtp = aeolic(kScene + "-o a.vtp");
    EXPECT_EQ(csv.exitCode, 0) << csv.err;
    EXPECT_EQ(vtp.exitCode, 0) << vtp.err;
    EXPECT_EQ(csv.out + csv.err + vtp.out + vtp.err, "");
    const std::string text = fileText(folder_ / "a.csv");
    EXPECT_TRUE(text.starts_with("line,type,attracts,index,strength,length,x,y,z,vector x,vector y,vector z,|abc|\n"));
    for (const char* what : {"\n,saddle,0,-1,", "\n0,separation,", ",attachment,0,0,"})
        EXPECT_NE(text.find(what), std::string::npos) << what;
    EXPECT_TRUE(fileText(folder_ / "a.vtp").starts_with("<VTKFile type=\"PolyData\""));
    EXPECT_EQ(filesLeft(), 2u);
}

TEST_F(Cli, ExtractSaysWhereThereIsNothing)
{
    const Outcome outcome = aeolic("extract topology --surface torus:2000 --field rotation:16,16,16 -o a.csv");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err, "aeolic: warning: the flow has no critical point on this surface\n");
    const std::string text = fileText(folder_ / "a.csv");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

TEST_F(Cli, ExtractWritesStreamlines)
{
    const std::string scene = "extract streamlines --surface torus:2000 --field rotation:16,16,16 ";
    const Outcome csv = aeolic(scene + "--color-by rotation:mag -o a.csv"),
                  vtp = aeolic(scene + "--overlay streamlines:60 -o a.vtp");
    EXPECT_EQ(csv.exitCode, 0) << csv.err;
    EXPECT_EQ(vtp.exitCode, 0) << vtp.err;
    EXPECT_EQ(csv.out + csv.err + vtp.out + vtp.err, "");
    const std::string text = fileText(folder_ / "a.csv");
    EXPECT_TRUE(text.starts_with("line,length,closed,x,y,z,vector x,vector y,vector z,|rotation|\n0,"));
    EXPECT_TRUE(fileText(folder_ / "a.vtp").starts_with("<VTKFile type=\"PolyData\""));
    std::ofstream(folder_ / "still.vtk") << "# vtk DataFile Version 3.0\nstill\nASCII\nDATASET POLYDATA\n"
                                            "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n"
                                            "POINT_DATA 3\nVECTORS U float\n0 0 0 0 0 0 0 0 0\n";
    const Outcome none = aeolic("extract streamlines --surface still.vtk -o b.csv");
    EXPECT_EQ(none.exitCode, 0);
    EXPECT_NE(none.err.find("aeolic: warning: the flow has no streamline on this surface that is long enough\n"),
              std::string::npos)
        << none.err;
}

TEST_F(Cli, ExtractWritesOpenLines)
{
    // Flow that comes together at y = 0.
    std::ofstream file(folder_ / "a.vtk");
    file
        << "# vtk DataFile Version 3.0\nsheet\nASCII\nDATASET STRUCTURED_GRID\nDIMENSIONS 41 41 1\nPOINTS 1681 float\n";
    for (int i = 0; i < 1681; ++i) file << i % 41 - 20 << ' ' << i / 41 - 20 << " 0\n";
    file << "POINT_DATA 1681\nVECTORS U float\n";
    for (int i = 0; i < 1681; ++i) file << "20 " << -4 * (i / 41 - 20) << " 0\n";
    file.close();
    const Outcome found = aeolic("extract separation --field a.vtk --surface boundary -o a.csv");
    EXPECT_EQ(found.exitCode, 0) << found.err;
    const std::string text = fileText(folder_ / "a.csv");
    EXPECT_NE(text.find("\n0,separation,0,0,"), std::string::npos) << text.substr(0, 300);
    const Outcome none = aeolic("extract separation --surface torus:2000 --field rotation:16,16,16 -o b.vtp");
    EXPECT_EQ(none.exitCode, 0);
    EXPECT_EQ(none.err, "aeolic: warning: streamlines gather at no line on this surface\n");
}

/// What the picture shows is what is written.
TEST_F(Cli, ExtractTakesAScenesOwnFile)
{
    EXPECT_EQ(aeolic(kScene + "--persistence 0.3 -o a.csv").exitCode, 0);
    std::ofstream(folder_ / "s.json") << R"({"surface":{"spec":"torus:2000"},"field":{"spec":"abc:16,16,16"},)"
                                         R"("shading":{"overlay":"topology","persistence":0.3}})";
    const Outcome outcome = aeolic("extract topology s.json -o b.csv");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(fileText(folder_ / "a.csv"), fileText(folder_ / "b.csv"));
}

TEST_F(Cli, ProbeTellsWhatAPixelShows)
{
    const std::string scene = " --surface torus:2000 --field abc:16,16,16 --color-by abc:mag --size 90x70";
    const Outcome found = aeolic("probe 45,20" + scene), none = aeolic("probe 0,0" + scene);
    EXPECT_EQ(found.exitCode, 0) << found.err;
    EXPECT_EQ(found.err, "");
    for (const char* name : {"position ", "depth ", "surface           torus", "triangle ", "normal ", "vector ",
                             "its length ", "along the surface ", "|abc| "})
        EXPECT_NE(("\n" + found.out).find("\n" + std::string(name)), std::string::npos) << name << found.out;
    EXPECT_EQ(none.exitCode, 0) << none.err;
    EXPECT_EQ(none.out, "background\n");
    for (const char* pixel : {"45", "45,", "45,20,3", "a,b", "4.5,2"}) {
        const Outcome wrong = aeolic(std::string("probe ") + pixel + scene);
        EXPECT_EQ(wrong.exitCode, 2);
        EXPECT_EQ(wrong.err, fmt::format("aeolic: PIXEL: found '{}'; expected X,Y, counted from the upper left: "
                                         "400,300\n",
                                         pixel));
    }
    EXPECT_EQ(aeolic("probe 90,0" + scene).err, "aeolic: pick: pixel 90,0; expected 0,0 to 89,69\n");
}

}  // namespace
}  // namespace aeolic
