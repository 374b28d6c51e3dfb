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

}  // namespace
}  // namespace aeolic
