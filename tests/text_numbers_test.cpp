#include <gtest/gtest.h>

#include "data/load/file_info.h"
#include "data/vtk/testing/sample_files.h"

/// Numbers as solvers, converters and Fortran write them into files of VTK's formats.
namespace aeolic {
namespace {

using namespace test;

class TextNumbers : public testing::Test {
protected:
    TempFolder folder_;

    FileSummary summaryOf(const std::string& name, const std::string& bytes) const
    {
        writeBytes(folder_.file(name), bytes);
        return fileInfo(folder_.file(name)).summary;
    }
};

/// A tetrahedron with vectors U on its points. `points` and `cells` are the numbers of them as the file says them.
std::string tetrahedron(const std::string& points, const std::string& cells, const std::string& components,
                        const std::string& format, const std::string& values)
{
    const std::string array = "<DataArray format=\"" + format + "\" type=";
    return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"><UnstructuredGrid>\n"
           "<Piece NumberOfPoints=\"" +
           points + "\" NumberOfCells=\"" + cells + "\"><PointData>" + array +
           "\"Float32\" Name=\"U\" NumberOfComponents=\"" + components + "\">" + values +
           "</DataArray></PointData><Points>" + array + "\"Float64\" NumberOfComponents=\"" + components +
           "\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>" + array +
           "\"Int32\" Name=\"connectivity\">0 1 2 3</DataArray>" + array + "\"Int32\" Name=\"offsets\">4</DataArray>" +
           array + "\"UInt8\" Name=\"types\">10</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>\n";
}

std::string legacy(const std::string& values)
{
    return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
           "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\nVECTORS U float\n" +
           values + "\n";
}

TEST_F(TextNumbers, AttributesMayHaveBlanksAndSigns)
{
    for (const auto& [points, cells, components] :
         {std::tuple{"   4", " 1", " 3"}, {"+4", "+1", "3 "}, {"4\n", "1", "\t3"}}) {
        const FileSummary file =
            summaryOf("a.vtu", tetrahedron(points, cells, components, "ascii", "1 0 0 1 0 0 1 1 0 1 0 1"));
        EXPECT_EQ(file.points, 4) << points;
        EXPECT_EQ(file.cells, 1) << cells;
        ASSERT_EQ(file.arrays.size(), 1u);
        EXPECT_EQ(file.arrays[0].components, 3) << components;
    }
}

TEST_F(TextNumbers, TheFormatMayBeInCapitals)
{
    EXPECT_EQ(summaryOf("a.vtu", tetrahedron("4", "1", "3", "ASCII", "1 0 0 1 0 0 1 1 0 1 0 1")).points, 4);
}

TEST_F(TextNumbers, OffsetsOfAppendedValuesMayHaveBlanks)
{
    writeSheetFile(folder_.file("a.vtp"));
    std::string bytes = readBytes(folder_.file("a.vtp"));
    for (std::size_t at = 0; (at = bytes.find("offset=\"", at)) != std::string::npos; at += 10)
        bytes.insert(at + 8, "   ");
    EXPECT_EQ(summaryOf("a.vtp", bytes).points, 25);
}

TEST_F(TextNumbers, NotANumberIsMissing)
{
    for (const char* last :
         {"nan nan nan", "NaN 0 0", "-nan 1 1", "inf 0 0", "-INF 1 0", "0 0 nan", "1e400 0 0", "Infinity 0 0"}) {
        const std::string values = std::string("1 0 0 1 0 0 1 1 0 ") + last;
        for (const auto& [name, bytes] :
             {std::pair{"a.vtu", tetrahedron("4", "1", "3", "ascii", values)}, {"a.vtk", legacy(values)}}) {
            const FileSummary file = summaryOf(name, bytes);
            ASSERT_EQ(file.arrays.size(), 1u) << name;
            EXPECT_EQ(file.arrays[0].nonFinite, 1) << name << " " << last;
            EXPECT_EQ((*file.arrays[0].range)[0], 1) << name << " " << last;
        }
    }
}

TEST_F(TextNumbers, FortranWritesExponentsWithoutALetter)
{
    const std::string values = "0.4-102 +1.5D+00 0 2.5-001 0 0 -1.d0 0 0 1e-99999 0 0.5E0";
    for (const auto& [name, bytes] :
         {std::pair{"a.vtu", tetrahedron("4", "1", "3", "ascii", values)}, {"a.vtk", legacy(values)}}) {
        const FileSummary file = summaryOf(name, bytes);
        ASSERT_EQ(file.arrays.size(), 1u) << name;
        EXPECT_EQ(file.arrays[0].nonFinite, 0) << name;
        EXPECT_EQ((*file.arrays[0].range)[0], 0.25) << name;
        EXPECT_EQ((*file.arrays[0].range)[1], 1.5) << name;
    }
}

TEST_F(TextNumbers, BitsAreZeroAndOne)
{
    const std::string start =
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 3 1\nPOINT_DATA 9\n"
        "VECTORS U float\n1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0\n";
    testing::internal::CaptureStderr();
    for (const std::string bits : {"0 0 1 0 1 1 1 1 1", "1 1 1 1 1 1 1 1 1", "0 0 0 0 0 0 0 0 0"}) {
        const FileSummary file = summaryOf("a.vtk", start + "SCALARS flag bit\nLOOKUP_TABLE default\n" + bits + "\n");
        ASSERT_EQ(file.arrays.size(), 2u);
        EXPECT_EQ((*file.arrays[1].range)[0], bits.find('0') == std::string::npos ? 1 : 0);
        EXPECT_EQ((*file.arrays[1].range)[1], bits.find('1') == std::string::npos ? 0 : 1);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace aeolic
