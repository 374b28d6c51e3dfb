#include <fmt/format.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <numeric>

#include "data/vtk/hdf/hdf_data_set.h"

namespace aeolic {
namespace {

using Wholes = std::vector<std::int64_t>;

constexpr const char* kTopologies[] = {"Vertices", "Lines", "Polygons", "Strips"};

/// Numbers of some entries of a list, none below zero and in all no more than `most`.
Wholes countsIn(const Hdf5Object& list, std::uint64_t first, std::uint64_t count, std::uint64_t most)
{
    if (list.shape().size() != 1 || !isWithin({{first}, {count}}, list.shape()))
        list.fail(fmt::format("it has {} numbers", fmt::join(list.shape(), " x ")),
                  fmt::format("{} from {} on", count, first));
    Wholes counts = list.read<std::int64_t>({{first}, {count}});
    std::uint64_t sum = 0;
    for (const std::int64_t each : counts) {
        if (each < 0 || std::uint64_t(each) > most - sum)
            list.fail(fmt::format("it has the count {}", each),
                      fmt::format("0 to {}, as many as there are", most - sum));
        sum += std::uint64_t(each);
    }
    return counts;
}

std::uint64_t sumOf(const Wholes& counts, std::size_t end)
{
    return std::uint64_t(std::accumulate(counts.begin(), counts.begin() + std::ptrdiff_t(end), std::int64_t{0}));
}

vtkSmartPointer<vtkPoints> readPoints(const Hdf5Object& data, std::uint64_t first, std::uint64_t count)
{
    if (data.shape().size() != 2 || data.shape()[1] != 3 || !isWithin({{first, 0}, {count, 3}}, data.shape()))
        data.fail(fmt::format("it has {} numbers", fmt::join(data.shape(), " x ")),
                  fmt::format("{} x 3 from {} on", count, first));
    auto points = vtkSmartPointer<vtkPoints>::New();
    const Slab slab{{first, 0}, {count, 3}};
    if (data.type() == NumberType::float32) {
        const auto values = data.read<float>(slab);
        points->SetNumberOfPoints(vtkIdType(count));
        std::copy(values.begin(), values.end(), vtkFloatArray::SafeDownCast(points->GetData())->GetPointer(0));
    } else {
        const auto values = data.read<double>(slab);
        points->SetDataTypeToDouble();
        points->SetNumberOfPoints(vtkIdType(count));
        std::copy(values.begin(), values.end(), vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0));
    }
    return points;
}

vtkSmartPointer<vtkCellArray> cellArray(const Wholes& ends, const Wholes& corners)
{
    vtkNew<vtkIdTypeArray> offsets, connectivity;
    offsets->SetNumberOfValues(vtkIdType(ends.size()));
    connectivity->SetNumberOfValues(vtkIdType(corners.size()));
    std::copy(ends.begin(), ends.end(), offsets->GetPointer(0));
    std::copy(corners.begin(), corners.end(), connectivity->GetPointer(0));
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(offsets, connectivity);
    return cells;
}

}  // namespace

struct HdfDataSet::Step {
    std::uint64_t part = 0, parts = 0, point = 0;
    std::vector<std::uint64_t> cells, corners;  ///< Of each kind of cells.
};

struct HdfDataSet::Counts {
    Wholes cells, corners;  ///< Of each piece.
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

HdfDataSet::Counts HdfDataSet::countsOf(const Hdf5Object& group, const Step& place) const
{
    return {countsIn(group.require("NumberOfCells"), place.part, place.parts, group.require("Offsets").count()),
            countsIn(group.require("NumberOfConnectivityIds"), place.part, place.parts,
                     group.require("Connectivity").count())};
}

/// Where each cell of a piece begins among its corners, and the last ends.
Wholes HdfDataSet::cellsOf(const Hdf5Object& group, const Step& place, std::size_t topology, const Counts& counts,
                           std::size_t piece, Wholes& corners) const
{
    const Hdf5Object offsets = group.require("Offsets"), connectivity = group.require("Connectivity");
    const auto cells = std::uint64_t(counts.cells[piece]), ids = std::uint64_t(counts.corners[piece]);
    // Each piece before this one has an offset more than cells.
    const std::uint64_t first = place.cells[topology] + sumOf(counts.cells, piece) + place.part + piece;
    const Slab slab{{first}, {cells + 1}}, own{{place.corners[topology] + sumOf(counts.corners, piece)}, {ids}};
    if (!isWithin(slab, offsets.shape()) || !isWithin(own, connectivity.shape()))
        group.fail(fmt::format("it has {} offsets and {} corners", fmt::join(offsets.shape(), " x "),
                               fmt::join(connectivity.shape(), " x ")),
                   fmt::format("{} and {} behind {} and {}", cells + 1, ids, slab.first[0], own.first[0]));
    Wholes ends = offsets.read<std::int64_t>(slab);
    if (ends.front() != 0 || ends.back() != std::int64_t(ids) || !std::is_sorted(ends.begin(), ends.end()))
        offsets.fail(fmt::format("its numbers go from {} to {}", ends.front(), ends.back()),
                     fmt::format("0 to {}, none smaller than the one before", ids));
    corners = connectivity.read<std::int64_t>(own);
    return ends;
}

vtkSmartPointer<vtkDataSet> HdfDataSet::readGrid(std::size_t step, const std::vector<ArrayInfo>& kept) const
{
    const Step place = placeOf(step, 1);
    const Hdf5Object pointData = group_.require("Points"), typeData = group_.require("Types");
    const Wholes points = countsIn(group_.require("NumberOfPoints"), place.part, place.parts,
                                   pointData.shape().empty() ? 0 : pointData.shape()[0]);
    const Counts counts = countsOf(group_, place);
    Wholes ends{0}, corners;
    std::int64_t base = 0;
    for (std::size_t piece = 0; piece < points.size(); ++piece) {
        Wholes own;
        const Wholes ownEnds = cellsOf(group_, place, 0, counts, piece, own);
        const std::int64_t begin = ends.back();
        for (std::size_t i = 1; i < ownEnds.size(); ++i) ends.push_back(begin + ownEnds[i]);
        for (const std::int64_t corner : own) {
            if (corner < 0 || corner >= points[piece])
                group_.fail(fmt::format("a cell has the corner {}", corner),
                            fmt::format("0 to {}, the points of its piece less one", points[piece] - 1));
            corners.push_back(base + corner);
        }
        base += points[piece];
    }
    const Slab slab{{place.cells[0]}, {ends.size() - 1}};
    if (!isWithin(slab, typeData.shape()))
        typeData.fail(fmt::format("it has {} numbers", fmt::join(typeData.shape(), " x ")),
                      fmt::format("{} from {} on, one for each cell", slab.count[0], slab.first[0]));
    const auto types = typeData.read<std::int8_t>(slab);
    if (std::find(types.begin(), types.end(), std::int8_t(VTK_POLYHEDRON)) != types.end())
        typeData.fail("it has polyhedra", "cells of other kinds");
    vtkNew<vtkUnsignedCharArray> kinds;
    kinds->SetNumberOfValues(vtkIdType(types.size()));
    std::copy(types.begin(), types.end(), kinds->GetPointer(0));
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(readPoints(pointData, place.point, std::uint64_t(base)));
    grid->SetCells(kinds, cellArray(ends, corners));
    addArrays(*grid, step, kept, {place.point, place.cells[0]}, {0, 0});
    return grid;
}

vtkSmartPointer<vtkDataSet> HdfDataSet::readPolygons(std::size_t step, const std::vector<ArrayInfo>& kept) const
{
    const Step place = placeOf(step, 4);
    const Hdf5Object pointData = group_.require("Points");
    const Wholes points = countsIn(group_.require("NumberOfPoints"), place.part, place.parts,
                                   pointData.shape().empty() ? 0 : pointData.shape()[0]);
    std::vector<std::optional<Hdf5Object>> groups;
    std::vector<Counts> counts;
    std::uint64_t cell = 0;
    for (std::size_t kind = 0; kind < 4; ++kind) {
        groups.push_back(group_.find(kTopologies[kind]));
        counts.push_back(groups[kind] ? countsOf(*groups[kind], place)
                                      : Counts{Wholes(points.size()), Wholes(points.size())});
        cell += place.cells[kind];
    }
    vtkNew<vtkAppendPolyData> append;
    Place behind{0, 0};
    vtkSmartPointer<vtkPolyData> polygons;
    for (std::size_t piece = 0; piece < points.size(); ++piece) {
        polygons = vtkSmartPointer<vtkPolyData>::New();
        polygons->SetPoints(readPoints(pointData, place.point + behind.point, std::uint64_t(points[piece])));
        for (std::size_t kind = 0; kind < 4; ++kind) {
            if (!groups[kind]) continue;
            Wholes corners;
            const Wholes ends = cellsOf(*groups[kind], place, kind, counts[kind], piece, corners);
            for (const std::int64_t corner : corners)
                if (corner < 0 || corner >= points[piece])
                    groups[kind]->fail(fmt::format("a cell has the corner {}", corner),
                                       fmt::format("0 to {}, the points of its piece less one", points[piece] - 1));
            const auto cells = cellArray(ends, corners);
            if (kind == 0) polygons->SetVerts(cells);
            if (kind == 1) polygons->SetLines(cells);
            if (kind == 2) polygons->SetPolys(cells);
            if (kind == 3) polygons->SetStrips(cells);
        }
        addArrays(*polygons, step, kept, {place.point, cell}, behind);
        behind.point += std::uint64_t(points[piece]);
        behind.cell += std::uint64_t(polygons->GetNumberOfCells());
        append->AddInputData(polygons);
    }
    if (points.size() == 1) return polygons;
    if (points.empty()) return vtkSmartPointer<vtkPolyData>::New();
    append->Update();
    return vtkSmartPointer<vtkDataSet>(append->GetOutput());
}

}  // namespace aeolic
