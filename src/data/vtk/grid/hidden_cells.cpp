#include "data/vtk/grid/hidden_cells.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "base/memory.h"
#include "data/vtk/arrays.h"
#include "data/vtk/grid/cell_means.h"
#include "data/vtk/surface/near_origin.h"

namespace aeolic {
namespace {

/// Which cells and points a data set hides.
class HiddenFlags {
public:
    explicit HiddenFlags(vtkDataSet& data)
        : cells_(flagsOf(*data.GetCellData(), data.GetNumberOfCells())),
          points_(flagsOf(*data.GetPointData(), data.GetNumberOfPoints()))
    {
        if (!points_) return;
        const unsigned char* flags = points_->GetPointer(0);
        const auto isHidden = [](unsigned char flag) { return (flag & vtkDataSetAttributes::HIDDENPOINT) != 0; };
        if (std::none_of(flags, flags + points_->GetNumberOfValues(), isHidden)) points_ = nullptr;
    }

    bool cell(vtkIdType cell) const
    {
        constexpr unsigned char drawnElsewhere = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
        return cells_ && (cells_->GetValue(cell) & drawnElsewhere) != 0;
    }
    bool point(vtkIdType point) const
    {
        return points_ && (points_->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    }
    bool anyPoint() const { return points_ != nullptr; }
    bool anyCell() const
    {
        for (vtkIdType i = 0; cells_ && i < cells_->GetNumberOfValues(); ++i)
            if (cell(i)) return true;
        return false;
    }

private:
    static vtkUnsignedCharArray* flagsOf(vtkDataSetAttributes& all, vtkIdType count)
    {
        auto* flags = vtkUnsignedCharArray::SafeDownCast(all.GetArray(vtkDataSetAttributes::GhostArrayName()));
        return flags && flags->GetNumberOfValues() == count ? flags : nullptr;
    }

    vtkUnsignedCharArray *cells_, *points_;  // Null where nothing is said.
};

/// A structured grid's kind of cells, hidden ones too.
int cellTypeOf(vtkDataSet& data)
{
    int dimension = 0;
    for (vtkIdType cell = 0; cell < data.GetNumberOfCells() && dimension == 0; ++cell)
        dimension = dimensionOfCells(data.GetCellType(cell));
    const bool isAligned = vtkImageData::SafeDownCast(&data) || vtkRectilinearGrid::SafeDownCast(&data);
    switch (dimension) {
        case 3:
            return isAligned ? VTK_VOXEL : VTK_HEXAHEDRON;
        case 2:
            return isAligned ? VTK_PIXEL : VTK_QUAD;
        default:
            return VTK_LINE;
    }
}

}  // namespace

HiddenParts hiddenPartsOf(vtkDataSet& data)
{
    const HiddenFlags hidden(data);
    return {hidden.anyCell(), hidden.anyPoint()};
}

vtkSmartPointer<vtkUnstructuredGrid> shownCells(vtkDataSet& data, const std::string& path)
{
    const HiddenFlags hidden(data);
    const auto all = std::uint64_t(data.GetNumberOfCells());
    requireMemory(path, fmt::format("leaving out what is hidden of {} cells", all), 96 * all);
    vtkNew<vtkCellArray> shown;
    vtkNew<vtkIdList> corners, sources;
    for (vtkIdType cell = 0; cell < data.GetNumberOfCells(); ++cell) {
        data.GetCellPoints(cell, corners);
        const bool isHidden = hidden.cell(cell) || std::any_of(corners->begin(), corners->end(),
                                                               [&](vtkIdType p) { return hidden.point(p); });
        if (isHidden) continue;
        shown->InsertNextCell(corners);
        sources->InsertNextId(cell);
    }
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    auto* set = vtkPointSet::SafeDownCast(&data);
    grid->SetPoints(set ? set->GetPoints() : pointsLess(data, glm::dvec3(0)).Get());
    grid->SetCells(cellTypeOf(data), shown);
    grid->GetPointData()->ShallowCopy(data.GetPointData());
    takeTuples(*data.GetCellData(), *sources, *grid->GetCellData());
    return grid;
}

void leaveOutHidden(vtkUnstructuredGrid& grid, vtkDataSet& marked)
{
    vtkUnsignedCharArray* types = grid.GetCellTypesArray();
    const vtkIdType count = grid.GetNumberOfCells();
    if (!types) return;
    const HiddenFlags hidden(marked);
    vtkNew<vtkIdList> list;
    const auto isHidden = [&](vtkIdType cell) {
        if (types->GetValue(cell) == VTK_EMPTY_CELL || hidden.cell(cell)) return true;
        if (!hidden.anyPoint()) return false;
        grid.GetCellPoints(cell, list);
        return std::any_of(list->begin(), list->end(), [&](vtkIdType point) { return hidden.point(point); });
    };
    vtkIdType first = 0;
    while (first < count && !isHidden(first)) ++first;
    if (first == count) return;
    vtkNew<vtkUnsignedCharArray> shownTypes;
    shownTypes->DeepCopy(types);
    vtkNew<vtkCellArray> shown;
    shown->AllocateExact(count, grid.GetCells()->GetNumberOfConnectivityIds());
    for (vtkIdType cell = 0; cell < count; ++cell) {
        vtkIdType corners = 0;
        const vtkIdType* ids = nullptr;
        if (isHidden(cell))
            shownTypes->SetValue(cell, VTK_EMPTY_CELL);
        else
            grid.GetCells()->GetCellAtId(cell, corners, ids);
        shown->InsertNextCell(corners, ids);
    }
    if (grid.GetFaces())
        grid.SetCells(shownTypes, shown, grid.GetFaceLocations(), grid.GetFaces());
    else
        grid.SetCells(shownTypes, shown);
}

}  // namespace aeolic
