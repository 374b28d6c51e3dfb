#include "data/vtk/grid/volume_from_grid.h"

#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "aeolic/error.h"
#include "base/memory.h"

namespace aeolic {
namespace {

using Shape = VolumeCells::Shape;

std::optional<Shape> simpleShape(int vtkType)
{
    switch (vtkType) {
        case VTK_TETRA:
            return Shape::tetra;
        case VTK_PYRAMID:
            return Shape::pyramid;
        case VTK_WEDGE:
            return Shape::wedge;
        case VTK_HEXAHEDRON:
        case VTK_VOXEL:
            return Shape::hexahedron;
        default:
            return std::nullopt;
    }
}

/// Puts the cells of a data set together.
class Collector {
public:
    Collector(vtkDataSet& data, VolumeCells& cells) : data_(data), cells_(cells)
    {
        hidden_ =
            vtkUnsignedCharArray::SafeDownCast(data.GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
        const auto count = std::size_t(data.GetNumberOfCells());
        auto* grid = vtkUnstructuredGrid::SafeDownCast(&data);
        cells_.shapes.reserve(count);
        cells_.first.reserve(count + 1);
        cells_.corners.reserve(grid ? std::size_t(grid->GetCells()->GetNumberOfConnectivityIds()) : 8 * count);
        cells_.first.push_back(0);
    }

    void takePoints()
    {
        cells_.points.resize(std::size_t(data_.GetNumberOfPoints()));
        finite_.resize(cells_.points.size());
        for (std::size_t i = 0; i < cells_.points.size(); ++i) {
            double p[3];
            data_.GetPoint(vtkIdType(i), p);
            cells_.points[i] = {p[0], p[1], p[2]};
            finite_[i] = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
        }
    }

    void takeCell(vtkIdType cell)
    {
        constexpr unsigned char drawnElsewhere = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
        if (hidden_ && (hidden_->GetValue(cell) & drawnElsewhere)) return;
        const int type = data_.GetCellType(cell);
        const auto simple = simpleShape(type);
        if (simple) {
            data_.GetCellPoints(cell, ids_);
            for (vtkIdType k = 0; k < ids_->GetNumberOfIds(); ++k) add(ids_->GetId(k));
            if (type == VTK_VOXEL && ids_->GetNumberOfIds() == 8) {
                const auto own = cells_.corners.end() - 8;
                std::swap(own[2], own[3]);
                std::swap(own[6], own[7]);
            }
        } else if (type == VTK_POLYHEDRON) {
            takeFaceStream(cell);
        } else if (!takeFaces(cell)) {
            return;
        }
        close(simple.value_or(Shape::polyhedron));
    }

private:
    void add(vtkIdType point)
    {
        cells_.corners.push_back(std::uint32_t(point));
        sound_ = sound_ && finite_[std::size_t(point)];
    }

    void takeFaceStream(vtkIdType cell)
    {
        vtkIdType faces = 0;
        const vtkIdType* stream = nullptr;
        vtkUnstructuredGrid::SafeDownCast(&data_)->GetFaceStream(cell, faces, stream);
        for (vtkIdType face = 0; face < faces; ++face) {
            const vtkIdType size = *stream++;
            cells_.corners.push_back(std::uint32_t(size));
            for (vtkIdType k = 0; k < size; ++k) add(*stream++);
        }
    }

    /// By the faces that VTK knows of such a cell; false where it is flat.
    bool takeFaces(vtkIdType cell)
    {
        data_.GetCell(cell, generic_);
        if (generic_->GetCellDimension() != 3) return false;
        for (int face = 0; face < generic_->GetNumberOfFaces(); ++face) {
            vtkCell* side = generic_->GetFace(face);
            const int corners = side->GetNumberOfEdges();  // The corners come before the points between them.
            cells_.corners.push_back(std::uint32_t(corners));
            for (int k = 0; k < corners; ++k) add(side->GetPointId(k));
        }
        return true;
    }

    void close(Shape shape)
    {
        if (sound_ && cells_.corners.size() > cells_.first.back()) {
            cells_.shapes.push_back(shape);
            cells_.first.push_back(cells_.corners.size());
        } else {
            cells_.corners.resize(cells_.first.back());
        }
        sound_ = true;
    }

    vtkDataSet& data_;
    VolumeCells& cells_;
    vtkUnsignedCharArray* hidden_ = nullptr;
    vtkNew<vtkIdList> ids_;
    vtkNew<vtkGenericCell> generic_;
    std::vector<char> finite_;  // Which points are.
    bool sound_ = true;         // The cell's corners so far are finite.
};

}  // namespace

bool hasVolume(vtkDataSet& data)
{
    vtkNew<vtkGenericCell> cell;
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
        cell->SetCellType(data.GetCellType(i));
        if (cell->GetCellDimension() == 3) return true;
    }
    return false;
}

std::shared_ptr<VolumeCells> volumeFromGrid(vtkDataSet& data, vtkFloatArray& vectors, vtkFloatArray* scalars,
                                            const std::string& where)
{
    constexpr std::uint64_t bytesOfPoint = 24 + 12 + 4, bytesOfCell = 8 * 4 + 9 + 2 * 24 + 4;  // With their tree.
    const auto points = std::uint64_t(data.GetNumberOfPoints()), count = std::uint64_t(data.GetNumberOfCells());
    if (points >= std::numeric_limits<std::uint32_t>::max())
        throw InputError(where, fmt::format("{} points", points), "fewer than 4294967295");
    requireMemory(where, fmt::format("looking values up in {} cells", count),
                  bytesOfPoint * points + bytesOfCell * count);
    auto cells = std::make_shared<VolumeCells>();
    cells->name = where;
    Collector collector(data, *cells);
    collector.takePoints();
    for (vtkIdType cell = 0; cell < data.GetNumberOfCells(); ++cell) collector.takeCell(cell);
    if (cells->count() == 0)
        throw InputError(where, fmt::format("the data is flat: none of its {} cells has a volume", count),
                         "a 3D field to sample, or --surface boundary to draw the flat data itself");
    cells->vectors.resize(points);
    const float* v = vectors.GetPointer(0);
    for (std::size_t i = 0; i < points; ++i) cells->vectors[i] = {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
    if (scalars) cells->scalars.assign(scalars->GetPointer(0), scalars->GetPointer(0) + points);
    return cells;
}

}  // namespace aeolic
