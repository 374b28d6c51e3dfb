#include "data/vtk/linear_cells.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "base/memory.h"
#include "data/vtk/lagrange_cells.h"

namespace aeolic {
namespace {

/// The cuts of a grid's cells, each made once.
class Cuts {
public:
    explicit Cuts(vtkUnstructuredGrid& grid) : grid_(grid)
    {
        vtkDataArray* degrees = grid.GetCellData()->GetHigherOrderDegrees();
        if (!degrees) degrees = grid.GetCellData()->GetArray(kHigherOrderDegrees);
        if (degrees && degrees->GetNumberOfComponents() == 3 && degrees->GetNumberOfTuples() == grid.GetNumberOfCells())
            degrees_ = degrees;
    }

    /// Nothing where the cell stays.
    const LagrangeCut* of(vtkIdType cell)
    {
        const int type = grid_.GetCellType(cell);
        if (!isOfHigherOrder(type)) return nullptr;
        std::array<int, 3> degrees{0, 0, 0};
        for (std::size_t k = 0; degrees_ && k < 3; ++k)
            degrees[k] = int(std::clamp(degrees_->GetComponent(cell, int(k)), 0.0, 1e3));
        const vtkIdType points = grid_.GetCells()->GetCellSize(cell);
        const auto [at, isNew] = known_.try_emplace({type, points, degrees});
        if (isNew) at->second = lagrangeCut(type, points, degrees);
        return at->second ? &*at->second : nullptr;
    }

private:
    vtkUnstructuredGrid& grid_;
    vtkDataArray* degrees_ = nullptr;
    std::map<std::tuple<int, vtkIdType, std::array<int, 3>>, std::optional<LagrangeCut>> known_;
};

void makeLinear(vtkUnstructuredGrid& grid, const std::string& path)
{
    vtkUnsignedCharArray* const types = grid.GetCellTypesArray();
    const vtkIdType count = grid.GetNumberOfCells();
    if (!types || !grid.GetCells() || types->GetNumberOfValues() != count || grid.GetFaces()) return;
    if (std::none_of(types->GetPointer(0), types->GetPointer(0) + count,
                     [](int type) { return isOfHigherOrder(type); }))
        return;
    Cuts cuts(grid);
    std::uint64_t cells = 0, corners = 0;
    for (vtkIdType cell = 0; cell < count; ++cell) {
        const LagrangeCut* cut = cuts.of(cell);
        cells += cut ? cut->points.size() / cut->corners : 1;
        corners += cut ? cut->points.size() : std::uint64_t(grid.GetCells()->GetCellSize(cell));
    }
    requireMemory(path, fmt::format("cutting {} cells into {} linear ones", count, cells), 8 * corners + 32 * cells);
    vtkNew<vtkCellArray> linear;
    linear->AllocateExact(vtkIdType(cells), vtkIdType(corners));
    vtkNew<vtkUnsignedCharArray> linearTypes;
    vtkNew<vtkIdList> sources;
    vtkNew<vtkIdList> own;
    for (vtkIdType cell = 0; cell < count; ++cell) {
        grid.GetCells()->GetCellAtId(cell, own);
        const LagrangeCut* cut = cuts.of(cell);
        if (!cut) {
            linear->InsertNextCell(own);
            linearTypes->InsertNextValue(types->GetValue(cell));
            sources->InsertNextId(cell);
            continue;
        }
        for (std::size_t first = 0; first < cut->points.size(); first += cut->corners) {
            linear->InsertNextCell(int(cut->corners));
            for (std::size_t k = first; k < first + cut->corners; ++k)
                linear->InsertCellPoint(own->GetId(cut->points[k]));
            linearTypes->InsertNextValue(static_cast<unsigned char>(cut->vtkType));
            sources->InsertNextId(cell);
        }
    }
    vtkNew<vtkCellData> values;
    values->CopyAllOn();
    values->CopyAllocate(grid.GetCellData(), sources->GetNumberOfIds());
    for (vtkIdType cell = 0; cell < sources->GetNumberOfIds(); ++cell)
        values->CopyData(grid.GetCellData(), sources->GetId(cell), cell);
    grid.SetCells(linearTypes, linear);
    grid.GetCellData()->ShallowCopy(values);
}

/// Whether each array of the cells has a value for each: else who checks the data says so.
bool hasValues(vtkUnstructuredGrid& grid)
{
    vtkCellData& all = *grid.GetCellData();
    for (int k = 0; k < all.GetNumberOfArrays(); ++k)
        if (all.GetAbstractArray(k)->GetNumberOfTuples() != grid.GetNumberOfCells()) return false;
    return true;
}

}  // namespace

void makeCellsLinear(vtkDataObject& data, const std::string& path)
{
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data); grid && hasValues(*grid)) makeLinear(*grid, path);
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(&data);
    if (!blocks) return;
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
        if (auto* grid = vtkUnstructuredGrid::SafeDownCast(at->GetCurrentDataObject()); grid && hasValues(*grid))
            makeLinear(*grid, path);
}

}  // namespace aeolic
