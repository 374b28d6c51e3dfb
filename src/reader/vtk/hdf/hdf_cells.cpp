#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "reader/vtk/block_arrays.h"
#include "reader/vtk/hdf/hdf_data_set.h"

namespace aeolic {
namespace {

using Wholes = std::vector<std::int64_t>;

/// The kinds of cells that polygonal data have, in their order.
constexpr std::pair<const char*, void (vtkPolyData::*)(vtkCellArray*)> kTopologies[] = {
    {"Vertices", &vtkPolyData::SetVerts},
    {"Lines", &vtkPolyData::SetLines},
    {"Polygons", &vtkPolyData::SetPolys},
    {"Strips", &vtkPolyData::SetStrips}};

/// Numbers of some entries of a list, none below zero.
Wholes countsIn(const Hdf5Object& list, std::uint64_t first, std::uint64_t count)
{
    if (list.shape().size() != 1 || !isWithin({{first}, {count}}, list.shape()))
        list.fail(fmt::format("it has {} numbers", fmt::join(list.shape(), " x ")),
                  fmt::format("{} from {} on", count, first));
    Wholes counts = list.read<std::int64_t>({{first}, {count}});
    for (const std::int64_t each : counts)
        if (each < 0) list.fail(fmt::format("it has the count {}", each), "counts from 0 on");
    return counts;
}

std::uint64_t sumOf(const Wholes& counts)
{
    return std::uint64_t(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}));
}

vtkSmartPointer<vtkPoints> readPoints(const Hdf5Object& data, std::uint64_t first, std::uint64_t count)
{
    if (data.shape().size() != 2 || data.shape()[1] != 3 || !isWithin({{first, 0}, {count, 3}}, data.shape()))
        data.fail(fmt::format("it has {} numbers", fmt::join(data.shape(), " x ")),
                  fmt::format("{} x 3 from {} on", count, first));
    auto points = vtkSmartPointer<vtkPoints>::New();
    const Slab slab{{first, 0}, {count, 3}};
    if (data.type() == NumberType::float32)
        points->SetData(arrayOf<vtkFloatArray>("Points", 3, data.read<float>(slab)));
    else
        points->SetData(arrayOf<vtkDoubleArray>("Points", 3, data.read<double>(slab)));
    return points;
}

vtkSmartPointer<vtkCellArray> cellArray(const Wholes& ends, const Wholes& corners)
{
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(arrayOf<vtkIdTypeArray>("", 1, ends), arrayOf<vtkIdTypeArray>("", 1, corners));
    return cells;
}

/// Values of cells lie piece by piece in the file, and kind by kind within it. Polygonal data have all of a kind
/// together. `counts`: of each kind and piece.
void sortByKind(vtkCellData& values, const std::vector<Wholes>& counts)
{
    if (std::ranges::count_if(counts, [](const Wholes& kind) { return sumOf(kind) > 0; }) < 2) return;
    vtkNew<vtkIdList> order;
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        vtkIdType cell = 0;
        for (std::size_t piece = 0; piece < counts[kind].size(); ++piece)
            for (std::size_t other = 0; other < counts.size(); ++other) {
                const vtkIdType end = cell + counts[other][piece];
                for (; cell < end; ++cell)
                    if (other == kind) order->InsertNextId(cell);
            }
    }
    for (int i = 0; i < values.GetNumberOfArrays(); ++i) {
        vtkDataArray* array = values.GetArray(i);
        const auto asRead = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
        asRead->DeepCopy(array);
        asRead->GetTuples(order, array);
    }
}

}  // namespace

struct HdfDataSet::Step {
    std::uint64_t part = 0, parts = 0, point = 0;
    std::vector<std::uint64_t> cells, corners;  ///< Of each kind of cells.
};

struct HdfDataSet::Cells {
    Wholes ofPieces;  ///< How many each piece has.
    Wholes ends;      ///< Where each cell begins among the corners, and the last ends.
    Wholes corners;   ///< Among the points of all pieces.
};

/// Pieces and points of a step, and where the cells of its `topologies` kinds begin.
HdfDataSet::Step HdfDataSet::placeOf(std::size_t step, std::size_t topologies) const
{
    Step place;
    place.cells.assign(topologies, 0);
    place.corners.assign(topologies, 0);
    const std::uint64_t all = group_.require("NumberOfPoints").count();
    place.parts = all;
    if (!steps_) return place;
    const auto at = [&](const char* name, std::size_t column) -> std::optional<std::uint64_t> {
        const auto data = steps_->find(name);
        if (!data) return std::nullopt;
        const auto& shape = data->shape();
        const std::uint64_t width = shape.size() == 2 ? shape[1] : 1;
        if (shape.empty() || shape.size() > 2 || step >= shape[0] || (column > 0 && column >= width))
            data->fail(fmt::format("it has {} numbers", fmt::join(shape, " x ")),
                       fmt::format("some for each of the {} times", times_.size()));
        Slab slab{{step}, {1}};
        if (shape.size() == 2) {
            slab.first.push_back(column);
            slab.count.push_back(1);
        }
        const std::int64_t value = data->read<std::int64_t>(slab).front();
        if (value < 0) data->fail(fmt::format("it has the number {}", value), "places from 0 on");
        return std::uint64_t(value);
    };
    place.part = at("PartOffsets", 0).value_or(0);
    place.point = at("PointOffsets", 0).value_or(0);
    for (std::size_t kind = 0; kind < topologies; ++kind) {
        place.cells[kind] = at("CellOffsets", kind).value_or(0);
        place.corners[kind] = at("ConnectivityIdOffsets", kind).value_or(0);
    }
    if (place.part > all)
        steps_->fail(fmt::format("its pieces begin at {}", place.part), fmt::format("{} at most", all));
    place.parts = all - place.part;
    if (const auto parts = at("NumberOfParts", 0)) {
        place.parts = *parts;
    } else if (const auto begins = steps_->find("PartOffsets")) {
        // Up to where other steps' pieces begin.
        for (const std::int64_t begin : begins->read<std::int64_t>())
            if (begin > std::int64_t(place.part))
                place.parts = std::min(place.parts, std::uint64_t(begin) - place.part);
    }
    if (place.parts > all - place.part)
        steps_->fail(fmt::format("it has {} pieces from {} on", place.parts, place.part),
                     fmt::format("{} in all", all));
    return place;
}

/// How many points each piece has.
Wholes HdfDataSet::pointsOf(const Step& place) const
{
    return countsIn(group_.require("NumberOfPoints"), place.part, place.parts);
}

/// The cells of all pieces together. Each list is read at once: there may be as many pieces as there are bytes.
HdfDataSet::Cells HdfDataSet::cellsOf(const Hdf5Object& group, const Step& place, std::size_t topology,
                                      const Wholes& points) const
{
    const Wholes counts = countsIn(group.require("NumberOfCells"), place.part, place.parts),
                 cornerCounts = countsIn(group.require("NumberOfConnectivityIds"), place.part, place.parts);
    const Hdf5Object offsets = group.require("Offsets"), connectivity = group.require("Connectivity");
    // Each piece, and each before this step, has an offset more than cells.
    const Slab slab{{place.cells[topology] + place.part}, {sumOf(counts) + points.size()}},
        own{{place.corners[topology]}, {sumOf(cornerCounts)}};
    if (!isWithin(slab, offsets.shape()) || !isWithin(own, connectivity.shape()))
        group.fail(fmt::format("it has {} offsets and {} corners", fmt::join(offsets.shape(), " x "),
                               fmt::join(connectivity.shape(), " x ")),
                   fmt::format("{} and {} behind {} and {}", slab.count[0], own.count[0], slab.first[0], own.first[0]));
    const Wholes begins = offsets.read<std::int64_t>(slab);
    Cells all{counts, {0}, connectivity.read<std::int64_t>(own)};
    all.ends.reserve(std::size_t(slab.count[0]));
    auto corner = all.corners.begin();
    auto first = begins.begin();
    std::int64_t base = 0;
    for (std::size_t piece = 0; piece < points.size(); ++piece) {
        const auto end = first + counts[piece] + 1;
        if (*first != 0 || *(end - 1) != cornerCounts[piece] || !std::is_sorted(first, end))
            offsets.fail(fmt::format("its numbers go from {} to {}", *first, *(end - 1)),
                         fmt::format("0 to {}, none smaller than the one before", cornerCounts[piece]));
        const std::int64_t begin = all.ends.back();
        for (++first; first != end; ++first) all.ends.push_back(begin + *first);
        for (const auto last = corner + cornerCounts[piece]; corner != last; ++corner) {
            if (*corner < 0 || *corner >= points[piece])
                group.fail(fmt::format("a cell has the corner {}", *corner),
                           fmt::format("0 to {}, the points of its piece less one", points[piece] - 1));
            *corner += base;
        }
        base += points[piece];
    }
    return all;
}

vtkSmartPointer<vtkDataSet> HdfDataSet::readGrid(std::size_t step, const std::vector<ArrayInfo>& kept) const
{
    const Step place = placeOf(step, 1);
    const Hdf5Object pointData = group_.require("Points"), typeData = group_.require("Types");
    const Wholes points = pointsOf(place);
    const Cells cells = cellsOf(group_, place, 0, points);
    const Slab slab{{place.cells[0]}, {cells.ends.size() - 1}};
    if (!isWithin(slab, typeData.shape()))
        typeData.fail(fmt::format("it has {} numbers", fmt::join(typeData.shape(), " x ")),
                      fmt::format("{} from {} on, one for each cell", slab.count[0], slab.first[0]));
    const auto types = typeData.read<std::int64_t>(slab);
    if (std::ranges::find(types, VTK_POLYHEDRON) != types.end())
        typeData.fail("it has polyhedra", "cells of other kinds");
    vtkNew<vtkUnsignedCharArray> kinds;
    kinds->SetNumberOfValues(vtkIdType(types.size()));
    for (std::size_t cell = 0; cell < types.size(); ++cell) {
        if (types[cell] < 0 || types[cell] > 255)
            typeData.fail(fmt::format("cell {} has the type {}", cell, types[cell]), "0 to 255");
        kinds->SetValue(vtkIdType(cell), static_cast<unsigned char>(types[cell]));
    }
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(readPoints(pointData, place.point, sumOf(points)));
    grid->SetCells(kinds, cellArray(cells.ends, cells.corners));
    addArrays(*grid, step, kept, {place.point, place.cells[0]});
    return grid;
}

vtkSmartPointer<vtkDataSet> HdfDataSet::readPolygons(std::size_t step, const std::vector<ArrayInfo>& kept) const
{
    const Step place = placeOf(step, std::size(kTopologies));
    const Hdf5Object pointData = group_.require("Points");
    const Wholes points = pointsOf(place);
    auto polygons = vtkSmartPointer<vtkPolyData>::New();
    if (points.empty()) return polygons;
    polygons->SetPoints(readPoints(pointData, place.point, sumOf(points)));
    std::vector<Wholes> counts;  // Cells of each kind and piece.
    std::uint64_t cell = 0;
    for (std::size_t kind = 0; kind < std::size(kTopologies); ++kind) {
        const auto& [name, set] = kTopologies[kind];
        cell += place.cells[kind];
        counts.emplace_back(points.size());
        const auto group = group_.find(name);
        if (!group) continue;
        const Cells cells = cellsOf(*group, place, kind, points);
        ((*polygons).*set)(cellArray(cells.ends, cells.corners));
        counts.back() = cells.ofPieces;
    }
    addArrays(*polygons, step, kept, {place.point, cell});
    if (points.size() > 1) sortByKind(*polygons->GetCellData(), counts);
    return polygons;
}

}  // namespace aeolic
