#include "data/vtk/grid/grid_volume.h"

#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
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
#include <span>
#include <utility>

#include "aeolic/error.h"
#include "base/large_memory.h"
#include "base/memory.h"
#include "data/vtk/grid/cell_means.h"

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

/// Puts cells of a data set together.
class Collector {
public:
    /// `count`: about as many cells will be taken.
    Collector(vtkDataSet& data, VolumeCells& cells, std::size_t count)
        : data_(data),
          cells_(cells),
          grid_(vtkUnstructuredGrid::SafeDownCast(&data)),
          ids_(std::size_t(data.GetNumberOfPoints()), kNone)
    {
        const std::size_t points = count + count / 2;  // Thin shells of hexahedra have more points than cells.
        points_.reserve(points);
        cells_.points.reserve(points);
        cells_.shapes.reserve(count);
        cells_.first.reserve(count + 1);
        cells_.corners.reserve(8 * count);
        hidden_ =
            vtkUnsignedCharArray::SafeDownCast(data.GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
        cells_.first.push_back(0);
    }

    /// [VolumeCells::points] Which of the data set's points they are.
    const std::vector<vtkIdType>& points() const { return points_; }

    void takeCell(vtkIdType cell)
    {
        constexpr unsigned char drawnElsewhere = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
        if (hidden_ && (hidden_->GetValue(cell) & drawnElsewhere)) return;
        const int type = data_.GetCellType(cell);
        const auto simple = simpleShape(type);
        if (simple) {
            const std::span<const vtkIdType> corners = cornersOf(cell);
            for (const vtkIdType corner : corners) add(corner);
            if (type == VTK_VOXEL && corners.size() == 8) {
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
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    /// They hold until the next call. A grid's are not copied.
    std::span<const vtkIdType> cornersOf(vtkIdType cell)
    {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        if (grid_) {
            grid_->GetCells()->GetCellAtId(cell, size, corners);
            return {corners, std::size_t(size)};
        }
        data_.GetCellPoints(cell, list_);
        return {list_->GetPointer(0), std::size_t(list_->GetNumberOfIds())};
    }

    void add(vtkIdType point)
    {
        std::uint32_t& id = ids_[std::size_t(point)];
        if (id == kNone) {
            double p[3];
            data_.GetPoint(point, p);
            id = std::uint32_t(points_.size());
            points_.push_back(point);
            cells_.points.emplace_back(p[0], p[1], p[2]);
        }
        cells_.corners.push_back(id);
        const glm::dvec3& p = cells_.points[id];
        sound_ = sound_ && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    }

    void takeFaceStream(vtkIdType cell)
    {
        vtkIdType faces = 0;
        const vtkIdType* stream = nullptr;
        grid_->GetFaceStream(cell, faces, stream);
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
    vtkUnstructuredGrid* const grid_;  // The data set, if it is one.
    vtkUnsignedCharArray* hidden_ = nullptr;
    vtkNew<vtkIdList> list_;
    vtkNew<vtkGenericCell> generic_;
    LargeVector<std::uint32_t> ids_;  // [points of the data set] Their numbers here.
    std::vector<vtkIdType> points_;
    bool sound_ = true;  // The cell's corners so far are finite.
};

}  // namespace

bool hasVolume(vtkDataSet& data)
{
    return dimensionOfCells(data) == 3;
}

GridVolume::GridVolume(vtkSmartPointer<vtkDataSet> data, vtkSmartPointer<vtkFloatArray> vectors,
                       vtkSmartPointer<vtkFloatArray> scalars, std::string where)
    : data_(std::move(data)), vectors_(std::move(vectors)), scalars_(std::move(scalars)), where_(std::move(where))
{
    const auto points = std::uint64_t(data_->GetNumberOfPoints());
    if (points >= std::numeric_limits<std::uint32_t>::max())
        throw InputError(where_, fmt::format("{} points", points), "fewer than 4294967295");
}

std::shared_ptr<const CellVolume> GridVolume::copy() const
{
    const auto deep = [](const auto& theirs) {
        if (!theirs) return theirs;
        auto own = std::decay_t<decltype(theirs)>::Take(theirs->NewInstance());
        own->DeepCopy(theirs);
        return own;
    };
    auto own = std::make_shared<GridVolume>(deep(data_), deep(vectors_), deep(scalars_), where_);
    own->longest = longest;
    own->areMeans = areMeans;
    return own;
}

const CellRuns& GridVolume::runs() const
{
    std::call_once(measured_, [&] { runs_ = runsOfCells(*data_); });
    return runs_;
}

Bounds GridVolume::bounds() const
{
    return runs().bounds;
}

CellVolume::Shell GridVolume::near(NearSurface& surface, double diagonals) const
{
    NearCells near = nearCellsOf(*data_, runs(), surface, diagonals);
    return {cellsOf(near.chosen), std::move(near.leftOut)};
}

VolumeCells GridVolume::cellsOf(const std::vector<char>& chosen) const
{
    constexpr std::uint64_t bytesOfCell = 8 * 4 + 9 + 2 * 24 + 4 + 24 + 12 + 4;  // With its tree, and a point for each.
    const auto count = std::uint64_t(std::count(chosen.begin(), chosen.end(), 1));
    requireMemory(where_, fmt::format("looking values up in {} cells", count), bytesOfCell * count);
    VolumeCells cells;
    cells.name = where_;
    cells.maxVector = longest;
    cells.meansOfCells = areMeans;
    Collector collector(*data_, cells, std::size_t(count));
    for (std::size_t cell = 0; cell < chosen.size(); ++cell)
        if (chosen[cell]) collector.takeCell(vtkIdType(cell));
    cells.vectors.reserve(cells.points.size());
    const float* v = vectors_->GetPointer(0);
    for (const vtkIdType point : collector.points())
        cells.vectors.emplace_back(v[3 * point], v[3 * point + 1], v[3 * point + 2]);
    if (scalars_)
        for (const vtkIdType point : collector.points()) cells.scalars.push_back(scalars_->GetValue(point));
    return cells;
}

}  // namespace aeolic
