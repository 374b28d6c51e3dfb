#include "data/vtk/file_summary.h"

#include <vtkCompositeDataIterator.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <algorithm>
#include <cmath>

#include "aeolic/error.h"
#include "data/vtk/arrays.h"
#include "data/vtk/file_reader.h"

namespace aeolic {

namespace {

/// Data sets of the file: the blocks, or the one there is.
std::vector<vtkDataSet*> dataSetsOf(vtkDataObject& data)
{
    std::vector<vtkDataSet*> sets;
    if (auto* single = vtkDataSet::SafeDownCast(&data)) sets.push_back(single);
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(&data)) {
        const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
        for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
            if (auto* block = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject())) sets.push_back(block);
    }
    return sets;
}

/// Finite points only: one NaN would spoil VTK's own bounds.
void addBounds(vtkDataSet& data, Bounds& bounds)
{
    double p[3];
    if (vtkImageData::SafeDownCast(&data) || vtkRectilinearGrid::SafeDownCast(&data)) {
        double box[6];
        data.GetBounds(box);
        bounds.add({box[0], box[2], box[4]});
        bounds.add({box[1], box[3], box[5]});
        return;
    }
    for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
        data.GetPoint(i, p);
        if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) bounds.add({p[0], p[1], p[2]});
    }
}

ArraySummary summarize(vtkDataSet& data, const ArrayInfo& info)
{
    vtkDataArray* array = findArray(data, info.name, info.onPoints);
    ArraySummary summary{info.name,
                         info.onPoints ? "points" : "cells",
                         array->GetDataTypeAsString(),
                         info.components,
                         std::nullopt,
                         0,
                         0,
                         info.activeVectors};
    const auto floats = toFloats(array);
    const MaskResult result = maskInvalid(*floats, data, info.onPoints);
    summary.masked = result.masked;
    summary.nonFinite = result.nonFinite;
    double range[2];
    floats->GetFiniteRange(range, info.components == 1 ? 0 : -1);
    if (range[0] <= range[1]) summary.range = {range[0], range[1]};
    return summary;
}

void addArrays(vtkDataSet& data, std::vector<ArraySummary>& arrays)
{
    for (const ArrayInfo& info : arraysOf(data)) {
        if (isMaskName(info.name)) continue;
        const ArraySummary summary = summarize(data, info);
        const auto same = std::find_if(arrays.begin(), arrays.end(), [&](const ArraySummary& a) {
            return a.name == summary.name && a.association == summary.association;
        });
        if (same == arrays.end()) {
            arrays.push_back(summary);
            continue;
        }
        same->masked += summary.masked;
        same->nonFinite += summary.nonFinite;
        if (!same->range)
            same->range = summary.range;
        else if (summary.range)
            same->range = {std::min((*same->range)[0], (*summary.range)[0]),
                           std::max((*same->range)[1], (*summary.range)[1])};
    }
}

void addStructure(vtkDataSet& data, FileSummary& summary)
{
    int dims[3] = {};
    if (auto* image = vtkImageData::SafeDownCast(&data)) {
        image->GetDimensions(dims);
        const double *spacing = image->GetSpacing(), *origin = image->GetOrigin();
        summary.spacingWorld = {spacing[0], spacing[1], spacing[2]};
        summary.originWorld = {origin[0], origin[1], origin[2]};
    } else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&data)) {
        rectilinear->GetDimensions(dims);
    } else if (auto* structured = vtkStructuredGrid::SafeDownCast(&data)) {
        structured->GetDimensions(dims);
    } else {
        return;
    }
    summary.dims = {dims[0], dims[1], dims[2]};
}

void chooseDefaultVectors(const std::vector<ArrayInfo>& arrays, FileSummary& summary)
{
    for (const ArrayInfo& array : arrays)
        if (summary.firstVectors.empty() && array.components == 3 && !array.activeNormals && array.name != "Normals")
            summary.firstVectors = array.name;
    try {
        summary.vectors = chooseVectors(arrays, "", "").name;
    } catch (const InputError&) {  // None or several: the user chooses.
    }
}

}  // namespace

FileSummary summarizeFile(const std::string& path)
{
    FileReader reader(path, FileReader::Use::any);
    const auto data = reader.read({}, "reading");
    FileSummary summary;
    summary.kind = kindOf(*data);
    summary.timeSteps = reader.timeSteps();
    const std::vector<vtkDataSet*> sets = dataSetsOf(*data);
    summary.blocks = vtkMultiBlockDataSet::SafeDownCast(data) ? std::int64_t(sets.size()) : 0;
    summary.isSurface =
        std::any_of(sets.begin(), sets.end(), [](vtkDataSet* s) { return s->GetDataObjectType() == VTK_POLY_DATA; });
    for (vtkDataSet* set : sets) {
        summary.points += set->GetNumberOfPoints();
        summary.cells += set->GetNumberOfCells();
        addBounds(*set, summary.boundsWorld);
        if (set == sets.front()) chooseDefaultVectors(arraysOf(*set), summary);
        addArrays(*set, summary.arrays);
        if (sets.size() == 1) addStructure(*set, summary);
        if (vtkDataArray* time = set->GetFieldData()->GetArray("TimeValue"); time && summary.timeSteps.empty())
            for (vtkIdType i = 0; i < time->GetNumberOfTuples(); ++i) summary.timeSteps.push_back(time->GetTuple1(i));
    }
    return summary;
}

}  // namespace aeolic
