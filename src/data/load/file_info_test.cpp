#include "data/load/file_info.h"

#include <gtest/gtest.h>

#include <sstream>

#include "aeolic/error.h"
#include "data/vtk/testing/sample_files.h"
#include "test_paths.h"

namespace aeolic {
namespace {

using namespace test;

void expectContains(const std::string& text, const std::string& part)
{
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

TEST(FileInfo, ImageDataSaysWhatItHolds)
{
    const TempFolder folder;
    GridSample sample;
    sample.nanPoints = {5};
    writeGridFile(folder.file("a.vti"), sample);
    const std::string text = describeFile(folder.file("a.vti"));
    expectContains(text, "image data");
    expectContains(text, "9 x 8 x 7");
    expectContains(text, "504");
    expectContains(text, "--vectors U --surface slice:0,0.375,1:0,0,1 -o out.png");
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("  p ")) {
            expectContains(line, "points");
            expectContains(line, "float");
            expectContains(line, "19");     // -1 - 5 + 25
            expectContains(line, "188.5");  // 1 + 12.5 + 175
        } else if (line.starts_with("  U ")) {
            EXPECT_EQ(line.back(), '1') << "one masked value";
        }
    }
}

/// Whatever the axis is: the slice is not seen from its edge.
TEST(FileInfo, AThinVolumeIsSlicedAlongItAndLookedAtStraight)
{
    const TempFolder folder;
    const char* const views[] = {"azimuth=90,elevation=0", "azimuth=0,elevation=0", "azimuth=0,elevation=90"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        GridSample sample;
        sample.spacing[axis] = 0.01;
        writeGridFile(folder.file("a.vti"), sample);
        expectContains(describeFile(folder.file("a.vti")), std::string(" --camera ") + views[axis] + " -o out.png");
    }
}

/// Not a slice, which would be a line. An image is of a uniform grid alone.
TEST(FileInfo, FlatFieldsAreDrawnAsTheyAre)
{
    const TempFolder folder;
    GridSample sample;
    sample.dims[2] = 1;
    for (const char* name : {"a.vti", "a.vtr", "a.vts", "a.vtu"}) {
        SCOPED_TRACE(name);
        const std::string file = folder.file(name);
        writeGridFile(file, sample);
        const std::string text = describeFile(file);
        expectContains(text, std::string("--surface ") + (name[4] == 'i' ? "image" : "boundary") + " --color-by p ");
        EXPECT_EQ(text.find("slice"), std::string::npos) << text;
    }
}

TEST(FileInfo, WhatHasNothingToDrawGetsNoProposal)
{
    const TempFolder folder;
    SheetSample lines, vertices, flat;
    lines.cells = SheetSample::Cells::lines;
    vertices.cells = SheetSample::Cells::vertices;
    flat.cells = SheetSample::Cells::lines;
    flat.degenerate = 2;
    writeSheetFile(folder.file("lines.vtp"), lines);
    writeSheetFile(folder.file("vertices.vtp"), vertices);
    writeSheetFile(folder.file("degenerate.vtp"), flat);
    GridSample row;
    row.dims = {9, 1, 1};
    writeGridFile(folder.file("row.vti"), row);
    writeGridFile(folder.file("row.vtu"), row);
    for (const char* name : {"lines.vtp", "vertices.vtp", "degenerate.vtp", "row.vti", "row.vtu"}) {
        SCOPED_TRACE(name);
        const std::string text = describeFile(folder.file(name));
        expectContains(text, "Nothing to draw: no cell has an area.");
        EXPECT_EQ(text.find("aeolic render"), std::string::npos) << text;
    }
}

TEST(FileInfo, PolygonsWithVectorsNeedNoField)
{
    const std::string text = describeFile(AEOLIC_SOURCE_DIR "/examples/ahmed/ahmed.vtp");
    expectContains(text, "38,447");
    expectContains(text, "76,886");
    expectContains(text, "ahmed.vtp --vectors wallShearStress -o out.png");
}

TEST(FileInfo, MasksAreCounted)
{
    const std::string text = describeFile(AEOLIC_SOURCE_DIR "/examples/ahmed/ahmed_wake.vti");
    expectContains(text, "127 x 43 x 34");
    expectContains(text, "23,050");
    EXPECT_EQ(text.find("vtkValidPointMask"), std::string::npos);
}

TEST(FileInfo, LinesFitAHundredColumns)
{
    const TempFolder folder;
    writeGridFile(folder.file("a.vtu"));
    writeSheetFile(folder.file("s.vtm"));
    for (const char* name : {"a.vtu", "s.vtm"}) {
        std::istringstream lines(describeFile(folder.file(name)));
        for (std::string line; std::getline(lines, line);) {
            if (line.find(folder.path()) != std::string::npos) continue;
            EXPECT_LE(line.size(), 100u) << line;
        }
    }
}

TEST(FileInfo, ASeriesShowsItsStepsAndWhatToTry)
{
    const TempFolder folder;
    for (int i = 0; i < 12; ++i) writeGridFile(folder.file("w_" + std::to_string(10 * i) + ".vti"));
    const std::string text = describeFile(folder.file("w_*.vti"));
    expectContains(text, "a series of image data");
    expectContains(text, "in 12 files");
    expectContains(text, "12, from 0 to 11");
    expectContains(text, "w_10.vti");
    EXPECT_EQ(text.find("w_60.vti"), std::string::npos) << "the middle of a long list is left out";
    expectContains(text, "    11    11  ");
    expectContains(text, "w_110.vti");
    expectContains(text, "--frames 12 --time-range 0,11 -o out.png");
    expectContains(text, "'" + folder.file("w_*.vti") + "'");
}

TEST(FileInfo, StepsInOneFileAreTimes)
{
    const TempFolder folder;
    writeGridSteps(folder.file("steps.vti"), {{}, {}, {}});
    const std::string text = describeFile(folder.file("steps.vti"));
    expectContains(text, "3, from 0 to 2");
    expectContains(text, "--time 1 -o out.png");
}

TEST(FileInfo, AFileNameWithSpacesIsQuotedForTheShell)
{
    const TempFolder folder;
    writeSheetFile(folder.file("it's a sheet.stl"));
    expectContains(describeFile(folder.file("it's a sheet.stl")), "it'\\''s a sheet.stl'");
}

TEST(FileInfo, WhatIsBuiltInIsNoMisspeltFile)
{
    const auto error = [](const char* path) {
        try {
            describeFile(path);
        } catch (const InputError& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_EQ(
        error("teapot:500"),
        "teapot:500: a built-in surface; expected a file; 'aeolic render --surface teapot:500 --field abc' draws it");
    EXPECT_EQ(error("gyre"),
              "gyre: a built-in flow; expected a file; 'aeolic render --surface torus --field gyre' draws it");
}

TEST(FileInfo, UnknownFilesAreRefusedLikeWhenLoading)
{
    const TempFolder folder;
    EXPECT_THROW(describeFile(folder.file("none.vti")), InputError);
}

}  // namespace
}  // namespace aeolic
