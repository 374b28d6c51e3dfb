#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <set>
#include <string>
#include <vector>

#include "aeolic/renderer.h"
#include "data/fingerprint.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_vtkhdf.h"
#include "data/vtk/testing/sample_writers.h"
#include "reader/cgns/testing/sample_cgns.h"
#include "reader/exodus/testing/sample_exodus.h"
#include "reader/tecplot/testing/sample_tecplot.h"
#include "surface_formats_testing.h"

/// The same surface in every format gives the same bytes of the picture, where the files hold the same numbers.
namespace aeolic {
namespace {

using namespace test;

class FormatsAgree : public testing::Test {
protected:
    /// Draws the surface as a file of the format. `bare`: with the streaks of a built-in field.
    std::vector<unsigned char> draw(const SurfaceFormat& format, const SampleSurface& surface, bool bare = false) const
    {
        const TempFolder folder;
        const std::string path = folder.file(format.file);
        format.write(path, surface);
        SceneDescription description;
        description.surface.spec = path;
        description.field.spec = bare ? "abc:16,16,16" : "";
        description.field.vectors = bare ? "" : format.vectors;
        description.shading.colorBy = bare ? "" : format.scalars;
        description.lic.steps = 20;
        description.output.width = 120;
        description.output.height = 90;
        description.run.backend = BackendChoice::cpu;
        const Picture picture = Renderer(description).render({description.camera});
        return {picture.pixels.begin(), picture.pixels.end()};
    }

    static bool fits(const SurfaceFormat& format, bool onCells, bool doubles)
    {
        return (onCells ? format.onCells : format.onPoints) && (doubles ? format.doubles : format.floats);
    }
};

TEST_F(FormatsAgree, OnValuesAtPointsAndInCells)
{
    for (const bool onCells : {false, true})
        for (const bool doubles : {true, false}) {
            const SampleSurface surface = bentSheet(onCells, doubles, false);
            std::vector<unsigned char> first;
            int compared = 0;
            for (const SurfaceFormat& format : surfaceFormats()) {
                if (!fits(format, onCells, doubles)) continue;
                const auto picture = draw(format, surface);
                ASSERT_GT(std::set<unsigned char>(picture.begin(), picture.end()).size(), 50U) << format.name;
                if (first.empty()) first = picture;
                EXPECT_TRUE(picture == first)
                    << format.name << (onCells ? ", cells" : ", points") << (doubles ? ", doubles" : ", floats");
                ++compared;
            }
            EXPECT_EQ(compared, onCells ? (doubles ? 17 : 21) : (doubles ? 15 : 19));
        }
}

/// Numbers that 32 bits hold exactly are the same in files of either width.
TEST_F(FormatsAgree, OnNumbersOf32And64BitsWhereBothHoldThem)
{
    for (const bool onCells : {false, true}) {
        std::vector<unsigned char> first;
        for (const bool doubles : {true, false})
            for (const SurfaceFormat& format : surfaceFormats()) {
                if (!fits(format, onCells, doubles)) continue;
                const auto picture = draw(format, bentSheet(onCells, doubles, true));
                if (first.empty()) first = picture;
                EXPECT_TRUE(picture == first) << format.name << (doubles ? ", doubles" : ", floats");
            }
    }
}

/// Other numbers are other numbers: what 32 bits lose shows.
TEST_F(FormatsAgree, NotOnWhat32BitsLose)
{
    const SurfaceFormat vtp = surfaceFormats().front();
    SampleSurface fine = bentSheet(false, true, false), coarse = bentSheet(false, false, false);
    for (SampleSurface* surface : {&fine, &coarse})
        for (glm::dvec3& p : surface->points) {
            p.x += 1e6;
            if (surface == &coarse) p.x = double(float(p.x));
        }
    EXPECT_FALSE(draw(vtp, fine) == draw(vtp, coarse));
}

TEST_F(FormatsAgree, OnPlacesWithoutValues)
{
    for (const bool exact : {true, false}) {
        const SampleSurface surface = bentSheet(false, false, exact);
        std::vector<unsigned char> first;
        for (const SurfaceFormat& format : bareSurfaceFormats()) {
            if (!format.onPoints || !format.floats) continue;
            const auto picture = draw(format, surface, true);
            if (first.empty()) first = picture;
            EXPECT_TRUE(picture == first) << format.name;
        }
    }
}

/// The box of the sample writers: 4^3 cells with vectors on the points and a number in each.
vtkSmartPointer<vtkDataSet> boxOfCells()
{
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    auto vectors = newArray(true, "vel", 3, 125), numbers = newArray(true, "pressure", 1, 64);
    for (int i = 0; i < 125; ++i) {
        const glm::dvec3 p(i % 5, i / 5 % 5, i / 25), flow = cgnsFlow(p);
        points->InsertNextPoint(p.x, p.y, p.z);
        vectors->SetTuple3(i, flow.x, flow.y, flow.z);
    }
    grid->SetPoints(points);
    for (int cell = 0; cell < 64; ++cell) {
        const vtkIdType at = cell % 4 + 5 * (cell / 4 % 4) + 25 * (cell / 16);
        const vtkIdType corners[] = {at, at + 1, at + 6, at + 5, at + 25, at + 26, at + 31, at + 30};
        grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
        numbers->SetTuple1(cell, cell);
    }
    grid->GetPointData()->AddArray(vectors);
    grid->GetCellData()->AddArray(numbers);
    return grid;
}

TEST_F(FormatsAgree, OnVolumes)
{
    const TempFolder folder;
    const auto box = boxOfCells();
    writeDataSet(folder.file("a.vtu"), *box, Encoding::raw);
    writeDataSet(folder.file("a.vtk"), *box, Encoding::raw);
    writeVtkHdf(folder.file("a.vtkhdf"), {box});
    writeBytes(folder.file("a.vtm"),
               "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet>"
               "<DataSet index=\"0\" file=\"a.vtu\"/></vtkMultiBlockDataSet></VTKFile>");
    using Cells = SampleCgns::Cells;
    writeSampleCgns(folder.file("a.cgns"), {.cells = Cells::structured});
    writeSampleCgns(folder.file("b.cgns"), {.cells = Cells::hexahedra});
    writeSampleCgns(folder.file("c.cgns"), {.cells = Cells::mixed});
    writeSampleExodus(folder.file("a.e"));
    writeSampleTecplot(folder.file("a.tec"));
    writeSampleTecplot(folder.file("b.tec"), {.ordered = false});
    struct Field {
        const char *file, *vectors, *number;
    };
    const Field fields[] = {{"a.vtu", "vel", "pressure"},
                            {"a.vtk", "vel", "pressure"},
                            {"a.vtkhdf", "vel", "pressure"},
                            {"a.vtm", "vel", "pressure"},
                            {"a.cgns", "Velocity", "Pressure"},
                            {"b.cgns", "Velocity", "Pressure"},
                            {"c.cgns", "Velocity", "Pressure"},
                            {"a.e", "vel", "pressure"},
                            {"a.tec", "UVW", "p"},
                            {"b.tec", "UVW", "p"}};
    for (const char* surface : {"boundary", "slice:2,2,1.3:0.1,0.2,1", "sphere"}) {
        std::string first;
        for (const Field& field : fields) {
            SceneDescription description;
            description.surface.spec = surface;
            description.field.spec = folder.file(field.file);
            description.field.vectors = field.vectors;
            description.shading.colorBy = field.number;
            const std::string found = fingerprint(loadScene(description));
            if (first.empty()) first = found;
            EXPECT_EQ(found, first) << field.file << " on " << surface;
        }
    }
}

}  // namespace
}  // namespace aeolic
