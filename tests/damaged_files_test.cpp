#include <gtest/gtest.h>

#include <cstring>

#include "aeolic/error.h"
#include "data/load/file_info.h"
#include "data/vtk/testing/sample_files.h"

/// Files that tests/fuzz/mutate_files.py found, or that would have been found: each crashed a reader, kept it busy for
/// ever, made it take memory without bound, or was read as something else.

namespace aeolic {
namespace {

using namespace test;

class DamagedFile : public testing::Test {
protected:
    TempFolder folder_;

    /// Writes the file and expects one line that names all of `parts`.
    void expectRefused(const std::string& name, const std::string& bytes, const std::vector<std::string>& parts) const
    {
        writeBytes(folder_.file(name), bytes);
        expectFileRefused(name, parts);
    }

    void expectFileRefused(const std::string& name, const std::vector<std::string>& parts) const
    {
        std::string message = "(nothing was refused)";
        try {
            describeFile(folder_.file(name));
        } catch (const InputError& error) {
            message = error.what();
        }
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        for (const std::string& part : parts)
            EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
    }

    void expectRead(const std::string& name, const std::string& bytes) const
    {
        writeBytes(folder_.file(name), bytes);
        EXPECT_NO_THROW(describeFile(folder_.file(name))) << bytes;
    }
};

std::string replaced(std::string text, const std::string& was, const std::string& with)
{
    const std::size_t at = text.find(was);
    EXPECT_NE(at, std::string::npos) << was;
    return at == std::string::npos ? text : text.replace(at, was.size(), with);
}

const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n";

TEST_F(DamagedFile, PlyWithTwoElementsOfAName)
{
    expectRead("a.ply", ply);
    // The second vertices have no normals: there were fewer normals than points.
    const std::string second = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    expectRefused("a.ply", replaced(ply, "end_header\n", second) + "0 0 1\n1 0 1\n0 1 1\n",
                  {"a.ply", "element vertex 3", "once"});
}

TEST_F(DamagedFile, PlyWithTwoPropertiesOfAName)
{
    expectRefused("a.ply", replaced(ply, "property float nx\n", "property float nx\nproperty float nx\n"),
                  {"a.ply", "property float nx", "once"});
}

TEST_F(DamagedFile, PlyWithCountsThatAreNotThere)
{
    for (const std::string count : {"4", "4000000000", "18446744073709551615"})
        expectRefused("a.ply", replaced(ply, "element vertex 3", "element vertex " + count), {"a.ply", "data ends"});
    expectRefused("a.ply", replaced(ply, "3 0 1 2", "300000 0 1 2"), {"a.ply", "a list of 300000"});
}

const std::string nrrd =
    "NRRD0004\ntype: float\ndimension: 4\nsizes: 3 4 4 4\nspacings: nan 1 1 1\nencoding: raw\n"
    "data file: a.raw\n";

TEST_F(DamagedFile, NrrdHeaderCutOffWithinALine)
{
    writeBytes(folder_.file("a.raw"), std::string(3 * 64 * 4, '\0'));
    expectRead("a.nhdr", nrrd);
    for (std::size_t length = 9; length + 1 < nrrd.size(); length += 7) {
        if (nrrd[length - 1] == '\n') continue;
        expectRefused("a.nhdr", nrrd.substr(0, length), {"a.nhdr"});  // VTK waits for a line end for ever.
    }
}

TEST_F(DamagedFile, NrrdThatNamesFilesByPattern)
{
    writeBytes(folder_.file("a.raw"), std::string(3 * 64 * 4, '\0'));
    expectRefused("a.nhdr", replaced(nrrd, "a.raw", "%s%n%s 1 4 1"), {"a.nhdr", "pattern"});
    expectRefused("a.nhdr", replaced(nrrd, "a.raw", "a%d.raw 1 4 0"), {"a.nhdr", "pattern"});  // Steps of 0.
}

TEST_F(DamagedFile, NrrdThatIsSmallerThanItSays)
{
    writeBytes(folder_.file("a.raw"), std::string(3 * 64 * 4, '\0'));
    expectRefused("a.nhdr", replaced(nrrd, "3 4 4 4", "3 400 400 400"), {"a.nhdr"});
    expectRefused("a.nhdr", replaced(nrrd, "3 4 4 4", "3 4 4 -4"), {"a.nhdr", "sizes"});
    expectRefused("a.nhdr", replaced(nrrd, "3 4 4 4", "3 4 4"), {"a.nhdr", "sizes"});
    expectRefused("a.nhdr", replaced(nrrd, "encoding: raw", "encoding: ascii"), {"a.nhdr", "encoding"});
}

std::string dataArray(const std::string& attributes, const std::string& values)
{
    return "<DataArray format=\"ascii\" " + attributes + ">" + values + "</DataArray>";
}

std::string vtp(const std::string& points, const std::string& inside)
{
    return "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"" +
           points + "\" NumberOfPolys=\"2\"><Points>" +
           dataArray("type=\"Float32\" NumberOfComponents=\"3\"", "0 0 0 1 0 0 1 1 0 0 1 0") + "</Points>" + inside +
           "</Piece></PolyData></VTKFile>";
}

std::string polys(const std::string& corners, const std::string& offsets)
{
    return "<Polys>" + dataArray("type=\"Int64\" Name=\"connectivity\"", corners) +
           dataArray("type=\"Int64\" Name=\"offsets\"", offsets) + "</Polys>";
}

TEST_F(DamagedFile, XmlCountsThatAreNotThere)
{
    const std::string sound = polys("0 1 2 0 2 3", "3 6");
    expectRead("a.vtp", vtp("4", sound));
    for (const std::string count : {"5", "4000000000", "1000000000000000", "-1", "99999999999999999999", "x"})
        expectRefused("a.vtp", vtp(count, sound), {"a.vtp"});
    const std::string values = "<PointData>" + dataArray("type=\"Float32\" Name=\"p\"", "1 2 3") + "</PointData>";
    expectRefused("a.vtp", vtp("4", values + sound), {"a.vtp", "\"p\"", "too short"});
    expectRefused("a.vtp", vtp("4", replaced(values, "Name=", "NumberOfComponents=\"-3\" Name=") + sound), {"a.vtp"});
}

TEST_F(DamagedFile, XmlArraysOfTheSameName)
{
    const std::string values = dataArray("type=\"Float32\" Name=\"p\"", "1 2"),
                      others = dataArray("type=\"Float32\" Name=\"q\"", "1 2"), sound = polys("0 1 2 0 2 3", "3 6");
    expectRead("a.vtp", vtp("4", "<CellData>" + values + others + "</CellData>" + sound));
    expectRefused("a.vtp", vtp("4", "<CellData>" + values + others + values + "</CellData>" + sound),
                  {"a.vtp", "CellData", "twice"});
}

/// VTK writes all strings that it finds into an array of as many as were said. So they are not read.
TEST_F(DamagedFile, XmlStringsMoreThanThereAreTuples)
{
    const std::string sound = polys("0 1 2 0 2 3", "3 6");
    for (const std::string bytes : {"97 0 98 99 0", "97 0 98 0 99 0", "0 0 0 0 0 0 0 0"}) {
        const std::string names = dataArray("type=\"String\" Name=\"n\" NumberOfTuples=\"1\"", bytes);
        expectRead("a.vtp", vtp("4", "<CellData>" + names + "</CellData>" + sound));
        expectRead("a.vtp", replaced(vtp("4", sound), "<Piece", "<FieldData>" + names + "</FieldData><Piece"));
    }
}

TEST_F(DamagedFile, XmlOffsetsThatMakeNoCells)
{
    for (const std::string offsets : {"3 7", "3 -6", "6 3", "-3 6", "3 4000000000000", "3"})
        expectRefused("a.vtp", vtp("4", polys("0 1 2 0 2 3", offsets)), {"a.vtp"});
    expectRefused("a.vtp", vtp("4", polys("0 1 2 0 2 4", "3 6")),
                  {"a.vtp", "polygon 1 refers to point 4, which does not exist"});
    expectRefused("a.vtp", vtp("4", polys("0 1 2 0 -2 3", "3 6")), {"a.vtp", "which does not exist"});
}

std::string vtu(const std::string& types, const std::string& faces, const std::string& ends)
{
    const std::string points = dataArray("type=\"Float32\" NumberOfComponents=\"3\"", "0 0 0 1 0 0 0 1 0 0 0 1");
    const std::string polyhedra = faces.empty() ? ""
                                                : dataArray("type=\"Int64\" Name=\"faces\"", faces) +
                                                      dataArray("type=\"Int64\" Name=\"faceoffsets\"", ends);
    return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"><UnstructuredGrid>"
           "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points>" +
           points + "</Points><Cells>" + dataArray("type=\"Int64\" Name=\"connectivity\"", "0 1 2 3") +
           dataArray("type=\"Int64\" Name=\"offsets\"", "4") + dataArray("type=\"UInt8\" Name=\"types\"", types) +
           polyhedra + "</Cells></Piece></UnstructuredGrid></VTKFile>";
}

TEST_F(DamagedFile, CellTypesThatAreNoneOrHaveOtherCorners)
{
    expectRead("a.vtu", vtu("10", "", ""));
    expectRefused("a.vtu", vtu("200", "", ""), {"a.vtu", "type 200"});
    expectRefused("a.vtu", vtu("12", "", ""), {"a.vtu", "type 12", "4 corners", "8"});
    expectRefused("a.vtu", vtu("24", "", ""), {"a.vtu", "type 24"});
    expectRefused("a.vtu", vtu("42", "", ""), {"a.vtu"});
}

TEST_F(DamagedFile, PolyhedraWhoseFacesAreNotThere)
{
    const std::string faces = "4 3 0 1 2 3 0 1 3 3 0 2 3 3 1 2 3";
    expectRead("a.vtu", vtu("42", faces, "17"));
    expectRefused("a.vtu", vtu("42", faces, "400000"), {"a.vtu"});
    expectRefused("a.vtu", vtu("42", replaced(faces, "4 3", "400 3"), "17"), {"a.vtu"});
    expectRefused("a.vtu", vtu("42", replaced(faces, "4 3", "4 -3"), "17"), {"a.vtu"});
    expectRefused("a.vtu", vtu("42", replaced(faces, "0 1 2 3", "0 1 900 3"), "17"), {"a.vtu"});
    expectRefused("a.vtu", vtu("42", faces, "-7"), {"a.vtu"});
}

/// A header word at a place behind the first underscore of the appended data.
std::string withWord(std::string text, std::size_t word, std::uint32_t value)
{
    const std::size_t start = text.find('_', text.find("<AppendedData")) + 1;
    std::memcpy(text.data() + start + 4 * word, &value, 4);
    return text;
}

TEST_F(DamagedFile, AppendedDataThatAreElsewhere)
{
    SheetSample sheet;
    writeSheetFile(folder_.file("a.vtp"), sheet);
    const std::string whole = readBytes(folder_.file("a.vtp"));
    const std::size_t at = whole.find("offset=\"") + 8;
    for (const std::string offset : {"999999", "-8", "99999999999999999", "18446744073709551615"})
        expectRefused("a.vtp", whole.substr(0, at) + offset + whole.substr(whole.find('"', at)), {"a.vtp"});
    expectRefused("a.vtp", whole.substr(0, at) + "999999" + whole.substr(whole.find('"', at)), {"a.vtp", "\"tau\""});
    expectRead("a.vtp", withWord(whole, 0, 0xffffffff));  // The values are there.
    expectRefused("a.vtp", withWord(whole, 0, 4), {"a.vtp", "too short"});
}

TEST_F(DamagedFile, CompressedBlocksThatCannotBe)
{
    SheetSample sheet;
    sheet.encoding = Encoding::zlib;
    writeSheetFile(folder_.file("a.vtp"), sheet);
    const std::string whole = readBytes(folder_.file("a.vtp"));
    expectRefused("a.vtp", withWord(whole, 0, 0xffffffff), {"a.vtp"});
    expectRefused("a.vtp", withWord(whole, 0, 40), {"a.vtp"});
    expectRefused("a.vtp", withWord(whole, 1, 0), {"a.vtp"});
    expectRefused("a.vtp", withWord(whole, 2, 0xfffffff0), {"a.vtp"});
    expectRefused("a.vtp", withWord(whole, 3, 0xffffff), {"a.vtp"});
    expectRefused("a.vtp", replaced(whole, "vtkZLibDataCompressor", "vtkObjectFactory"), {"a.vtp"});
}

TEST_F(DamagedFile, Base64ThatEndsEarly)
{
    const std::string long64(64, 'A');
    std::string text = vtp("4", polys("0 1 2 0 2 3", "3 6"));
    // 48 bytes of three coordinates each are promised: "MAAAAA==" would be the header of 48 bytes.
    text = replaced(text, "format=\"ascii\" type=\"Float32\" NumberOfComponents=\"3\">0 0 0 1 0 0 1 1 0 0 1 0<",
                    "format=\"binary\" type=\"Float32\" NumberOfComponents=\"3\">MAAAAAAA<");
    expectRefused("a.vtp", text, {"a.vtp"});
    expectRefused("a.vtp", replaced(text, "MAAAAAAA", "MA"), {"a.vtp"});
    expectRefused("a.vtp", replaced(text, "MAAAAAAA", ""), {"a.vtp"});
    expectRefused("a.vtp", replaced(text, "MAAAAAAA", "????" + long64), {"a.vtp"});
}

TEST_F(DamagedFile, ExtentsThatNoPieceFills)
{
    writeGridFile(folder_.file("a.vti"));
    const std::string whole = readBytes(folder_.file("a.vti"));
    expectRefused("a.vti", replaced(whole, "WholeExtent=\"0 8 0 7 0 6\"", "WholeExtent=\"0 9 0 7 0 6\""),
                  {"a.vti", "WholeExtent '0 9 0 7 0 6'"});
    expectRefused("a.vti", replaced(whole, "WholeExtent=\"0 8 0 7 0 6\"", "WholeExtent=\"0 8 0 7 0\""),
                  {"a.vti", "WholeExtent"});
    expectRefused("a.vti",
                  replaced(whole, "WholeExtent=\"0 8 0 7 0 6\"", "WholeExtent=\"0 2147483647 0 2147483647 0 6\""),
                  {"a.vti", "WholeExtent"});
    expectRefused("a.vti", replaced(whole, " Extent=\"0 8 0 7 0 6\"", " Extent=\"0 80 0 7 0 6\""), {"a.vti"});
}

TEST_F(DamagedFile, PieceOfAGridThatCannotBeUnpacked)
{
    for (const std::string ending : {".vti", ".vtr", ".vts"}) {
        GridSample grid;
        grid.encoding = Encoding::zlib;
        const std::string name = "all.p" + ending.substr(1);
        writeGridFile(folder_.file(name), grid);
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
            if (entry.path().extension() != ending) continue;
            std::string bytes = readBytes(entry.path().string());
            const std::size_t start = bytes.find('_', bytes.find("<AppendedData")) + 1;
            for (std::size_t at = start + 18; at < start + 24; ++at) bytes[at] = static_cast<char>(~bytes[at]);
            writeBytes(entry.path().string(), bytes);
        }
        expectFileRefused(name, {"all"});  // The piece, or the whole where its reader ends.
    }
}

TEST_F(DamagedFile, BlocksThatNameThemselves)
{
    expectRefused("a.vtm",
                  "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet><DataSet index=\"0\" "
                  "file=\"a.vtm\"/></vtkMultiBlockDataSet></VTKFile>",
                  {"a.vtm", "too deeply"});
}

TEST_F(DamagedFile, BlocksWithoutNumber)
{
    for (const std::string index : {"-1", "x", "99999999999"})
        expectRefused("a.vtm",
                      "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet><DataSet index=\"" +
                          index + "\" file=\"a.vtp\"/></vtkMultiBlockDataSet></VTKFile>",
                      {"a.vtm", "a block of index '" + index + "'"});
}

const std::string legacyStart = "# vtk DataFile Version 4.2\nt\nASCII\n";

TEST_F(DamagedFile, LegacyCellsOfNumbersThatAreNotThere)
{
    const std::string sound = legacyStart +
                              "DATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 0\nPOLYGONS 2 8\n"
                              "3 0 1 2 3 0 2 3\nPOINT_DATA 4\nVECTORS v float\n1 0 0 1 0 0 1 0 0 1 0 0\n";
    expectRead("a.vtk", sound);
    // A last polygon of five corners where three are left is not here: VTK 9.1 reads on beyond its list, and what it
    // finds there decides whether the file is refused.
    expectRefused("a.vtk", replaced(sound, "3 0 2 3", "-3 0 2 3"), {"a.vtk"});
    expectRefused("a.vtk", replaced(sound, "3 0 2 3", "3 0 2 4"), {"a.vtk", "which does not exist"});
#if !defined(__SANITIZE_THREAD__)  // A reader's memory has no limit there, and what is not written takes none.
    expectRefused("a.vtk", replaced(sound, "POLYGONS 2 8", "POLYGONS 2 800000000"), {"a.vtk"});
    expectRefused("a.vtk", replaced(sound, "POINTS 4", "POINTS 4000000000"), {"a.vtk"});
#endif
    expectRefused("a.vtk", replaced(sound, "POINTS 4", "POINTS -4"), {"a.vtk"});
    expectRefused("a.vtk", replaced(sound, "POINT_DATA 4", "POINT_DATA 5"), {"a.vtk"});
    expectRefused("a.vtk", replaced(sound, "VECTORS v", "VECTORS " + std::string(5000, 'v')), {"a.vtk"});
}

TEST_F(DamagedFile, LegacyOffsetsThatDecrease)
{
    const std::string sound =
        "# vtk DataFile Version 5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
        "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 3 7\nOFFSETS vtktypeint64\n0 4 7\nCONNECTIVITY vtktypeint64\n"
        "0 1 2 3 0 1 2\nCELL_TYPES 2\n10\n5\n";
    expectRead("a.vtk", sound);
    expectRefused("a.vtk", replaced(sound, "0 4 7", "0 9 7"), {"a.vtk"});
    expectRefused("a.vtk", replaced(sound, "0 4 7", "0 -4 7"), {"a.vtk"});
    expectRefused("a.vtk", replaced(sound, "0 4 7", "0 4 9"), {"a.vtk"});
    expectRefused("a.vtk", replaced(sound, "10\n5", "10\n500"), {"a.vtk"});
}

TEST_F(DamagedFile, ObjThatRefersToWhatIsNotThere)
{
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";
    expectRead("a.obj", points + "f 1/1/1 2/1/1 3/1/1\n");
    for (const std::string face :
         {"f 1/1/1 2/1/9 3/1/1", "f 1//1 2//1 3//900000", "f 1 2 4", "f 0 1 2", "f -4 1 2", "f 1/1/-9 2/1/1 3/1/1",
          "f 1/1 2 3", "f 1 2", "f 1 2 x", "f 1/ 2/ 3/", "f 1/1/1/1 2 3", "v 1 2", "v 1,5 2 3", "vn 0 1"})
        expectRefused("a.obj", points + "f 1 2 3\n" + face + "\n", {"a.obj", "line"});
}

TEST_F(DamagedFile, ObjFacesOfSeveralKinds)
{
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    expectRead("a.obj", points + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1 2 3\n");
    expectRead("a.obj", points + "vn 0 0 1\nvt 0 0\nf 1/1 2/1 3/1\n");
    expectRead("a.obj", points + "vt 0 0\nf 1/1 2/1 3/1\nf 1 2 3\n");
    expectRead("a.obj", points + "vn 0 0 1\nf 1//1 2//1 3//1\nl 1 2\n");
}

TEST_F(DamagedFile, StlTextInCapitals)
{
    expectRead("a.stl",
               "SOLID a\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\n"
               "ENDLOOP\nENDFACET\nENDSOLID a\n");
}

TEST_F(DamagedFile, SeriesOfNamesWithControlCharacters)
{
    expectRefused("a.vtp.series", R"({"files": [{"name": "a\u0000.vtp", "time": 0}]})", {"files[0]", "control"});
}

}  // namespace
}  // namespace aeolic
