#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "data/load/file_info.h"
#include "data/vtk/surface/surface_file.h"
#include "data/vtk/testing/sample_files.h"

/// Files of VTK's XML family that leave open what VTK's readers then make up.

namespace aeolic {
namespace {

using namespace test;

std::string dataArray(const std::string& attributes, const std::string& values)
{
    return "<DataArray format=\"ascii\" " + attributes + ">" + values + "</DataArray>";
}

std::string file(const std::string& type, const std::string& attributes, const std::string& inside)
{
    return "<VTKFile type=\"" + type + "\" version=\"0.1\" byte_order=\"LittleEndian\"><" + type + " " + attributes +
           ">" + inside + "</" + type + "></VTKFile>";
}

const std::string square = dataArray("type=\"Float32\" NumberOfComponents=\"3\"", "0 0 0 1 0 0 1 1 0 0 1 0");
const std::string polys = "<Polys>" + dataArray("type=\"Int64\" Name=\"connectivity\"", "0 1 2 0 2 3") +
                          dataArray("type=\"Int64\" Name=\"offsets\"", "3 6") + "</Polys>";

std::string sheet(const std::string& attributes, const std::string& pointData, const std::string& points = square)
{
    return file("PolyData", attributes,
                "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\"><PointData>" + pointData + "</PointData><Points>" +
                    points + "</Points>" + polys + "</Piece>");
}

std::string pressure(const std::string& attributes)
{
    return dataArray("type=\"Float32\" Name=\"p\" " + attributes, "1 2 3 4");
}

std::string image(const std::string& attributes, const std::vector<std::string>& extents)
{
    std::string pieces;
    for (const std::string& extent : extents)
        pieces += "<Piece Extent=\"" + extent + "\"><CellData>" +
                  dataArray("type=\"Float32\" Name=\"U\" NumberOfComponents=\"3\"", "1 0 0 1 0 0 1 0 0 1 0 0") +
                  "</CellData></Piece>";
    return file("ImageData", "WholeExtent=\"0 2 0 2 0 2\" " + attributes, pieces);
}

class DamagedXml : public testing::Test {
protected:
    TempFolder folder_;

    std::string messageOf(const std::string& name, const std::string& bytes) const
    {
        writeBytes(folder_.file(name), bytes);
        try {
            describeFile(folder_.file(name));
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    void expectRefused(const std::string& name, const std::string& bytes, const std::string& part) const
    {
        const std::string message = messageOf(name, bytes);
        EXPECT_NE(message.find(name + ": " + part), std::string::npos) << part << " is not in: " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
};

TEST_F(DamagedXml, EveryArrayHasEveryTimeStep)
{
    const std::string two = "TimeValues=\"0 1\"";
    EXPECT_EQ(messageOf("a.vtp", sheet(two, pressure("TimeStep=\"0\"") + pressure("TimeStep=\"1\""))), "");
    EXPECT_EQ(messageOf("a.vtp", sheet(two, pressure("TimeStep=\"0 1\""))), "");
    EXPECT_EQ(messageOf("a.vtp", sheet(two, pressure(""))), "");
    const std::string start = "its header cannot be read (a piece or a step of time lacks the ",
                      lacks = start + "PointData array 'p' (Float32 x 1)); expected polygons";
    expectRefused("a.vtp", sheet(two, pressure("TimeStep=\"0\"")), lacks);
    expectRefused("a.vtp", sheet(two, pressure("TimeStep=\"0\"") + pressure("TimeStep=\"5\"")), lacks);
    const std::string first = std::string(square).replace(0, 10, "<DataArray TimeStep=\"0\"");
    expectRefused("a.vtp", sheet(two, "", first), start + "Points array");
}

TEST_F(DamagedXml, EveryArrayHasAName)
{
    expectRefused("a.vtp", sheet("", dataArray("type=\"Float32\"", "1 2 3 4")),
                  "its header cannot be read (one of the PointData arrays has no Name");
}

TEST_F(DamagedXml, AnImagesPlaceIsFinite)
{
    const std::vector<std::string> halves{"0 2 0 2 0 1", "0 2 0 2 1 2"};
    EXPECT_EQ(messageOf("a.vti", image("Spacing=\".1 +1e-1 1\" Origin=\" 0 -1 2 \"", halves)), "");
    expectRefused("a.vti", image("Spacing=\"nan 1 1\"", halves),
                  "its header cannot be read (its Spacing is 'nan 1 1', and not 3 finite numbers)");
    expectRefused("a.vti", image("Spacing=\"0.1\"", halves), "its header cannot be read (its Spacing is '0.1'");
    expectRefused("a.vti", image("Spacing=\"1 1 1 1\"", halves), "its header cannot be read (its Spacing is '1 1 1 1'");
    expectRefused("a.vti", image("Origin=\"inf 0 0\"", halves), "its header cannot be read (its Origin is 'inf 0 0'");
    expectRefused("a.vti", image("Direction=\"1 0 0\"", halves),
                  "its header cannot be read (its Direction is '1 0 0', and not 9 finite numbers)");
}

TEST_F(DamagedXml, PiecesCoverTheWholeGrid)
{
    expectRefused("a.vti", image("", {"0 2 0 2 0 1", "0 2 0 2 0 1"}),
                  "its header cannot be read (its pieces do not cover its WholeExtent '0 2 0 2 0 2')");
    expectRefused("a.vti", image("", {"0 2 0 2 0 1", "0 2 0 2 2 2"}),
                  "its header cannot be read (its pieces do not cover");
    EXPECT_EQ(messageOf("a.vti", image("", {"0 2 0 2 0 1", "0 2 0 2 0 1", "0 2 0 2 1 2"})), "");
}

TEST_F(DamagedXml, NamesOfPiecesAreThoseOfTheXml)
{
    writeBytes(folder_.file("a&b.vtp"), sheet("", ""));
    const std::string path = folder_.file("a.pvtp");
    writeBytes(path, file("PPolyData", "",
                          "<PPoints><PDataArray type=\"Float32\" NumberOfComponents=\"3\"/></PPoints>"
                          "<!-- <Piece Source=\"old.vtp\"/> --><Piece Source=\"a&amp;b.vtp\"/>"));
    EXPECT_EQ(readSurfaceFile(path, {}, {}).mesh.triangles.size(), 2u);
}

/// Processes without cells write pieces of nothing, with arrays or without.
TEST_F(DamagedXml, PiecesOfNothingAddNothing)
{
    writeBytes(folder_.file("full.vtp"), sheet("", dataArray("type=\"Float32\" Name=\"tau\" NumberOfComponents=\"3\"",
                                                             "1 0 0 1 0 0 1 0 0 1 0 0")));
    const std::string points = "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\"></DataArray></Points>";
    writeBytes(folder_.file("none.vtp"), file("PolyData", "", "<Piece NumberOfPoints=\"0\">" + points + "</Piece>"));
    for (const char* order : {"none full", "full none", "none full none", "none none full"}) {
        std::string pieces;
        std::istringstream names(order);
        for (std::string name; names >> name;) pieces += "<Piece Source=\"" + name + ".vtp\"/>";
        const std::string path = folder_.file("a.pvtp");
        writeBytes(path, file("PPolyData", "",
                              "<PPointData><PDataArray type=\"Float32\" Name=\"tau\" NumberOfComponents=\"3\"/>"
                              "</PPointData><PPoints><PDataArray type=\"Float32\" NumberOfComponents=\"3\"/>"
                              "</PPoints>" +
                                  pieces));
        const auto read = readSurfaceFile(path, {true, "tau", ""}, {});
        EXPECT_EQ(read.mesh.triangles.size(), 2u) << order;
        EXPECT_EQ(read.mesh.pointVectors.size(), 4u) << order;
    }
    expectRefused("b.vtp", file("PolyData", "", ""), "its header cannot be read (it has no Piece)");
}

TEST_F(DamagedXml, BlanksBehindTheEndAreNothing)
{
    EXPECT_EQ(messageOf("a.vtp", sheet("", "") + std::string(2000, '\n')), "");
}

/// VTK writes blocks of nothing without Points.
TEST_F(DamagedXml, ABlockOfNothingNeedsNoPoints)
{
    writeSheetFile(folder_.file("full.vtp"));
    writeBytes(folder_.file("empty.vtp"), file("PolyData", "", "<Piece NumberOfPoints=\"0\"></Piece>"));
    const std::string path = folder_.file("a.vtm");
    writeBytes(path, file("vtkMultiBlockDataSet", "",
                          "<DataSet index=\"0\" file=\"full.vtp\"/><DataSet index=\"1\" file=\"empty.vtp\"/>"));
    EXPECT_EQ(readSurfaceFile(path, {true, "tau", ""}, {}).mesh.triangles.size(), 32u);
    expectRefused(
        "b.vtp",
        file("PolyData", "",
             "<Piece NumberOfPoints=\"0\"></Piece><Piece NumberOfPoints=\"4\"><Points>" + square + "</Points></Piece>"),
        "its header cannot be read (the Points of its pieces");
}

/// The range that VTK keeps with an array is not read where the longest vector is infinite.
TEST_F(DamagedXml, RangesThatAreNoNumbersAreLeftOut)
{
    const std::string key =
        "<InformationKey name=\"L2_NORM_RANGE\" location=\"vtkDataArray\" length=\"2\">"
        "<Value index=\"0\">1</Value><Value index=\"1\">inf</Value></InformationKey>";
    EXPECT_EQ(messageOf("a.vtp", sheet("", dataArray("type=\"Float32\" Name=\"p\"", "1 2 3 4" + key))), "");
}

/// VTK keeps types in bytes, and would take 266 for 10, a tetrahedron.
TEST_F(DamagedXml, ATypeThatNoCellHasIsRefused)
{
    const auto tetrahedron = [&](const std::string& type, const std::string& words) {
        return file("UnstructuredGrid", "",
                    "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points>" + square + "</Points><Cells>" +
                        dataArray("type=\"Int64\" Name=\"connectivity\"", "0 1 2 3") +
                        dataArray("type=\"Int64\" Name=\"offsets\"", "4") +
                        dataArray("type=\"" + words + "\" Name=\"types\"", type) + "</Cells></Piece>");
    };
    const std::string beyond = "it cannot be read (the types of its cells have a number that is none from 0 to 255";
    for (const char* words : {"UInt8", "Int8", "Int32", "Int64", "UInt64", "Float32"}) {
        EXPECT_EQ(messageOf("a.vtu", tetrahedron("10", words)), "") << words;
        expectRefused("a.vtu", tetrahedron("99", words), "cell 0 has the type 99; expected a linear or quadratic cell");
    }
    for (const char* words : {"Int32", "Int64", "UInt64", "Float32"})
        for (const std::string type : {"266", "1000"}) expectRefused("a.vtu", tetrahedron(type, words), beyond);
    expectRefused("a.vtu", tetrahedron("-1", "Int32"), beyond);
    // The type 266 in a binary array: first come 4 bytes that say how many bytes follow, then the number itself.
    const std::string binary = "<DataArray type=\"Int32\" Name=\"types\" format=\"binary\">BAAAAAoBAAA=</DataArray>";
    std::string bytes = tetrahedron("10", "Int32");
    const std::size_t at = bytes.rfind("<DataArray"), end = bytes.find("</Cells>");
    bytes.replace(at, end - at, binary);
    expectRefused("a.vtu", bytes, beyond);
}

}  // namespace
}  // namespace aeolic
