#include "data/vtk/ensight_blocks.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>

#include "data/ensight/ensight_values.h"
#include "data/part_choice.h"

namespace aeolic {
namespace {

int vtkTypeOf(EnSightShape shape)
{
    switch (shape) {
        case EnSightShape::triangle:
            return VTK_TRIANGLE;
        case EnSightShape::quad:
            return VTK_QUAD;
        case EnSightShape::polygon:
            return VTK_POLYGON;
        case EnSightShape::tetra:
            return VTK_TETRA;
        case EnSightShape::pyramid:
            return VTK_PYRAMID;
        case EnSightShape::wedge:
            return VTK_WEDGE;
        case EnSightShape::hexahedron:
            return VTK_HEXAHEDRON;
        case EnSightShape::polyhedron:
            return VTK_POLYHEDRON;
        default:
            return VTK_EMPTY_CELL;
    }
}

vtkSmartPointer<vtkPoints> pointsOf(const EnSightPart& part)
{
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetNumberOfPoints(vtkIdType(part.pointCount()));
    for (std::size_t i = 0; i < part.pointCount(); ++i)
        points->SetPoint(vtkIdType(i), double(part.points[0][i]), double(part.points[1][i]), double(part.points[2][i]));
    return points;
}

/// insert(type, corners) for every cell that is kept, but polyhedra. VTK's wedges are turned around.
template <class Insert>
void insertCells(const EnSightSection& section, const Insert& insert)
{
    const int type = vtkTypeOf(section.element->shape);
    std::vector<vtkIdType> corners;
    std::size_t at = 0;
    for (std::size_t i = 0; i < section.count; ++i) {
        const std::size_t size = section.sizes.empty() ? section.element->corners : std::size_t(section.sizes[i]);
        corners.assign(section.corners.begin() + std::ptrdiff_t(at),
                       section.corners.begin() + std::ptrdiff_t(at + size));
        if (type == VTK_WEDGE) std::rotate(corners.begin(), corners.begin() + 3, corners.end());
        insert(type, corners);
        at += size;
    }
}

void insertPolyhedra(const EnSightSection& section, vtkUnstructuredGrid& grid)
{
    std::vector<vtkIdType> corners, faces;
    std::size_t at = 0, face = 0;
    for (std::size_t i = 0; i < section.count; ++i) {
        faces.clear();
        corners.clear();
        for (std::int32_t k = 0; k < section.sizes[i]; ++k) {
            const auto size = std::size_t(section.ofFaces[face++]);
            faces.push_back(vtkIdType(size));
            for (std::size_t end = at + size; at < end; ++at) {
                faces.push_back(section.corners[at]);
                corners.push_back(section.corners[at]);
            }
        }
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        grid.InsertNextCell(VTK_POLYHEDRON, vtkIdType(corners.size()), corners.data(), section.sizes[i], faces.data());
    }
}

vtkSmartPointer<vtkPointSet> gridOf(const EnSightPart& part)
{
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->Allocate(vtkIdType(part.cells()));
    for (const EnSightSection& section : part.sections) {
        if (!section.kept) continue;
        if (section.element->shape == EnSightShape::polyhedron)
            insertPolyhedra(section, *grid);
        else
            insertCells(section, [&](int type, const std::vector<vtkIdType>& corners) {
                grid->InsertNextCell(type, vtkIdType(corners.size()), corners.data());
            });
    }
    return grid;
}

vtkSmartPointer<vtkPointSet> facesOf(const EnSightPart& part)
{
    auto faces = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkCellArray> polygons;
    for (const EnSightSection& section : part.sections)
        if (section.kept)
            insertCells(section, [&](int, const std::vector<vtkIdType>& corners) {
                polygons->InsertNextCell(vtkIdType(corners.size()), corners.data());
            });
    faces->SetPolys(polygons);
    return faces;
}

std::vector<std::size_t> chooseOf(const EnSightGeometry& geometry, FileUse use, const std::vector<std::string>& wanted,
                                  const std::string& path)
{
    std::vector<PartName> names;
    std::vector<std::size_t> all, usual;
    for (const EnSightPart& part : geometry.parts) {
        if (part.cells() > 0 && part.fillsSpace() == (use == FileUse::field)) usual.push_back(names.size());
        all.push_back(names.size());
        names.push_back({part.name, {}});
    }
    if (!wanted.empty()) return chooseParts(names, wanted, path);
    return usual.empty() || use == FileUse::any ? all : usual;
}

}  // namespace

EnSightBlocks::EnSightBlocks(const std::string& path, FileUse use, std::optional<double> time)
    : case_(readEnSightCase(path)), use_(use), time_(time)
{
    for (const EnSightVariable& variable : case_.variables)
        arrays_.push_back({variable.name, variable.onPoints, variable.components, VTK_FLOAT});
}

vtkSmartPointer<vtkDataObject> EnSightBlocks::read(const std::vector<ArrayInfo>& kept) const
{
    EnSightGeometry geometry = readEnSightGeometry(case_.fileAt(case_.geometry, time_), case_.bytesAt(time_));
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    const std::vector<std::size_t> chosen = chooseOf(geometry, use_, wanted_, case_.path);
    std::vector<vtkSmartPointer<vtkPointSet>> sets;
    for (const std::size_t i : chosen) {
        EnSightPart& part = geometry.parts[i];
        sets.push_back(part.fillsSpace() ? gridOf(part) : facesOf(part));
        sets.back()->SetPoints(pointsOf(part));
        for (EnSightSection& section : part.sections) section.corners = section.sizes = section.ofFaces = {};
        blocks->SetBlock(unsigned(sets.size() - 1), sets.back());
        blocks->GetMetaData(unsigned(sets.size() - 1))->Set(vtkCompositeDataSet::NAME(), part.name.c_str());
    }
    for (const EnSightVariable& variable : case_.variables) {
        if (std::none_of(kept.begin(), kept.end(), [&](const ArrayInfo& array) {
                return array.name == variable.name && array.onPoints == variable.onPoints;
            }))
            continue;
        const auto values = readEnSightValues(case_.fileAt(variable.file, time_), variable, geometry);
        for (std::size_t k = 0; k < chosen.size(); ++k) {
            vtkNew<vtkFloatArray> array;
            array->SetName(variable.name.c_str());
            array->SetNumberOfComponents(variable.components);
            array->SetNumberOfTuples(vtkIdType(values[chosen[k]].size()) / variable.components);
            std::copy(values[chosen[k]].begin(), values[chosen[k]].end(), array->GetPointer(0));
            auto* all =
                variable.onPoints ? static_cast<vtkFieldData*>(sets[k]->GetPointData()) : sets[k]->GetCellData();
            all->AddArray(array);
        }
    }
    return blocks;
}

}  // namespace aeolic
