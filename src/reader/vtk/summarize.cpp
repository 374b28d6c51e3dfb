#include "reader/vtk/summarize.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellTypes.h>
#include <vtkCompositeDataIterator.h>
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
#include <map>

#include "aeolic/error.h"
#include "data/named_file.h"
#include "data/vtk/arrays.h"
#include "data/vtk/checks/cell_checks.h"
#include "data/vtk/data_kind.h"
#include "data/vtk/surface/blocks.h"
#include "reader/openfoam/foam_surface.h"
#include "reader/vtk/data_file.h"
#include "reader/vtk/foam_patches.h"

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

ArraySummary summarize(const FoamField& field, const std::vector<float>& values)
{
    ArraySummary summary{field.name, "faces", "float", field.components, std::nullopt, 0, 0, false, {}};
    const auto width = std::size_t(field.components);
    for (std::size_t i = 0; i + width <= values.size(); i += width) {
        double squared = 0;
        for (std::size_t c = 0; c < width; ++c) squared += double(values[i + c]) * double(values[i + c]);
        const double value = width == 1 ? double(values[i]) : std::sqrt(squared);
        if (!std::isfinite(value)) {
            ++summary.nonFinite;
            continue;
        }
        if (!summary.range) summary.range = {value, value};
        summary.range = {std::min((*summary.range)[0], value), std::max((*summary.range)[1], value)};
    }
    return summary;
}

/// The axis along which most of a surface's normals lie, by area.
int axisAcross(const FoamSurface& surface)
{
    glm::dvec3 area(0);
    for (std::size_t face = 0; face + 1 < surface.begins.size(); ++face) {
        const auto corner = [&](std::size_t k) { return surface.points[surface.corners[k]]; };
        const std::size_t first = surface.begins[face];
        glm::dvec3 normal(0);
        for (std::size_t k = first + 2; k < surface.begins[face + 1]; ++k)
            normal += glm::cross(corner(k - 1) - corner(first), corner(k) - corner(first));
        area += glm::abs(normal);
    }
    return area.z >= area.x && area.z >= area.y ? 2 : area.y >= area.x ? 1 : 0;
}

FileSummary summarizeCase(const std::string& path, const ProgressReport& progress)
{
    const FoamCase foam = findFoamCase(path);
    const double time = firstFoamTime(foam);
    const std::vector<FoamPart> parts = foamParts(foam, time);
    FileSummary summary;
    summary.isSurface = summary.isCase = true;
    summary.kind = foam.decomposed() ? fmt::format("an OpenFOAM case in {} processors' folders", foam.folders.size())
                                     : "an OpenFOAM case";
    summary.timeSteps = foam.times;
    const PieceRun all{0, int(foam.folders.size())};
    for (const FoamPart& part : parts) {
        PartSummary side{part.name(), part.type, part.groups, std::int64_t(part.faces)};
        if (side.isSide() && part.faces > 0) side.sideAcross = axisAcross(readFoamSurface(foam, {part}, time, {}, all));
        summary.parts.push_back(std::move(side));
    }
    std::map<double, std::vector<FoamField>> fieldsAt{{time, {}}};  // By the first time that has them.
    for (const FoamField& field : foamFieldsOfAllTimes(foam, foam.regions.front()))
        fieldsAt[field.times.front()].push_back(field);
    const std::vector<FoamField>& fields = fieldsAt[time];
    const FoamSurface surface = readFoamSurface(foam, parts, time, fields, all);
    summary.points = std::int64_t(surface.points.size());
    summary.cells = std::int64_t(surface.begins.size()) - 1;
    for (const glm::dvec3& p : surface.points)
        if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) summary.boundsWorld.add(p);
    for (const auto& [at, some] : fieldsAt) {
        progress("reading", 0.5);
        const FoamSurface other = at == time ? FoamSurface() : readFoamSurface(foam, parts, at, some, all);
        for (const FoamField& field : some) {
            summary.arrays.push_back(summarize(field, (at == time ? surface : other).values.at(field.name)));
            if (field.times.size() < foam.times.size()) summary.arrays.back().times = field.times;
        }
    }
    const bool walls = std::any_of(parts.begin(), parts.end(), [](const FoamPart& p) { return p.type == "wall"; });
    chooseDefaultVectors(foamArrays(fields, walls ? "wallShearStress" : "U"), summary);
    return summary;
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
        part.fillsSpace = !vtkPolyData::SafeDownCast(block.data);
        part.usual = info.usual;
        summary.isVolume = summary.isVolume || (part.fillsSpace && part.polygons > 0);
        summary.parts.push_back(std::move(part));
    }
}

}  // namespace

FileSummary summaryOf(const std::string& path, const ProgressReport& progress)
{
    if (namesFoamCase(path)) return summarizeCase(path, progress);
    DataFile reader(path, DataFile::Use::any);
    const auto data = reader.read(progress, "reading");
    requireSoundData(*data, path);
    const std::vector<PartInfo> infos = reader.parts();
    FileSummary summary;
    summary.kind = infos.empty() ? kindOf(*data) : reader.kind();
    summary.namesFiles = namesEnSightCase(path);
    summary.timeSteps = reader.timeSteps();
    const std::vector<vtkDataSet*> sets = dataSetsOf(*data);
    summary.blocks = summary.kind == "a multi-block data set" ? std::int64_t(sets.size()) : 0;
    summary.isSurface =
        std::any_of(sets.begin(), sets.end(), [](vtkDataSet* s) { return s->GetDataObjectType() == VTK_POLY_DATA; });
    addParts(*data, infos, summary);
    for (std::size_t i = 0; i < sets.size(); ++i) {
        progress("reading", 1);
        vtkDataSet* set = sets[i];
        const bool derived = i < infos.size() && infos[i].derived;
        summary.points += derived ? 0 : set->GetNumberOfPoints();
        summary.cells += derived ? 0 : set->GetNumberOfCells();
        addBounds(*set, summary.boundsWorld);
        if (set == sets.front()) chooseDefaultVectors(arraysOf(*set), summary);
        addArrays(*set, summary.arrays);
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
