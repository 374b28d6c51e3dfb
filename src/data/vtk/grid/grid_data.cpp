#include "data/vtk/grid/grid_data.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>

#include "aeolic/error.h"
#include "data/vtk/grid/cell_means.h"
#include "data/vtk/grid/hidden_cells.h"
#include "data/vtk/grid/uniform_grid.h"
#include "data/vtk/surface/outer_surface.h"

namespace aeolic {
namespace {

vtkSmartPointer<vtkDataSet> structureOf(vtkDataSet& data)
{
    auto structure = vtkSmartPointer<vtkDataSet>::Take(data.NewInstance());
    structure->CopyStructure(&data);
    return structure;
}

}  // namespace

void GridData::take(vtkDataSet& raw, const GridArrays& arrays)
{
    set = structureOf(raw);
    vtkDataArray* const ghosts = raw.GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
    if (ghosts) set->GetCellData()->AddArray(ghosts);
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(set)) leaveOutHidden(*grid, raw);
    for (const ArrayInfo& array : arrays.all()) takeArray(raw, array);
}

void GridData::addMagnitudes(const GridArrays& arrays)
{
    if (arrays.partOfVectors() == ArrayPart::whole) addMagnitude(arrays.scalar);
    for (const auto& [name, choice] : arrays.contours) addMagnitude(choice);
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
    attributesOf(raw, array.onPoints)->RemoveArray(array.name.c_str());  // Frees doubles at once; floats are shared.
    const auto mine = counted();
    const MaskResult result = maskInvalid(*values, raw, array.onPoints, mine ? &*mine : nullptr);
    tallies.push_back(result.tally(path, array));
    maxMagnitude[array.name] = result.maxMagnitude;
    if (!array.onPoints) {
        values = meansAtPoints(*set, *values, path);
        maxMagnitude[array.name] = maskInvalid(*values, *set, true).maxMagnitude;
        fromCells_.push_back(array.name);
    }
    set->GetPointData()->AddArray(values);
}

void GridData::addMagnitude(const std::optional<ScalarChoice>& choice)
{
    if (!choice || choice->part == ArrayPart::whole || set->GetPointData()->HasArray(choice->label().c_str())) return;
    auto* source = vtkFloatArray::SafeDownCast(set->GetPointData()->GetArray(choice->array.name.c_str()));
    auto values = partOf(*source, choice->part);
    values->SetName(choice->label().c_str());
    set->GetPointData()->AddArray(values);
    maxMagnitude[choice->label()] = maxMagnitude[choice->array.name];
}

/// Arrays that were brought to the points.
std::vector<vtkFloatArray*> GridData::fromCells() const
{
    std::vector<vtkFloatArray*> arrays;
    for (const std::string& name : fromCells_)
        arrays.push_back(vtkFloatArray::SafeDownCast(findArray(*set, name, true)));
    return arrays;
}

PointMeans GridData::outerMeans() const
{
    PointMeans means;
    if (fromCells_.empty()) return means;
    const std::vector<vtkIdType> outer = outerPoints(*structureOf(*set), path);
    const CountingCells counting = countingCells(*set);
    const std::vector<vtkFloatArray*> arrays = fromCells();
    for (vtkFloatArray* array : arrays) means.width += std::uint32_t(array->GetNumberOfComponents());
    for (const vtkIdType point : outer) {
        glm::dvec3 place;
        set->GetPoint(point, &place.x);
        if (!(std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z))) continue;
        means.placesWorld.push_back(place);
        means.points.push_back(std::uint32_t(point));
        means.cells.push_back(counting.count[std::size_t(point)]);
        means.dimensions.push_back(counting.dimension[std::size_t(point)]);
        for (vtkFloatArray* array : arrays)
            for (int k = 0; k < array->GetNumberOfComponents(); ++k)
                means.values.push_back(array->GetTypedComponent(point, k));
    }
    return means;
}

void GridData::takeMeans(const PointMeans& means)
{
    const float* value = means.values.data();
    const std::vector<vtkFloatArray*> arrays = fromCells();
    for (const std::uint32_t point : means.points)
        for (vtkFloatArray* array : arrays)
            for (int k = 0; k < array->GetNumberOfComponents(); ++k)
                array->SetTypedComponent(vtkIdType(point), k, *value++);
    for (std::size_t i = 0; i < arrays.size(); ++i)
        maxMagnitude[fromCells_[i]] = maskInvalid(*arrays[i], *set, true).maxMagnitude;
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
