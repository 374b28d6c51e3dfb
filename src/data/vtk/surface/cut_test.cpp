#include "data/vtk/surface/cut.h"

#include <gtest/gtest.h>
#include <vtkAppendFilter.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cmath>
#include <functional>

namespace aeolic {
namespace {

constexpr std::array<int, 3> dims{12, 13, 14};

vtkSmartPointer<vtkDataSet> imageAt(const glm::dvec3& origin)
{
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(dims.data());
    image->SetOrigin(origin.x, origin.y, origin.z);
    image->SetSpacing(0.4, 0.5, 0.3);
    return image;
}

vtkSmartPointer<vtkDataSet> rectilinearAt(const glm::dvec3& origin)
{
    auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    grid->SetDimensions(dims.data());
    const std::array<std::function<void(vtkDataArray*)>, 3> set{[&](auto* x) { grid->SetXCoordinates(x); },
                                                                [&](auto* y) { grid->SetYCoordinates(y); },
                                                                [&](auto* z) { grid->SetZCoordinates(z); }};
    for (int c = 0; c < 3; ++c) {
        vtkNew<vtkDoubleArray> axis;
        for (int i = 0; i < dims[std::size_t(c)]; ++i) axis->InsertNextValue(origin[c] + 0.4 * i + 0.01 * i * i);
        set[std::size_t(c)](axis);
    }
    return grid;
}

vtkSmartPointer<vtkDataSet> structuredAt(const glm::dvec3& origin)
{
    const auto same = rectilinearAt(origin);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < same->GetNumberOfPoints(); ++i) points->InsertNextPoint(same->GetPoint(i));
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(dims.data());
    grid->SetPoints(points);
    return grid;
}

vtkSmartPointer<vtkDataSet> unstructuredAt(const glm::dvec3& origin)
{
    vtkNew<vtkAppendFilter> append;
    append->AddInputData(structuredAt(origin));
    append->Update();
    return append->GetOutput();
}

/// Cells that VTK's cutter of linear cells does not take.
vtkSmartPointer<vtkDataSet> mixedAt(const glm::dvec3& origin)
{
    vtkNew<vtkAppendFilter> append;
    append->AddInputData(structuredAt(origin));
    append->Update();
    vtkUnstructuredGrid& cells = *append->GetOutput();
    vtkNew<vtkIdList> corners;
    cells.GetCellPoints(0, corners);
    cells.InsertNextCell(VTK_VERTEX, 1, corners->GetPointer(0));
    return &cells;
}

/// "s", by where the points lie from `origin`.
void addScalar(vtkDataSet& data, const glm::dvec3& origin)
{
    vtkNew<vtkFloatArray> values;
    values->SetName("s");
    for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
        const double* p = data.GetPoint(i);
        const glm::dvec3 at = glm::dvec3(p[0], p[1], p[2]) - origin;
        values->InsertNextValue(float(std::sin(at.x) + 0.5 * at.y + 0.3 * at.z));
    }
    data.GetPointData()->AddArray(values);
}

struct CutAt {
    vtkSmartPointer<vtkDataSet> data;
    vtkSmartPointer<vtkPolyData> surface;
};

using MakeGrid = vtkSmartPointer<vtkDataSet> (*)(const glm::dvec3&);

CutAt cutAt(MakeGrid make, SurfaceSpec::Kind kind, const glm::dvec3& origin)
{
    CutAt cut{make(origin), nullptr};
    addScalar(*cut.data, origin);
    SurfaceSpec spec;
    spec.kind = kind;
    spec.text = "cut";
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, 1, std::sqrt(0.05)));
    spec.origin = {origin.x + 2.1, origin.y + 2.2, origin.z + 2.3};
    spec.normal = {normal.x, normal.y, normal.z};
    spec.value = 2;
    spec.array = "s";
    cut.surface = cutSurface(*cut.data, spec, "s", "grid", outlineOfCut(*cut.data, spec, "s"));
    return cut;
}

/// The largest difference of a coordinate, beside the origins.
double farthestApart(vtkPolyData& surface, const glm::dvec3& origin, vtkPolyData& other)
{
    double farthest = 0;
    for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i) {
        double p[3], q[3];
        surface.GetPoint(i, p);
        other.GetPoint(i, q);
        for (int c = 0; c < 3; ++c) farthest = std::max(farthest, std::abs(p[c] - origin[c] - q[c]));
    }
    return farthest;
}

void expectSameAnywhere(MakeGrid make, SurfaceSpec::Kind kind)
{
    const CutAt near = cutAt(make, kind, glm::dvec3(0));
    ASSERT_GT(near.surface->GetNumberOfPolys(), 100);
    for (const glm::dvec3 origin : {glm::dvec3(5e5, 5e6, 0), glm::dvec3(1e7), glm::dvec3(-1e7, 3, 1e7)}) {
        const CutAt far = cutAt(make, kind, origin);
        ASSERT_EQ(far.surface->GetNumberOfPolys(), near.surface->GetNumberOfPolys()) << origin.x;
        ASSERT_EQ(far.surface->GetNumberOfPoints(), near.surface->GetNumberOfPoints()) << origin.x;
        EXPECT_LT(farthestApart(*far.surface, origin, *near.surface), 2e-6) << origin.x;
    }
}

TEST(CutFarFromOrigin, SliceOfUniformGridIsTheSame)
{
    expectSameAnywhere(imageAt, SurfaceSpec::Kind::slice);
}

TEST(CutFarFromOrigin, SliceOfRectilinearGridIsTheSame)
{
    expectSameAnywhere(rectilinearAt, SurfaceSpec::Kind::slice);
}

TEST(CutFarFromOrigin, SliceOfCurvilinearGridIsTheSame)
{
    expectSameAnywhere(structuredAt, SurfaceSpec::Kind::slice);
}

TEST(CutFarFromOrigin, SliceOfCellsIsTheSame)
{
    expectSameAnywhere(unstructuredAt, SurfaceSpec::Kind::slice);
}

TEST(CutFarFromOrigin, SliceOfMixedCellsIsTheSame)
{
    expectSameAnywhere(mixedAt, SurfaceSpec::Kind::slice);
}

TEST(CutFarFromOrigin, IsosurfaceOfRectilinearGridIsTheSame)
{
    expectSameAnywhere(rectilinearAt, SurfaceSpec::Kind::isosurface);
}

TEST(CutFarFromOrigin, IsosurfaceOfCurvilinearGridIsTheSame)
{
    expectSameAnywhere(structuredAt, SurfaceSpec::Kind::isosurface);
}

TEST(CutFarFromOrigin, IsosurfaceOfCellsIsTheSame)
{
    expectSameAnywhere(unstructuredAt, SurfaceSpec::Kind::isosurface);
}

TEST(CutFarFromOrigin, BoundaryIsTheSame)
{
    for (const MakeGrid make : {imageAt, rectilinearAt, structuredAt, unstructuredAt})
        expectSameAnywhere(make, SurfaceSpec::Kind::boundary);
}

/// What is moved is a copy.
TEST(CutFarFromOrigin, GridStaysWhereItIs)
{
    const glm::dvec3 origin(1e7, 5, -3);
    for (const MakeGrid make : {imageAt, rectilinearAt, structuredAt}) {
        const CutAt cut = cutAt(make, SurfaceSpec::Kind::slice, origin);
        EXPECT_EQ(cut.data->GetBounds()[0], 1e7);
        EXPECT_EQ(cut.data->GetBounds()[4], -3);
    }
}

/// The arrays of a rectilinear grid come along.
TEST(CutFarFromOrigin, SliceHasTheValuesOfThePlace)
{
    const glm::dvec3 origin(1e7);
    const CutAt cut = cutAt(rectilinearAt, SurfaceSpec::Kind::slice, origin);
    vtkDataArray* const values = cut.surface->GetPointData()->GetArray("s");
    ASSERT_TRUE(values);
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i) {
        const double* p = cut.surface->GetPoint(i);
        const glm::dvec3 at = glm::dvec3(p[0], p[1], p[2]) - origin;
        EXPECT_NEAR(values->GetComponent(i, 0), std::sin(at.x) + 0.5 * at.y + 0.3 * at.z, 0.1);
    }
}

}  // namespace
}  // namespace aeolic
