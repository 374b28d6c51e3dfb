#include <gtest/gtest.h>

#include <fmt/format.h>

#include "aeolic/error.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "describe_testing.h"

/// Vectors that files of VTK's formats have as scalars, with two components, or as whole numbers.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

class JoinedVectors : public testing::Test {
protected:
    /// Arrays of numbers on 3 x 3 x `layers` points, as image data in XML or in the legacy form.
    struct Array {
        std::string name, type;
        std::vector<double> tuple;  // The same at all points.
    };
    std::string write(const std::string& name, const std::vector<Array>& arrays, int layers = 3) const
    {
        const bool isXml = name.ends_with("i");
        const int points = 9 * layers;
        std::string text =
            isXml ? fmt::format(
                        "<VTKFile type=\"ImageData\" version=\"0.1\"><ImageData WholeExtent=\"0 2 0 2 0 {0}\" "
                        "Origin=\"0 0 0\" Spacing=\"1 1 1\"><Piece Extent=\"0 2 0 2 0 {0}\"><PointData>",
                        layers - 1)
                  : fmt::format(
                        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 3 {}\n"
                        "ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA {}\nFIELD data {}\n",
                        layers, points, arrays.size());
        for (const Array& array : arrays) {
            text += isXml
                        ? fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">",
                                      array.type, array.name, array.tuple.size())
                        : fmt::format("{} {} {} {}\n", array.name, array.tuple.size(), points,
                                      array.type == "Int32" ? "int" : "double");
            for (int i = 0; i < points; ++i) text += fmt::format("{} ", fmt::join(array.tuple, " "));
            text += isXml ? "</DataArray>" : "\n";
        }
        if (isXml) text += "</PointData></Piece></ImageData></VTKFile>";
        writeBytes(folder_.file(name), text);
        return folder_.file(name);
    }
    static Array scalar(const std::string& name, double value) { return {name, "Float64", {value}}; }
    static glm::vec3 firstOf(const Scene& scene)
    {
        if (!scene.field) return scene.surface.pointVectors.front();
        const float* values = scene.field->floats();
        return {values[0], values[1], values[2]};
    }
    glm::vec3 drawn(const std::string& file, const std::string& vectors = "", const char* surface = "boundary") const
    {
        SceneDescription description = describe(surface, file);
        description.field.vectors = vectors;
        return firstOf(loadScene(description));
    }

    const TempFolder folder_;
};

TEST_F(JoinedVectors, ThreeScalarsAreVectors)
{
    const std::pair<std::string, std::vector<std::string>> spellings[] = {
        {"uvw", {"u", "v", "w"}},
        {"velocity", {"velocity_0", "velocity_1", "velocity_2"}},
        {"Velocity", {"XVelocity", "YVelocity", "ZVelocity"}},
        {"Momentum", {"MomentumX", "MomentumY", "MomentumZ"}}};
    for (const char* name : {"a.vti", "a.vtk"})
        for (const auto& [joined, names] : spellings) {
            if (joined == "Velocity") continue;
            const std::string file =
                write(name, {scalar("p", 7), scalar(names[0], 1), scalar(names[1], 2), scalar(names[2], 3)});
            EXPECT_EQ(drawn(file), glm::vec3(1, 2, 3)) << name << joined;
            EXPECT_EQ(drawn(file, joined), glm::vec3(1, 2, 3)) << name << joined;
            EXPECT_NO_THROW(loadScene(describe("boundary", file, names[1]))) << "the scalars stay";
            const FileInfo info = fileInfo(file);
            EXPECT_NE(info.text.find("--vectors " + joined), std::string::npos) << info.text;
            EXPECT_NE(loadScene(describe("boundary", file, joined + ":mag")).scalarName, "");
        }
    const std::string spaced =
        write("b.vti", {scalar("X Velocity", 1), scalar("Y Velocity", 2), scalar("Z Velocity", 3)});
    EXPECT_EQ(drawn(spaced, "Velocity"), glm::vec3(1, 2, 3));
}

/// What is drawn today stays: an array of three components goes before those that are put together.
TEST_F(JoinedVectors, ArraysOfThreeComponentsGoFirst)
{
    const std::string file =
        write("a.vti", {scalar("u", 1), scalar("v", 2), scalar("w", 3), {"B", "Float32", {4, 5, 6}}});
    EXPECT_EQ(drawn(file), glm::vec3(4, 5, 6));
    EXPECT_EQ(drawn(file, "uvw"), glm::vec3(1, 2, 3));
}

TEST_F(JoinedVectors, TwoComponentsAreEnoughInFlatData)
{
    const std::vector<Array> two{{"velocity", "Float64", {1, 2}}, scalar("p", 3)};
    for (const char* name : {"a.vti", "a.vtk"}) {
        EXPECT_EQ(drawn(write(name, two, 1)), glm::vec3(1, 2, 0)) << name;
        EXPECT_EQ(drawn(write(name, two, 1), "velocity", "image"), glm::vec3(1, 2, 0)) << name;
        EXPECT_EQ(drawn(write(name, {scalar("u", 1), scalar("v", 2)}, 1)), glm::vec3(1, 2, 0)) << name;
        const FileInfo info = fileInfo(folder_.file(name));
        EXPECT_EQ(info.text.find("Nothing to draw"), std::string::npos) << info.text;
        for (const std::string& vectors : {std::string(), std::string("velocity")}) try {
                drawn(write(name, two), vectors);
                FAIL() << name;
            } catch (const InputError& error) {
                EXPECT_NE(std::string(error.what()).find("two are enough in flat data"), std::string::npos)
                    << error.what();
            }
        EXPECT_NE(fileInfo(folder_.file(name)).text.find("Nothing to draw"), std::string::npos);
    }
}

TEST_F(JoinedVectors, FlatDataMayLieAcrossAnyAxis)
{
    GridSample sample;
    sample.components = 2;
    for (const std::size_t across : {0, 1, 2}) {
        sample.dims = {4, 4, 4};
        sample.dims[across] = 1;
        writeGridFile(folder_.file("a.vts"), sample);
        const Scene scene = loadScene(describe("boundary", folder_.file("a.vts")));
        for (const glm::vec3& vector : scene.surface.pointVectors) EXPECT_EQ(vector[int(across)], 0) << across;
    }
}

TEST_F(JoinedVectors, WholeNumbersAreVectorsAndBytesAreColours)
{
    const Array whole{"U", "Int32", {1, -2, 3}}, bytes{"rgb", "UInt8", {1, 2, 3}};
    EXPECT_EQ(drawn(write("a.vti", {whole, bytes})), glm::vec3(1, -2, 3));
    EXPECT_EQ(drawn(write("b.vtk", {whole})), glm::vec3(1, -2, 3));
    EXPECT_THROW(drawn(write("c.vti", {bytes})), InputError);
    EXPECT_EQ(drawn(write("d.vti", {whole, {"V", "Float32", {7, 8, 9}}})), glm::vec3(7, 8, 9)) << "as before";
}

TEST_F(JoinedVectors, OfASurface)
{
    writeBytes(
        folder_.file("s.vtk"),
        "# vtk DataFile Version 3.0\ns\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n"
        "3 0 1 2\nPOINT_DATA 3\nFIELD f 3\nu 1 3 float\n1 1 1\nv 1 3 float\n2 2 2\nw 1 3 float\n3 3 3\n"
        "CELL_DATA 1\nFIELD f 1\ntau 2 1 float\n4 5\n");
    SceneDescription description = describe(folder_.file("s.vtk"), "", "uvw:z");
    EXPECT_EQ(loadScene(description).surface.pointVectors.front(), glm::vec3(1, 2, 3));
    EXPECT_EQ(loadScene(description).surface.pointScalars.front(), 3);
    description.field.vectors = "tau";
    EXPECT_EQ(loadScene(description).surface.pointVectors.front(), glm::vec3(4, 5, 0));
}

/// Axes that run down, and such as the Direction attribute turns.
TEST_F(JoinedVectors, ImagesWithTurnedAxesAreDrawnAsTheyLie)
{
    GridSample sample;
    writeGridFile(folder_.file("straight.vti"), sample);
    const Scene straight = loadScene(describe("slice:0,0.4,1:0,0,1", folder_.file("straight.vti"), "p"));
    sample.origin = {1, 1.25, 1.75};
    sample.spacing = {-0.25, -0.25, -0.25};
    for (const bool onCells : {false, true}) {
        sample.onCells = onCells;
        writeGridFile(folder_.file("down.vti"), sample);
        const Scene down = loadScene(describe("slice:0,0.4,1:0,0,1", folder_.file("down.vti"), "p"));
        ASSERT_EQ(down.field != nullptr, !onCells || straight.field != nullptr);
        if (onCells) continue;
        EXPECT_EQ(down.field->originWorld, straight.field->originWorld);
        for (std::size_t i = 0; i < 3 * straight.field->sampleCount(); ++i)
            ASSERT_NEAR(down.field->floats()[i], straight.field->floats()[i], 1e-5) << i;
    }
    GridSample turned;
    turned.turned = true;
    writeGridFile(folder_.file("turned.vti"), turned);
    const Scene scene = loadScene(describe("boundary", folder_.file("turned.vti"), "p"));
    EXPECT_NEAR(scene.boundsWorld.hi.x - scene.boundsWorld.lo.x, 7 * 0.25, 0.01);
    EXPECT_NEAR(scene.boundsWorld.hi.y - scene.boundsWorld.lo.y, 8 * 0.25, 0.01);
}

/// Faces in an unstructured grid, beside a volume.
TEST_F(JoinedVectors, AGridOfFacesIsASurface)
{
    GridSample sheet, box;
    sheet.dims[2] = 1;
    sheet.origin[2] = 0.6;
    writeGridFile(folder_.file("sheet.vtu"), sheet);
    writeGridFile(folder_.file("box.vti"), box);
    EXPECT_EQ(loadScene(describe(folder_.file("sheet.vtu"), folder_.file("box.vti"), "p")).surface.triangles.size(),
              2u * 8 * 7);
    EXPECT_FALSE(loadScene(describe(folder_.file("sheet.vtu"), "", "U:x")).surface.pointVectors.empty());
    writeGridFile(folder_.file("solid.vtu"), box);
    try {
        loadScene(describe(folder_.file("solid.vtu"), folder_.file("box.vti")));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("--surface boundary"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace aeolic
