#include "data/load/series/time_series.h"

#include <gtest/gtest.h>

#include <limits>

#include "aeolic/error.h"
#include "data/vtk/testing/sample_files.h"

namespace aeolic {
namespace {

using namespace test;

void expectBracket(const Around& found, double first, double second, double weight)
{
    EXPECT_EQ(found.first, first);
    EXPECT_EQ(found.second, second);
    EXPECT_DOUBLE_EQ(found.weight, weight);
}

TEST(TimeSeries, AMomentLiesBetweenTwoSteps)
{
    const std::vector<double> times{-1, 0, 4};
    expectBracket(bracketOf(times, -1), 0, 0, 0);
    expectBracket(bracketOf(times, -0.75), 0, 1, 0.25);
    expectBracket(bracketOf(times, 0), 1, 1, 0);
    expectBracket(bracketOf(times, 1), 1, 2, 0.25);
    expectBracket(bracketOf(times, 4), 2, 2, 0);
    expectBracket(bracketOf({7}, 7), 0, 0, 0);
}

TEST(TimeSeries, OutsideItIsTheNearestEnd)
{
    expectBracket(bracketOf({1, 2}, -1e30), 0, 0, 0);
    expectBracket(bracketOf({1, 2}, 1e30), 1, 1, 0);
}

TEST(TimeSeries, HugeTimesDoNotOverflow)
{
    const double huge = std::numeric_limits<double>::max();
    expectBracket(bracketOf({-huge, huge}, 0), 0, 1, 0.5);
}

TEST(TimeSeries, TimesOfBothAreMerged)
{
    EXPECT_EQ(mergedTimes({0, 1, 2}, {0.5, 1, 3}), (std::vector<double>{0, 0.5, 1, 2, 3}));
    EXPECT_EQ(mergedTimes({}, {1, 2}), (std::vector<double>{1, 2}));
}

TEST(TimeSeries, FramesAreSpreadOverTheRangeWithBothEnds)
{
    std::vector<double> moments;
    for (int i = -1; i <= 5; ++i) moments.push_back(momentOfFrame({1, 3}, i, 5));
    EXPECT_EQ(moments, (std::vector<double>{1, 1, 1.5, 2, 2.5, 3, 3}));
    EXPECT_EQ(momentOfFrame({1, 3}, 0, 1), 1);
    EXPECT_EQ(momentOfFrame({1, 3}, 1, 2), 3);
}

class SeriesFiles : public testing::Test {
protected:
    std::string write(const std::string& name, const std::string& text) const
    {
        writeBytes(folder_.file(name), text);
        return folder_.file(name);
    }
    std::string pvd(const std::string& entries) const
    {
        return write("run.pvd", "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\"><Collection>" +
                                    entries + "</Collection></VTKFile>");
    }
    static std::string entry(const std::string& time, const std::string& file, int part = 0)
    {
        return "<DataSet timestep=\"" + time + "\" group=\"\" part=\"" + std::to_string(part) + "\" file=\"" + file +
               "\"/>";
    }
    static std::string complaint(const std::string& path)
    {
        try {
            readTimeSeries(path);
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            EXPECT_TRUE(std::string(error.what()).starts_with(path)) << error.what();
            return error.what();
        }
        return "";
    }
    void expectComplaint(const std::string& path, const std::string& about) const
    {
        EXPECT_NE(complaint(path).find(about), std::string::npos) << complaint(path);
    }

    TempFolder folder_;
};

TEST_F(SeriesFiles, PvdNamesFilesBesideIt)
{
    std::filesystem::create_directory(folder_.path() / "data");
    write("data/a.vti", "x");
    write("data/b.vti", "x");
    const TimeSeries series = readTimeSeries(pvd(entry("0.5", "data/a.vti") + entry("1e1", "data/b.vti")));
    EXPECT_EQ(series.times, (std::vector<double>{0.5, 10}));
    ASSERT_EQ(series.steps.size(), 2u);
    EXPECT_EQ(series.steps[1].path, folder_.file("data/b.vti"));
    EXPECT_FALSE(series.steps[1].timeInFile);
}

/// Whether they stand in the file time by time or part by part, and whichever stands first.
TEST_F(SeriesFiles, PartsOfAStepAreInTheOrderOfTheirNumbers)
{
    for (const char* name : {"a0.vtp", "a1.vtp", "a10.vtp", "b0.vtp", "b1.vtp", "b10.vtp"}) write(name, "x");
    const std::string a0 = entry("0", "a0.vtp", 0), a1 = entry("0", "a1.vtp", 1), a10 = entry("0", "a10.vtp", 10),
                      b0 = entry("1", "b0.vtp", 0), b1 = entry("1", "b1.vtp", 1), b10 = entry("1", "b10.vtp", 10);
    for (const std::string& entries : {a0 + a1 + a10 + b0 + b1 + b10, a0 + b0 + a1 + b1 + a10 + b10,
                                       a10 + a1 + a0 + b1 + b10 + b0, b10 + a10 + b0 + a0 + b1 + a1}) {
        const TimeSeries series = readTimeSeries(pvd(entries));
        EXPECT_EQ(series.times, (std::vector<double>{0, 1}));
        ASSERT_EQ(series.steps.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i) {
            const std::string name = folder_.file(i == 0 ? "a" : "b");
            EXPECT_EQ(series.steps[i].files(),
                      (std::vector<std::string>{name + "0.vtp", name + "1.vtp", name + "10.vtp"}));
        }
    }
    expectComplaint(pvd(a0 + a1 + entry("0", "b1.vtp", 1)), "have the same time 0");
}

/// As ParaView reads them: without a time it is 0, and files of one time are parts of one data set.
TEST_F(SeriesFiles, PvdNeedsNeitherTimesNorParts)
{
    for (const char* name : {"a0.vtp", "a1.vtp", "b0.vtp", "b1.vtp"}) write(name, "x");
    const auto plain = [](const std::string& file) { return "<DataSet file=\"" + file + "\"/>"; };
    const TimeSeries untimed = readTimeSeries(pvd(plain("a1.vtp") + plain("a0.vtp")));
    EXPECT_EQ(untimed.times, (std::vector<double>{0}));
    EXPECT_EQ(untimed.steps[0].files(), (std::vector<std::string>{folder_.file("a1.vtp"), folder_.file("a0.vtp")}));
    for (const std::string& entries :
         {entry("0", "a0.vtp") + entry("0", "a1.vtp") + entry("1", "b0.vtp") + entry("1", "b1.vtp"),
          entry("0", "a0.vtp") + entry("1", "b0.vtp") + entry("0", "a1.vtp") + entry("1", "b1.vtp")}) {
        const TimeSeries series = readTimeSeries(pvd(entries));
        EXPECT_EQ(series.times, (std::vector<double>{0, 1}));
        ASSERT_EQ(series.steps.size(), 2u);
        EXPECT_EQ(series.steps[0].files(), (std::vector<std::string>{folder_.file("a0.vtp"), folder_.file("a1.vtp")}));
        EXPECT_EQ(series.steps[1].files(), (std::vector<std::string>{folder_.file("b0.vtp"), folder_.file("b1.vtp")}));
    }
}

TEST_F(SeriesFiles, ParaViewsJsonNamesFilesBesideIt)
{
    write("a.vtp", "x");
    write("b.vtp", "x");
    const TimeSeries series =
        readTimeSeries(write("s.vtp.series", R"({"file-series-version": "1.0", "files": [{"name": "a.vtp", "time": 0},
                                  {"name": "b.vtp", "time": 2.5}]})"));
    EXPECT_EQ(series.times, (std::vector<double>{0, 2.5}));
    EXPECT_EQ(series.steps[0].path, folder_.file("a.vtp"));
}

TEST_F(SeriesFiles, NumberedFilesAreInTheOrderOfTheirNumbers)
{
    for (const char* name : {"w_9.vti", "w_10.vti", "w_100.vti", "w_.vti", "w_1x.vti", "xw_1.vti", "w_1.vti.bak"})
        write(name, "x");
    const TimeSeries series = readTimeSeries(folder_.file("w_*.vti"));
    EXPECT_EQ(series.times, (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(series.steps[0].path, folder_.file("w_9.vti"));
    EXPECT_EQ(series.steps[1].path, folder_.file("w_10.vti"));
    EXPECT_EQ(series.steps[2].path, folder_.file("w_100.vti"));
    EXPECT_EQ(readTimeSeries(folder_.file("w_%d.vti")).steps.size(), 3u);
}

TEST_F(SeriesFiles, APaddedPatternTakesPaddedNumbersOnly)
{
    for (const char* name : {"w0007.vti", "w0008.vti", "w9.vti", "w12345.vti", "w00009.vti"}) write(name, "x");
    const TimeSeries series = readTimeSeries(folder_.file("w%04d.vti"));
    ASSERT_EQ(series.steps.size(), 3u);
    EXPECT_EQ(series.steps[0].path, folder_.file("w0007.vti"));
    EXPECT_EQ(series.steps[2].path, folder_.file("w12345.vti"));
}

TEST_F(SeriesFiles, AFileMayHaveAWildcardInItsName)
{
    EXPECT_TRUE(namesSeries(folder_.file("a*.vti")));
    write("a*.vti", "x");
    EXPECT_FALSE(namesSeries(folder_.file("a*.vti")));
    EXPECT_FALSE(namesSeries("100%.vti"));
    EXPECT_FALSE(namesSeries("folder*/a.vti"));
    EXPECT_TRUE(namesSeries("a.PVD"));
}

TEST_F(SeriesFiles, TimesMustIncrease)
{
    for (const char* name : {"a.vti", "b.vti"}) write(name, "x");
    expectComplaint(pvd(entry("2", "a.vti") + entry("1", "b.vti")), "expected times that increase");
    expectComplaint(pvd(entry("nan", "a.vti")), "its timestep is 'nan'");
    expectComplaint(pvd(entry("0", "a.vti") + entry("inf", "b.vti")), "its timestep is 'inf'");
    expectComplaint(pvd(entry("1s", "a.vti")), "DataSet 1: its timestep is '1s'");
    expectComplaint(pvd("<DataSet timestep=\"0\"/>"), "DataSet 1: it has no file");
}

TEST_F(SeriesFiles, EveryFileMustBeThereAndOfOneKind)
{
    for (const char* name : {"a.vti", "b.vtu", "other.pvd"}) write(name, "x");
    expectComplaint(pvd(entry("0", "a.vti") + entry("1", "gone.vti")), "gone.vti' is not there");
    expectComplaint(pvd(entry("0", "a.vti") + entry("1", "b.vtu")), "differ in kind");
    expectComplaint(pvd(entry("0", "other.pvd")), "is a series itself");
    expectComplaint(pvd(""), "it names no files");
    expectComplaint(folder_.file("none_*.vti"), "no file has such a name; expected files like none_0.vti");
    expectComplaint(folder_.file("none_%03d.vti"), "expected files like none_000.vti");
    expectComplaint(folder_.file("a_*_*.vti"), "two wildcards");
    expectComplaint(folder_.file("gone/a_*.vti"), "its folder cannot be read");
    expectComplaint(folder_.file("gone.pvd"), "no such file");
}

TEST_F(SeriesFiles, TwoFilesMustNotHaveTheSameNumber)
{
    for (const char* name : {"w1.vti", "w01.vti"}) write(name, "x");
    expectComplaint(folder_.file("w*.vti"), "have the same number");
}

TEST_F(SeriesFiles, DamagedSeriesFilesAreToldFrom)
{
    for (const char* text : {"<VTKFile type=\"Collection\"><Collection>", "no XML", "<A></B>", "<VTKFile/>",
                             "<Collection><DataSet timestep=\"0\" file=\"a\"/></Collection>"})
        EXPECT_NE(complaint(write("bad.pvd", text)), "") << text;
    expectComplaint(write("empty.pvd", ""), "it is empty");
    for (const char* text :
         {"{", "[]", "{}", R"({"files": 3})", R"({"files": []})", R"({"files": ["a"]})",
          R"({"files": [{"name": "a"}]})", R"({"files": [{"time": 1}]})", R"({"files": [{"name": "", "time": 1}]})",
          R"({"files": [{"name": "a", "time": "1"}]})", R"({"files": [{"name": "a", "time": 1e999}]})",
          R"({"file-series-version": "2.0", "files": [{"name": "a", "time": 1}]})", "{}}"})
        EXPECT_NE(complaint(write("bad.vtp.series", text)), "") << text;
}

}  // namespace
}  // namespace aeolic
