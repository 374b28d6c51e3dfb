#include <gtest/gtest.h>
#include <unistd.h>

#include <functional>

#include "aeolic/error.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"

namespace aeolic {
namespace {

using namespace test;

/// Loads and expects one line that names all of `parts`, and not a word on the terminal from any library.
void expectRefused(const std::string& surface, const std::string& field, const std::vector<std::string>& parts,
                   const std::function<void(SceneDescription&)>& change = {})
{
    SceneDescription description;
    description.surface.spec = surface;
    description.field.spec = field;
    if (change) change(description);
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::string message;
    try {
        loadScene(description);
        message = "(nothing was refused)";
    } catch (const InputError& error) {
        message = error.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find("expected"), std::string::npos) << message;
    for (const std::string& part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
}

class BadInput : public testing::Test {
protected:
    TempFolder folder_;
    std::string grid_ = folder_.file("grid.vti"), mesh_ = folder_.file("mesh.vtu"), sheet_ = folder_.file("sheet.vtp");

    void SetUp() override
    {
        writeGridFile(grid_);
        writeGridFile(mesh_);
        writeSheetFile(sheet_);
    }
};

const char* const everyExtension[] = {".vtp",  ".pvtp", ".vtm", ".stl",  ".ply",  ".obj",    ".vtk",  ".vti",
                                      ".vtr",  ".vts",  ".vtu", ".pvti", ".pvtr", ".pvts",   ".pvtu", ".vtmb",
                                      ".cgns", ".e",    ".exo", ".ex2",  ".exii", ".vtkhdf", ".hdf"};

bool isFieldExtension(const std::string& extension)
{
    return extension == ".vti" || extension == ".vtr" || extension == ".vts" || extension == ".vtu" ||
           extension.starts_with(".pvti") || extension == ".pvtr" || extension == ".pvts" || extension == ".pvtu";
}

void expectFileRefused(const std::string& path, const std::vector<std::string>& parts)
{
    if (isFieldExtension(std::filesystem::path(path).extension().string()))
        expectRefused("teapot:100", path, parts);
    else
        expectRefused(path, "abc:4,4,4", parts);
}

TEST_F(BadInput, MissingFile)
{
    for (const std::string extension : everyExtension)
        expectFileRefused(folder_.file("none" + extension), {"none" + extension, "no such file"});
}

TEST_F(BadInput, Folder)
{
    std::filesystem::create_directory(folder_.file("f.vti"));
    expectRefused("sphere", folder_.file("f.vti"), {"f.vti", "folder"});
}

TEST_F(BadInput, EmptyFile)
{
    for (const std::string extension : everyExtension) {
        writeBytes(folder_.file("empty" + extension), "");
        expectFileRefused(folder_.file("empty" + extension), {"empty" + extension, "it is empty"});
    }
}

TEST_F(BadInput, Garbage)
{
    std::string garbage;
    for (unsigned i = 0; i < 5000; ++i) garbage += static_cast<char>((i * 2654435761u) >> 13);
    for (const std::string extension : everyExtension) {
        writeBytes(folder_.file("garbage" + extension), garbage);
        expectFileRefused(folder_.file("garbage" + extension), {"garbage" + extension});
        writeBytes(folder_.file("text" + extension), "hello\nthis is not data\n");
        expectFileRefused(folder_.file("text" + extension), {"text" + extension});
    }
}

struct Truncation {
    const char* file;
    Encoding encoding;
};

class Truncated : public testing::TestWithParam<Truncation> {};

TEST_P(Truncated, IsRefusedWhereverTheFileEnds)
{
    const TempFolder folder;
    const std::string path = folder.file(GetParam().file), extension = std::filesystem::path(path).extension().string();
    GridSample grid;
    grid.encoding = GetParam().encoding;
    grid.legacyKind = 3;
    SheetSample sheet;
    sheet.encoding = GetParam().encoding;
    sheet.cells = SheetSample::Cells::triangles;
    isFieldExtension(extension) ? writeGridFile(path, grid) : writeSheetFile(path, sheet);
    const std::string whole = readBytes(path);
    for (int part = 1; part < 20; ++part) {
        SCOPED_TRACE(std::to_string(part) + "/20 of " + GetParam().file);
        writeBytes(path, whole.substr(0, whole.size() * std::size_t(part) / 20));
        if (isFieldExtension(extension))  // What is drawn is cut off, and not only what nobody needs.
            expectRefused("teapot:100", path, {GetParam().file}, [](auto& d) { d.shading.colorBy = "p"; });
        else
            expectFileRefused(path, {GetParam().file});
    }
}

INSTANTIATE_TEST_SUITE_P(Files, Truncated,
                         testing::Values(Truncation{"a.vti", Encoding::raw}, Truncation{"a.vti", Encoding::zlib},
                                         Truncation{"a.vti", Encoding::ascii}, Truncation{"a.vtr", Encoding::raw},
                                         Truncation{"a.vts", Encoding::zlib}, Truncation{"a.vtu", Encoding::raw},
                                         Truncation{"a.vtu", Encoding::ascii}, Truncation{"s.vtp", Encoding::raw},
                                         Truncation{"s.vtp", Encoding::zlib}, Truncation{"s.stl", Encoding::raw},
                                         Truncation{"s.stl", Encoding::ascii}, Truncation{"s.ply", Encoding::raw},
                                         Truncation{"s.ply", Encoding::ascii}, Truncation{"s.vtk", Encoding::raw},
                                         Truncation{"s.vtk", Encoding::ascii}));

TEST_F(BadInput, APieceOfAParallelFileIsMissing)
{
    for (const std::string extension : {".pvti", ".pvtr", ".pvts", ".pvtu"}) {
        writeGridFile(folder_.file("all" + extension));
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path()))
            if (entry.path().filename().string().starts_with("all_")) std::filesystem::remove(entry.path());
        expectFileRefused(folder_.file("all" + extension), {"all" + extension});
    }
}

TEST_F(BadInput, UnknownExtension)
{
    writeBytes(folder_.file("a.xyz"), "x");
    expectRefused(folder_.file("a.xyz"), "abc", {"a.xyz", ".vtp", ".stl", ".vtk"});
    expectRefused("sphere", folder_.file("a.xyz"), {"a.xyz", ".vti", ".pvtu", ".vtk"});
    writeBytes(folder_.file("plain"), "x");
    expectRefused(folder_.file("plain"), "abc", {"plain", "no extension"});
}

TEST_F(BadInput, SurfaceAsFieldAndFieldAsSurface)
{
    expectRefused("sphere", sheet_, {"sheet.vtp", "surface", ".vti"});
    expectRefused(grid_, "abc", {"grid.vti", "field", ".vtp", "--surface boundary"});
    writeSheetFile(folder_.file("sheet.vtk"));
    writeGridFile(folder_.file("grid.vtk"));
    expectRefused("sphere", folder_.file("sheet.vtk"), {"sheet.vtk", "polygons"});
    expectRefused(folder_.file("grid.vtk"), "abc", {"grid.vtk", "image data"});
}

TEST_F(BadInput, TheExtensionBelongsToAnotherFormat)
{
    std::filesystem::copy(sheet_, folder_.file("renamed.vti"));
    expectRefused("sphere", folder_.file("renamed.vti"), {"renamed.vti", "image data"});
    std::filesystem::copy(sheet_, folder_.file("renamed.ply"));
    expectRefused(folder_.file("renamed.ply"), "abc", {"renamed.ply", "PLY"});
}

TEST_F(BadInput, ArrayMissingListsThoseThereAre)
{
    expectRefused("sphere", grid_, {"grid.vti", "'V'", "U (points, 3 components)", "p (points"},
                  [](auto& d) { d.field.vectors = "V"; });
    expectRefused("sphere", grid_, {"grid.vti", "'T'", "U (points", "p (points"},
                  [](auto& d) { d.shading.colorBy = "T"; });
    expectRefused(sheet_, grid_, {"'T'", "U (points", "tau (points"}, [](auto& d) { d.shading.colorBy = "T"; });
    expectRefused(sheet_, "", {"sheet.vtp", "'V'", "tau (points", "cellTau (cells"},
                  [](auto& d) { d.field.vectors = "V"; });
    expectRefused(sheet_, "", {"sheet.vtp", "'V:mag'", "cellQ (cells"}, [](auto& d) {
        d.field.vectors = "tau";
        d.shading.colorBy = "V:mag";
    });
    expectRefused("isosurface:T=3", grid_, {"grid.vti", "'T'", "p (points"});
    expectRefused("sphere", "abc", {"'p'", "abc:mag"}, [](auto& d) { d.shading.colorBy = "p"; });
}

TEST_F(BadInput, SeveralArraysOfVectorsAndNoneChosen)
{
    GridSample sample;
    sample.secondVectors = true;
    writeGridFile(folder_.file("two.vti"), sample);
    expectRefused("sphere", folder_.file("two.vti"), {"two.vti", "--vectors", "U (points", "W (points"});
}

TEST_F(BadInput, OneOrTwoComponentsAreNoVectors)
{
    expectRefused("sphere", grid_, {"'p' has 1 component", "3"}, [](auto& d) { d.field.vectors = "p"; });
    for (const int components : {1, 2}) {
        GridSample grid;
        grid.components = components;
        writeGridFile(folder_.file("two.vti"), grid);
        expectRefused("sphere", folder_.file("two.vti"),
                      components == 1 ? std::vector<std::string>{"two.vti", "no array of vectors", "U (points"}
                                      : std::vector<std::string>{"two.vti", "'U' has 2 components", "in flat data"});
    }
    SheetSample sheet;
    sheet.tauComponents = 2;
    writeSheetFile(folder_.file("two.vtp"), sheet);
    expectRefused(folder_.file("two.vtp"), "", {"'tau' has 2 components"}, [](auto& d) { d.field.vectors = "tau"; });
}

TEST_F(BadInput, SeveralComponentsAreNoScalar)
{
    expectRefused("sphere", grid_, {"'U' has 3 components", "U:mag"}, [](auto& d) { d.shading.colorBy = "U"; });
    expectRefused("isosurface:U=1", grid_, {"'U' has 3 components", "U:mag"});
}

TEST_F(BadInput, OnlyLinesOrVerticesAreNoSurface)
{
    for (const auto cells : {SheetSample::Cells::lines, SheetSample::Cells::vertices}) {
        SheetSample sample;
        sample.cells = cells;
        sample.arrays = false;
        writeSheetFile(folder_.file("lines.vtp"), sample);
        expectRefused(folder_.file("lines.vtp"), "abc", {"lines.vtp", "no polygons", "triangle"});
    }
}

TEST_F(BadInput, NoPointIsFinite)
{
    SheetSample sample;
    sample.allNan = true;
    writeSheetFile(folder_.file("nan.vtp"), sample);
    expectRefused(folder_.file("nan.vtp"), "abc", {"nan.vtp", "finite"});
}

TEST_F(BadInput, ACellRefersToAPointThatDoesNotExist)
{
    SheetSample sample;
    sample.arrays = false;
    sample.badIndex = true;
    writeSheetFile(folder_.file("bad.vtp"), sample);
    expectRefused(folder_.file("bad.vtp"), "abc", {"bad.vtp", "which does not exist"});
}

TEST_F(BadInput, PlyHeadersThatLackSomething)
{
    SheetSample sample;
    sample.encoding = Encoding::ascii;
    writeSheetFile(folder_.file("a.ply"), sample);
    const std::string whole = readBytes(folder_.file("a.ply"));
    const auto replaced = [&](const std::string& was, const std::string& with) {
        std::string text = whole;
        text.replace(text.find(was), was.size(), with);
        writeBytes(folder_.file("a.ply"), text);
        return folder_.file("a.ply");
    };
    expectRefused(replaced("property float x", "property float u"), "abc", {"a.ply", "x, y and z"});
    expectRefused(replaced("vertex_indices", "corners"), "abc", {"a.ply", "vertex_indices"});
    expectRefused(replaced("element face", "element edge"), "abc", {"a.ply", "no polygons"});
    expectRefused(replaced("property float y", "property quad y"), "abc", {"a.ply", "property quad y"});
    expectRefused(replaced("format ascii", "format utf-8"), "abc", {"a.ply", "format utf-8"});
    expectRefused(replaced("\n4 0 1 6 5", "\n4 0 1 6 500"), "abc", {"a.ply", "which does not exist"});
    expectRefused(replaced("\n4 0 1 6 5", "\n4 0 1 6 -5"), "abc", {"a.ply", "vertex -5"});
    expectRefused(replaced("element vertex 25", "element vertex 2500000000"), "abc", {"a.ply", "2500000000"});
}

TEST_F(BadInput, IsosurfaceOutsideTheRangeSaysTheRange)
{
    expectRefused("isosurface:p=1000", grid_, {"grid.vti", "isosurface:p=1000", "19", "188.5"});
    expectRefused("isosurface:p=19", mesh_, {"mesh.vtu", "isosurface:p=19"});
}

TEST_F(BadInput, SliceThatMissesTheDataSaysTheBounds)
{
    for (const std::string& file : {grid_, mesh_})
        expectRefused("slice:9,0,0:1,0,0", file, {"slice:9,0,0:1,0,0", "misses", "-1,-0.5,0.25", "1,1.25,1.75"});
}

TEST_F(BadInput, CutsOfFlatDataSayWhatDrawsThem)
{
    GridSample flat;
    flat.dims[2] = 1;
    for (const char* name : {"flat.vti", "flat.vtu"}) {
        writeGridFile(folder_.file(name), flat);
        for (const char* slice : {"slice:0,0,0.25:0,0,1", "slice:0,0,0.25:1,0,0"})
            expectRefused(slice, folder_.file(name), {name, slice, "flat", "--surface boundary", "--surface image"});
    }
    expectRefused("image", folder_.file("flat.vtu"), {"flat.vtu", "--surface image", "--surface boundary"});
}

TEST_F(BadInput, CutWithoutAFieldFile)
{
    expectRefused("boundary", "", {"boundary", "--field"});
    expectRefused("slice:0,0,0:1,0,0", "abc", {"slice", "--field FILE"});
}

TEST_F(BadInput, BuiltInSurfaceHasNoVectorsOfItsOwn)
{
    expectRefused("teapot", "", {"teapot", "--field"});
}

TEST_F(BadInput, FieldThatDoesNotMeetTheSurface)
{
    GridSample sample;
    sample.origin = {100, 100, 100};
    writeGridFile(folder_.file("far.vti"), sample);
    writeGridFile(folder_.file("far.vtu"), sample);
    for (const char* name : {"far.vti", "far.vtu"})
        expectRefused("sphere", folder_.file(name), {name, "does not meet", "100,100,100"});
}

TEST_F(BadInput, FlatDataCannotBeSampledIn3d)
{
    GridSample sample;
    sample.dims = {9, 8, 1};
    writeGridFile(folder_.file("flat.vti"), sample);
    expectRefused("sphere", folder_.file("flat.vti"), {"flat.vti", "flat", "--surface boundary"});
}

TEST_F(BadInput, MoreThanThereIsIsRefusedBeforeMemoryIsTaken)
{
    std::string text = readBytes(grid_);
    const std::string was = "0 8 0 7 0 6", huge = "0 99999 0 99999 0 99999";
    for (std::size_t at; (at = text.find(was)) != std::string::npos;) text.replace(at, was.size(), huge);
    writeBytes(folder_.file("huge.vti"), text);
    expectRefused("sphere", folder_.file("huge.vti"), {"huge.vti", "100000 x 100000 x 100000 points", "memory"});
    expectRefused("sphere", mesh_, {"mesh.vtu", "resampling", "memory"},
                  [](auto& d) { d.field.resampleSpacing = 1e-5; });
}

TEST_F(BadInput, AnExtentLargerThanTheFileIsRefused)
{
    std::string text = readBytes(grid_);
    const std::string was = "0 8 0 7 0 6", larger = "0 9 0 9 0 9";
    for (std::size_t at; (at = text.find(was)) != std::string::npos;) text.replace(at, was.size(), larger);
    writeBytes(folder_.file("larger.vti"), text);
    expectRefused("sphere", folder_.file("larger.vti"), {"larger.vti"});
}

}  // namespace
}  // namespace aeolic
