#include "reader/vtk/part_data_set.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTypeUInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "aeolic/error.h"
#include "data/vtk/surface/polydata_mesh.h"
#include "reader/vtk/block_arrays.h"

namespace aeolic {
namespace {

constexpr double kFarthest = 1e30;
constexpr std::int64_t kUnused = -1;
int vtkTypeOf(CellShape shape)
{
    constexpr int types[] = {VTK_TRIANGLE, VTK_QUAD,  VTK_POLYGON,    VTK_TETRA,
                             VTK_PYRAMID,  VTK_WEDGE, VTK_HEXAHEDRON, VTK_POLYHEDRON};
    return types[std::size_t(shape)];
}

/// Collects one part's cells, their points numbered anew in the order of the part's. What was collected is freed.
class DataSetMaker {
public:
    DataSetMaker(PartMesh part, int dimension, const std::string& where)
        : part_(std::move(part)), dimension_(dimension), where_(where)
    {
        std::size_t corners = 0, cells = 0;
        for (const PartCells& each : part_.cells) {
            if (!sizesFit(each))
                throw InputError(where, "its cells and their corners do not fit together",
                                 "as many corners as cells need");
            if (!takes(each)) continue;
            corners += each.corners.size();
            cells += each.count;
        }
        numberPoints();
        connectivity_->Allocate(vtkIdType(corners));
        ends_->Allocate(vtkIdType(cells) + 1);
        types_->Allocate(vtkIdType(cells));
        ends_->InsertNextValue(0);
        for (PartCells& each : part_.cells) {
            if (takes(each)) takeCells(each);
            each.corners = {};
        }
    }

    vtkSmartPointer<vtkPointSet> make() const
    {
        vtkNew<vtkCellArray> cells;
        cells->SetData(ends_, connectivity_);
        vtkSmartPointer<vtkPointSet> set;
        if (dimension_ == 2) {
            auto polygons = vtkSmartPointer<vtkPolyData>::New();
            polygons->SetPolys(cells);
            set = polygons;
        } else {
            auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
            if (faces_->GetNumberOfValues() == 0)
                grid->SetCells(types_, cells);
            else
                grid->SetCells(types_, cells, faceBegins_, faces_);
            set = grid;
        }
        set->SetPoints(points());
        return set;
    }

    vtkSmartPointer<vtkFloatArray> values(const PartArray& array, const PartValues& found) const
    {
        const auto width = std::size_t(array.components);
        const std::size_t tuples = array.onPoints ? used_.size() : std::size_t(ends_->GetNumberOfValues()) - 1;
        const std::size_t expected = array.onPoints ? pointCount() : part_.cellCount();
        if (found && found->size() != expected * width)
            throw InputError(where_, fmt::format("'{}' has {} values", array.name, found->size() / width),
                             fmt::format("{}, one for each of the {}", expected, array.onPoints ? "points" : "cells"));
        auto values = floatArray(array.name, array.components, tuples);
        float* to = values->GetPointer(0);
        if (!found) {
            std::fill_n(to, tuples * width, kMissing);
        } else if (array.onPoints) {
            for (const std::size_t point : used_)
                to = std::copy_n(found->begin() + std::ptrdiff_t(point * width), width, to);
        } else {
            auto from = found->begin();
            for (const PartCells& each : part_.cells) {
                const auto count = std::ptrdiff_t(each.count * width);
                if (takes(each)) to = std::copy_n(from, count, to);
                from += count;
            }
        }
        return values;
    }

private:
    bool takes(const PartCells& cells) const { return dimension_ == 3 || !fillsSpace(cells.shape); }

    std::size_t pointCount() const { return part_.points ? part_.points->size() : 0; }

    void numberPoints()
    {
        numbers_.assign(pointCount(), kUnused);
        for (const PartCells& each : part_.cells) {
            if (!takes(each)) continue;
            for (const std::int64_t corner : each.corners) {
                if (corner < 0 || std::uint64_t(corner) >= numbers_.size())
                    throw InputError(
                        where_, fmt::format("a cell has the corner {}", corner),
                        fmt::format("0 to {}, the number of its points less one", std::int64_t(numbers_.size()) - 1));
                numbers_[std::size_t(corner)] = 0;
            }
        }
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            if (numbers_[i] == kUnused) continue;
            numbers_[i] = std::int64_t(used_.size());
            used_.push_back(i);
        }
    }

    void takeCells(const PartCells& cells)
    {
        for (std::size_t i = 0; i < cells.count; ++i)
            types_->InsertNextValue(static_cast<unsigned char>(vtkTypeOf(cells.shape)));
        if (cells.shape == CellShape::polyhedron) {
            takePolyhedra(cells);
            return;
        }
        for (std::size_t i = 0; faceBegins_->GetNumberOfValues() > 0 && i < cells.count; ++i)
            faceBegins_->InsertNextValue(-1);
        const std::size_t fixed = cornersOf(cells.shape);
        std::size_t at = 0;
        for (std::size_t i = 0; i < cells.count; ++i) {
            const std::size_t size = fixed > 0 ? fixed : std::size_t(cells.sizes[i]);
            const vtkIdType before = connectivity_->GetNumberOfValues();
            vtkIdType* to = connectivity_->WritePointer(before, vtkIdType(size));
            for (std::size_t k = 0; k < size; ++k) to[k] = number(cells.corners[at + k]);
            if (cells.shape == CellShape::wedge) std::rotate(to, to + 3, to + 6);  // VTK turns it around.
            ends_->InsertNextValue(before + vtkIdType(size));
            at += size;
        }
    }

    void takePolyhedra(const PartCells& cells)
    {
        while (faceBegins_->GetNumberOfValues() + vtkIdType(cells.count) < types_->GetNumberOfValues())
            faceBegins_->InsertNextValue(-1);
        std::vector<vtkIdType> corners;
        std::size_t at = 0, face = 0;
        for (std::size_t i = 0; i < cells.count; ++i) {
            corners.clear();
            faceBegins_->InsertNextValue(faces_->GetNumberOfValues());
            faces_->InsertNextValue(cells.sizes[i]);
            for (std::int64_t k = 0; k < cells.sizes[i]; ++k) {
                const auto size = std::size_t(cells.ofFaces[face++]);
                faces_->InsertNextValue(vtkIdType(size));
                for (std::size_t end = at + size; at < end; ++at) {
                    corners.push_back(number(cells.corners[at]));
                    faces_->InsertNextValue(corners.back());
                }
            }
            std::sort(corners.begin(), corners.end());
            corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
            for (const vtkIdType corner : corners) connectivity_->InsertNextValue(corner);
            ends_->InsertNextValue(connectivity_->GetNumberOfValues());
        }
    }

    vtkIdType number(std::int64_t corner) const { return numbers_[std::size_t(corner)]; }

    vtkSmartPointer<vtkPoints> points() const
    {
        auto points = vtkSmartPointer<vtkPoints>::New();
        points->SetDataType(part_.floatPoints ? VTK_FLOAT : VTK_DOUBLE);
        points->SetNumberOfPoints(vtkIdType(used_.size()));
        for (std::size_t i = 0; i < used_.size(); ++i) {
            const glm::dvec3& p = (*part_.points)[used_[i]];
            for (int c = 0; c < 3; ++c)
                if (!(std::abs(p[c]) <= kFarthest))
                    throw InputError(where_, fmt::format("a coordinate is {}", p[c]), "at most 1e30");
            points->SetPoint(vtkIdType(i), p.x, p.y, p.z);
        }
        return points;
    }

    PartMesh part_;
    int dimension_;
    const std::string& where_;
    std::vector<std::int64_t> numbers_;  // Of the part's points among those that are used.
    std::vector<std::size_t> used_;
    vtkNew<vtkUnsignedCharArray> types_;
    vtkNew<vtkIdTypeArray> ends_, connectivity_, faceBegins_, faces_;
};

}  // namespace

vtkSmartPointer<vtkPointSet> dataSetOf(PartMesh part, int dimension, const std::vector<PartArray>& arrays,
                                       const std::string& where)
{
    const std::vector<PartValues> values = std::move(part.values);
    const std::vector<std::uint64_t> places = std::move(part.places);
    const DataSetMaker maker(std::move(part), dimension, where);
    auto set = maker.make();
    if (!places.empty()) set->GetCellData()->AddArray(arrayOf<vtkTypeUInt64Array>(kTrianglesPlaces, 1, places));
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        const PartArray& array = arrays[i];
        attributesOf(*set, array.onPoints)->AddArray(maker.values(array, i < values.size() ? values[i] : nullptr));
    }
    return set;
}

}  // namespace aeolic
