#include "data/vtk/grid/cell_means.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellDataToPointData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>

#include "aeolic/error.h"
#include "data/vtk/messages.h"

namespace aeolic {
namespace {

std::array<int, VTK_NUMBER_OF_CELL_TYPES> dimensionsOfTypes()
{
    std::array<int, VTK_NUMBER_OF_CELL_TYPES> dimensions{};
    vtkNew<vtkGenericCell> cell;
    for (int type = VTK_EMPTY_CELL + 1; type < VTK_NUMBER_OF_CELL_TYPES; ++type) {
        if (!vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type))) continue;
        cell->SetCellType(type);
        dimensions[std::size_t(type)] = cell->GetCellDimension();
    }
    return dimensions;
}

/// Whether cells of different dimensions are in an unstructured grid. Other grids have cells of one kind.
bool isMixed(vtkDataSet& data)
{
    auto* grid = vtkUnstructuredGrid::SafeDownCast(&data);
    if (!grid || !grid->GetCellTypesArray()) return false;
    std::array<bool, VTK_NUMBER_OF_CELL_TYPES> found{};
    const unsigned char* types = grid->GetCellTypesArray()->GetPointer(0);
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
        if (types[cell] < found.size()) found[types[cell]] = true;
    int least = 3, most = 0;
    for (int type = VTK_EMPTY_CELL + 1; type < VTK_NUMBER_OF_CELL_TYPES; ++type) {
        if (!found[std::size_t(type)]) continue;
        least = std::min(least, dimensionOfCells(type));
        most = std::max(most, dimensionOfCells(type));
    }
    return least < most;
}

/// Calls visit(cell, points) for each cell.
template <class Visit>
void forEachCell(vtkDataSet& data, const Visit& visit)
{
    vtkNew<vtkIdList> points;
    for (vtkIdType cell = 0; cell < data.GetNumberOfCells(); ++cell) {
        data.GetCellPoints(cell, points);
        visit(cell, *points);
    }
}

vtkSmartPointer<vtkFloatArray> meansByDimension(vtkDataSet& data, vtkFloatArray& cellValues)
{
    const CountingCells counting = countingCells(data);
    const auto components = std::size_t(cellValues.GetNumberOfComponents());
    std::vector<double> sums(counting.count.size() * components, 0.0);
    forEachCell(data, [&](vtkIdType cell, vtkIdList& points) {
        const int dimension = dimensionOfCells(data.GetCellType(cell));
        for (const vtkIdType point : points)
            if (counting.dimension[std::size_t(point)] == dimension)
                for (std::size_t k = 0; k < components; ++k)
                    sums[std::size_t(point) * components + k] += double(cellValues.GetTypedComponent(cell, int(k)));
    });
    auto means = vtkSmartPointer<vtkFloatArray>::New();
    means->SetName(cellValues.GetName());
    means->SetNumberOfComponents(cellValues.GetNumberOfComponents());
    means->SetNumberOfTuples(vtkIdType(counting.count.size()));
    float* mean = means->GetPointer(0);
    for (std::size_t i = 0; i < sums.size(); ++i)
        mean[i] = float(sums[i] / std::max(1.0, double(counting.count[i / components])));
    return means;
}

vtkSmartPointer<vtkFloatArray> meansByVtk(vtkDataSet& data, vtkFloatArray& cellValues, const std::string& path)
{
    auto input = vtkSmartPointer<vtkDataSet>::Take(data.NewInstance());
    input->CopyStructure(&data);
    if (vtkDataArray* ghosts = data.GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()))
        input->GetCellData()->AddArray(ghosts);  // What is hidden does not count.
    input->GetCellData()->AddArray(&cellValues);
    const VtkMessages messages;
    vtkNew<vtkCellDataToPointData> filter;
    filter->SetInputData(input);
    filter->Update();
    vtkSmartPointer<vtkFloatArray> values =
        vtkFloatArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetArray(cellValues.GetName()));
    if (messages.failed() || !values)
        throw InputError(
            path,
            fmt::format("array '{}' cannot be brought to the points ({})", cellValues.GetName(), messages.firstError()),
            "sound cells");
    return values;
}

}  // namespace

int dimensionOfCells(int vtkType)
{
    static const auto dimensions = dimensionsOfTypes();
    return vtkType > 0 && vtkType < VTK_NUMBER_OF_CELL_TYPES ? dimensions[std::size_t(vtkType)] : 0;
}

int dimensionOfCells(vtkDataSet& data)
{
    int most = 0;
    for (vtkIdType cell = 0; cell < data.GetNumberOfCells() && most < 3; ++cell)
        most = std::max(most, dimensionOfCells(data.GetCellType(cell)));
    return most;
}

CountingCells countingCells(vtkDataSet& data)
{
    CountingCells counting;
    counting.dimension.resize(std::size_t(data.GetNumberOfPoints()), 0);
    counting.count.resize(std::size_t(data.GetNumberOfPoints()), 0);
    forEachCell(data, [&](vtkIdType cell, vtkIdList& points) {
        const auto dimension = std::uint8_t(dimensionOfCells(data.GetCellType(cell)));
        for (const vtkIdType point : points) {
            std::uint8_t& highest = counting.dimension[std::size_t(point)];
            std::uint32_t& count = counting.count[std::size_t(point)];
            if (dimension > highest) count = 0;
            highest = std::max(highest, dimension);
            if (dimension == highest) ++count;
        }
    });
    return counting;
}

vtkSmartPointer<vtkFloatArray> meansAtPoints(vtkDataSet& data, vtkFloatArray& cellValues, const std::string& path)
{
    return isMixed(data) ? meansByDimension(data, cellValues) : meansByVtk(data, cellValues, path);
}

}  // namespace aeolic
