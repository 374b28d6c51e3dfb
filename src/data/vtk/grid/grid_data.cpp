#include "data/vtk/grid/grid_data.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkCellDataToPointData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include "aeolic/error.h"
#include "data/vtk/grid/uniform_grid.h"
#include "data/vtk/messages.h"

namespace aeolic {
namespace {

vtkSmartPointer<vtkDataSet> structureOf(vtkDataSet& data)
{
    auto structure = vtkSmartPointer<vtkDataSet>::Take(data.NewInstance());
    structure->CopyStructure(&data);
    return structure;
}

vtkSmartPointer<vtkFloatArray> toPoints(vtkDataSet& data, vtkFloatArray& cellValues, const std::string& path)
{
    auto input = structureOf(data);
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

void GridData::take(vtkDataSet& raw, const GridArrays& arrays)
{
    set = structureOf(raw);
    if (vtkDataArray* ghosts = raw.GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()))
        set->GetCellData()->AddArray(ghosts);
    for (const ArrayInfo& array : arrays.all()) takeArray(raw, array);
    if (!arrays.scalarIsVectorLength()) addMagnitude(arrays.scalar);
    addMagnitude(arrays.contour);
}

void GridData::takeArray(vtkDataSet& raw, const ArrayInfo& array)
{
    vtkDataArray* source = findArray(raw, array.name, array.onPoints);
    const vtkIdType tuples = array.onPoints ? raw.GetNumberOfPoints() : raw.GetNumberOfCells();
    if (!source || source->GetNumberOfTuples() != tuples)
        throw InputError(path,
                         fmt::format("array '{}' has {} values", array.name, source ? source->GetNumberOfTuples() : 0),
                         fmt::format("{}, one for each of the {}", tuples, array.onPoints ? "points" : "cells"));
    vtkSmartPointer<vtkFloatArray> values = toFloats(source);
    auto* all = array.onPoints ? static_cast<vtkFieldData*>(raw.GetPointData()) : raw.GetCellData();
    all->RemoveArray(array.name.c_str());  // Frees doubles at once; floats are shared.
    const auto mine = counted();
    const MaskResult result = maskInvalid(*values, raw, array.onPoints, mine ? &*mine : nullptr);
    tallies.push_back(result.tally(path, array));
    maxMagnitude[array.name] = result.maxMagnitude;
    if (!array.onPoints) {
        values = toPoints(raw, *values, path);
        maxMagnitude[array.name] = maskInvalid(*values, *set, true).maxMagnitude;
    }
    set->GetPointData()->AddArray(values);
}

void GridData::addMagnitude(const std::optional<ScalarChoice>& choice)
{
    if (!choice || !choice->magnitude || set->GetPointData()->HasArray(choice->label().c_str())) return;
    auto* source = vtkFloatArray::SafeDownCast(set->GetPointData()->GetArray(choice->array.name.c_str()));
    auto lengths = magnitudes(*source);
    lengths->SetName(choice->label().c_str());
    set->GetPointData()->AddArray(lengths);
    maxMagnitude[choice->label()] = maxMagnitude[choice->array.name];
}

void GridData::resample(std::optional<double> spacing, const ProgressReport& progress)
{
    const auto image = resampleToUniform(*set, spacing, path, progress);
    set = structureOf(*image);
    for (auto& [name, largest] : maxMagnitude) {
        auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(name.c_str()));
        largest = maskInvalid(*values, *image, true).maxMagnitude;
        set->GetPointData()->AddArray(values);
    }
}

vtkSmartPointer<vtkFloatArray> GridData::release(const std::string& name)
{
    vtkSmartPointer<vtkFloatArray> values = vtkFloatArray::SafeDownCast(set->GetPointData()->GetArray(name.c_str()));
    set->GetPointData()->RemoveArray(name.c_str());
    return values;
}

std::optional<CountedSamples> GridData::counted() const
{
    if (!piece) return std::nullopt;
    return piece->countedIn(piece->extent());
}

}  // namespace aeolic
