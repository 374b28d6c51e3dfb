#include "reader/vtk/summarize.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellTypes.h>
#include <vtkFieldData.h>
#include <vtkGenericCell.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "aeolic/error.h"
#include "data/named_file.h"
#include "data/vtk/arrays.h"
#include "data/vtk/checks/cell_checks.h"
#include "data/vtk/data_objects.h"
#include "data/vtk/grid/straight_image.h"
#include "data/vtk/joined_arrays.h"
#include "reader/vtk/data_file.h"
#include "reader/vtk/format_registry.h"

namespace aeolic {

namespace {

/// Data sets of the file: the blocks, or the one there is.
std::vector<vtkDataSet*> dataSetsOf(vtkDataObject& data)
{
    std::vector<vtkDataSet*> sets;
    if (auto* single = vtkDataSet::SafeDownCast(&data)) sets.push_back(single);
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(&data)) {
        for (const Block& block : blocksOf(*blocks))
            if (auto* set = vtkDataSet::SafeDownCast(block.data)) sets.push_back(set);
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
                         info.activeVectors,
                         {}};
    const auto floats = toFloats(array);
    const MaskResult result = maskInvalid(*floats, data, info.onPoints);
    summary.masked = result.masked;
    summary.nonFinite = result.nonFinite;
    double range[2];
    floats->GetFiniteRange(range, info.components == 1 ? 0 : -1);
    if (range[0] <= range[1]) summary.range = {range[0], range[1]};
    return summary;
}

/// Two components are vectors in flat data alone.
std::vector<ArrayInfo> arraysToChoose(vtkDataSet& data)
{
    std::vector<ArrayInfo> arrays = withJoined(arraysOf(data));
    if (!flatAxisOf(data))
        std::erase_if(arrays, [](const ArrayInfo& array) { return array.components == 2 && !array.of.empty(); });
    return arrays;
}

void addArrays(vtkDataSet& data, const std::vector<ArrayInfo>& infos, std::vector<ArraySummary>& arrays)
{
    for (const ArrayInfo& info : infos) {
        if (isMaskName(info.name)) continue;
        const ArraySummary summary = summarize(data, info);
        const auto same = std::ranges::find_if(arrays, [&](const ArraySummary& a) {
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

/// Whether three points of a polygon or strip are not in a line. A polygon with wrong point numbers counts, too: its
/// fault is reported when it is drawn.
bool hasArea(vtkPolyData& surface)
{
    const auto pointOf = [&](vtkIdType i) {
        double p[3];
        surface.GetPoint(i, p);
        return glm::dvec3(p[0], p[1], p[2]);
    };
    const vtkIdType points = surface.GetNumberOfPoints();
    const auto isArea = [&](vtkIdType a, vtkIdType b, vtkIdType c) {
        if (std::min({a, b, c}) < 0 || std::max({a, b, c}) >= points) return true;
        const glm::dvec3 across = glm::cross(pointOf(b) - pointOf(a), pointOf(c) - pointOf(a));
        return across != glm::dvec3(0) && std::isfinite(glm::dot(across, across));
    };
    for (const bool strips : {false, true}) {
        const auto cells = vtk::TakeSmartPointer((strips ? surface.GetStrips() : surface.GetPolys())->NewIterator());
        for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
            vtkIdType count = 0;
            const vtkIdType* corners = nullptr;
            cells->GetCurrentCell(count, corners);
            for (vtkIdType i = 2; i < count; ++i)
                if (isArea(corners[strips ? i - 2 : 0], corners[i - 1], corners[i])) return true;
        }
    }
    return false;
}

/// The largest of its cells', of one with an area where it is a surface.
int dimensionOf(vtkDataSet& data)
{
    if (auto* polygons = vtkPolyData::SafeDownCast(&data)) return hasArea(*polygons) ? 2 : 0;
    if (auto* image = vtkImageData::SafeDownCast(&data)) return image->GetDataDimension();
    if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&data)) return rectilinear->GetDataDimension();
    if (auto* structured = vtkStructuredGrid::SafeDownCast(&data)) return structured->GetDataDimension();
    vtkNew<vtkCellTypes> types;
    data.GetCellTypes(types);
    vtkNew<vtkGenericCell> cell;
    int dimension = 0;
    for (vtkIdType i = 0; i < types->GetNumberOfTypes(); ++i) {
        cell->SetCellType(types->GetCellType(i));
        dimension = std::max(dimension, cell->GetCellDimension());
    }
    return dimension;
}

/// Where a part is, and its vectors. `flowing`: those alone in which something flows.
void describe(vtkDataSet& set, bool flowing, PartSummary& part)
{
    addBounds(set, part.boundsWorld);
    const auto copy = vtkSmartPointer<vtkDataSet>::Take(set.NewInstance());
    copy->ShallowCopy(&set);
    const std::vector<ArrayInfo> arrays = arraysToChoose(*copy);
    makeVectors(*copy, arrays, nullptr, part.name);
    for (const ArrayInfo& array : arrays) {
        if (array.components < 2 || array.components > 3) continue;
        const auto range = summarize(*copy, array).range;
        if (range && (!flowing || (*range)[1] > 0)) part.vectors.push_back(array.name);
    }
}

/// `infos`: what the file says of its parts, which are the blocks, in their order.
void addParts(vtkDataObject& data, const std::vector<PartInfo>& infos, FileSummary& summary)
{
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(&data);
    if (!blocks) return;
    for (const Block& block : blocksOf(*blocks)) {
        const PartInfo& info = infos.at(summary.parts.size());
        PartSummary part{info.name, info.type, info.groups, block.data->GetNumberOfElements(vtkDataObject::CELL)};
        std::erase(part.groups, part.type);  // Which is one of them, and shown by itself.
        auto* set = vtkDataSet::SafeDownCast(block.data);
        const int dimension = set ? dimensionOf(*set) : 0;
        part.fillsSpace = dimension == 3;
        part.usual = info.usual && dimension == 2;
        if (set) describe(*set, true, part);
        summary.isVolume = summary.isVolume || (part.fillsSpace && part.polygons > 0);
        summary.parts.push_back(std::move(part));
    }
    const auto flows = [](const PartSummary& part) { return !part.vectors.empty(); };
    if (std::ranges::any_of(summary.parts, flows)) return;
    std::size_t next = 0;  // A run that starts from rest.
    for (const Block& block : blocksOf(*blocks)) {
        PartSummary& part = summary.parts[next++];
        if (auto* set = vtkDataSet::SafeDownCast(block.data)) describe(*set, false, part);
    }
}

}  // namespace

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

void addDataSet(vtkDataSet& data, FileSummary& summary)
{
    summary.points += data.GetNumberOfPoints();
    summary.cells += data.GetNumberOfCells();
    addBounds(data, summary.boundsWorld);
    addArrays(data, arraysOf(data), summary.arrays);
}

FileSummary summaryOf(const std::string& path, const ProgressReport& progress)
{
    const FileKind* kind = namedKind(path);
    if (kind && formatOf(*kind).summary) return formatOf(*kind).summary(path, progress);
    DataFile reader(path, FileUse::any);
    const auto data = reader.read(progress, "reading");
    requireSoundData(*data, path);
    const std::vector<PartInfo> infos = reader.parts();
    FileSummary summary;
    summary.kind = infos.empty() ? kindOf(*data) : reader.kind();
    summary.namesFiles = kind->has(kNamesFiles);
    summary.timeSteps = reader.timeSteps();
    const std::vector<vtkDataSet*> sets = dataSetsOf(*data);
    summary.blocks = kind->has(kHasBlocks) ? std::int64_t(sets.size()) : 0;
    summary.isSurface =
        std::ranges::any_of(sets, [](vtkDataSet* s) { return s->GetDataObjectType() == VTK_POLY_DATA; });
    addParts(*data, infos, summary);
    for (std::size_t i = 0; i < sets.size(); ++i) {
        progress("reading", 1);
        const vtkSmartPointer<vtkDataSet> straight = straightened(*sets[i], path);
        vtkDataSet* set = straight;
        const bool derived = i < infos.size() && infos[i].derived;
        summary.points += derived ? 0 : set->GetNumberOfPoints();
        summary.cells += derived ? 0 : set->GetNumberOfCells();
        addBounds(*set, summary.boundsWorld);
        const std::vector<ArrayInfo> arrays = kind->has(kHasMaps) ? arraysOf(*set) : arraysToChoose(*set);
        std::vector<ArrayInfo> candidates = arrays;
        if (!flatAxisOf(*set)) std::erase_if(candidates, [](const ArrayInfo& array) { return array.components == 2; });
        if (i == 0) chooseDefaultVectors(candidates, summary);
        makeVectors(*set, arrays, nullptr, path);
        addArrays(*set, arrays, summary.arrays);
        if (sets.size() == 1) addStructure(*set, summary);
        summary.dimension = std::max(summary.dimension, dimensionOf(*set));
        if (vtkDataArray* time = set->GetFieldData()->GetArray("TimeValue"); time && summary.timeSteps.empty())
            for (vtkIdType k = 0; k < time->GetNumberOfTuples(); ++k) summary.timeSteps.push_back(time->GetTuple1(k));
    }
    if (reader.readsFloats())
        for (ArraySummary& array : summary.arrays)
            for (const ArrayInfo& told : reader.announcedArrays())
                if (told.name == array.name && (told.onPoints ? "points" : "cells") == array.association)
                    array.type = vtkImageScalarTypeNameMacro(told.vtkType);
    return summary;
}

}  // namespace aeolic
