#include "data/vtk/checks/cell_checks.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include <string>
#include <vector>

#include "aeolic/error.h"

namespace aeolic {
namespace {

template <class Array>
vtkNew<Array> values(const std::vector<int>& from)
{
    vtkNew<Array> array;
    for (const int value : from) array->InsertNextValue(value);
    return array;
}

template <class Array>
std::string complaintOf(const std::vector<int>& offsets, const std::vector<int>& corners, vtkIdType points)
{
    vtkNew<vtkCellArray> cells;
    cells->SetData(values<Array>(offsets), values<Array>(corners));
    try {
        requireSoundCells(*cells, points, "a.vtp");
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

template <class Array>
void expectComplaints()
{
    EXPECT_EQ(complaintOf<Array>({0, 3, 6}, {0, 1, 2, 0, 2, 3}, 4), "none");
    EXPECT_EQ(complaintOf<Array>({0}, {}, 0), "none");
    EXPECT_EQ(complaintOf<Array>({0, 0, 3}, {0, 1, 2}, 3), "none");
    EXPECT_EQ(complaintOf<Array>({0, 3, 6}, {0, 1, 2, 0, 2, 4}, 4),
              "a.vtp: cell 1 refers to point 4, which does not exist; expected points from 0 to 3");
    EXPECT_EQ(complaintOf<Array>({0, 3, 6}, {0, -7, 2, 0, 2, 4}, 4),
              "a.vtp: cell 0 refers to point -7, which does not exist; expected points from 0 to 3");
    EXPECT_EQ(complaintOf<Array>({0, 1}, {0}, 0),
              "a.vtp: cell 0 refers to point 0, which does not exist; expected at least one point");
    const char* order =
        "a.vtp: the corners of a cell do not begin where those before it end; expected cells one after the other";
    EXPECT_EQ(complaintOf<Array>({0, 6, 3}, {0, 1, 2}, 4), order);
    EXPECT_EQ(complaintOf<Array>({0, 3, 7}, {0, 1, 2, 0, 2, 3}, 4), order);
    EXPECT_EQ(complaintOf<Array>({-3, 3}, {0, 1, 2}, 4), order);
    EXPECT_EQ(complaintOf<Array>({0, 3}, {0, 1, 2, 9}, 4), order);
    EXPECT_EQ(complaintOf<Array>({1, 4}, {9, 1, 2, 0}, 4), order);
}

TEST(SoundCells, TheFirstBadOneIsNamed)
{
    expectComplaints<vtkTypeInt32Array>();
    expectComplaints<vtkTypeInt64Array>();
}

TEST(SoundCells, ThoseOfASurfaceAreCalledWhatTheyAre)
{
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(2);
    const auto complaint = [&](auto set) {
        vtkNew<vtkPolyData> surface;
        surface->SetPoints(points);
        vtkNew<vtkCellArray> cells;
        cells->InsertNextCell({0, 1, 2});
        set(*surface, cells.Get());
        try {
            requireSoundCells(*surface, "a.ply");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    const std::string end = " 0 refers to point 2, which does not exist; expected points from 0 to 1";
    EXPECT_EQ(complaint([](vtkPolyData& s, vtkCellArray* c) { s.SetVerts(c); }), "a.ply: vertex" + end);
    EXPECT_EQ(complaint([](vtkPolyData& s, vtkCellArray* c) { s.SetLines(c); }), "a.ply: line" + end);
    EXPECT_EQ(complaint([](vtkPolyData& s, vtkCellArray* c) { s.SetPolys(c); }), "a.ply: polygon" + end);
    EXPECT_EQ(complaint([](vtkPolyData& s, vtkCellArray* c) { s.SetStrips(c); }), "a.ply: strip" + end);
}

}  // namespace
}  // namespace aeolic
