#include "data/vtk/surface/polydata_mesh.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTriangleFilter.h>
#include <vtkType.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "aeolic/error.h"
#include "base/fnv.h"
#include "base/parallel.h"
#include "data/vtk/arrays.h"
#include "data/vtk/joined_arrays.h"
#include "data/vtk/messages.h"

namespace aeolic {

namespace {

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t grain = std::size_t{1} << 14;

bool isFinite(const double p[3])
{
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

void requireSurface(vtkPolyData& input, const std::string& where, bool piece)
{
    const vtkIdType points = input.GetNumberOfPoints();
    if (input.GetNumberOfPolys() + input.GetNumberOfStrips() == 0 && !piece)
        throw InputError(where, fmt::format("{} points, {} lines and no polygons", points, input.GetNumberOfLines()),
                         "a surface of at least one triangle");
    if (points >= vtkIdType(unused)) throw InputError(where, fmt::format("{} points", points), "fewer than 4294967295");
}

/// `input` with the cells of which `isBad` holds for no corner. VTK's own way to delete cells builds a table of them,
/// and breaks at polygons of fewer than three points.
template <class IsBad>
vtkSmartPointer<vtkPolyData> withoutBadCells(vtkPolyData& input, const IsBad& isBad)
{
    auto output = vtkSmartPointer<vtkPolyData>::New();
    output->SetPoints(input.GetPoints());
    output->GetPointData()->ShallowCopy(input.GetPointData());
    output->GetFieldData()->ShallowCopy(input.GetFieldData());
    vtkNew<vtkIdList> kept;
    vtkIdType first = 0, size = 0;
    const vtkIdType* corners = nullptr;
    const auto good = [&](vtkCellArray* cells) {
        auto some = vtkSmartPointer<vtkCellArray>::New();
        for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
            cells->GetCellAtId(cell, size, corners);
            if (std::any_of(corners, corners + size, isBad)) continue;
            some->InsertNextCell(size, corners);
            kept->InsertNextId(first + cell);
        }
        first += cells->GetNumberOfCells();
        return some;
    };
    output->SetVerts(good(input.GetVerts()));
    output->SetLines(good(input.GetLines()));
    output->SetPolys(good(input.GetPolys()));
    output->SetStrips(good(input.GetStrips()));
    takeTuples(*input.GetCellData(), *kept, *output->GetCellData());
    return output;
}

/// The cells whose points are all finite; the input itself where that is so.
vtkSmartPointer<vtkPolyData> finiteCells(vtkPolyData& input, LoadedSurface& surface)
{
    const bool cutOut = surface.cutOut;
    const std::string& path = surface.mesh.name;
    std::vector<char> bad(std::size_t(input.GetNumberOfPoints()), 0);
    bool any = false;
    double p[3];
    for (std::size_t i = 0; i < bad.size(); ++i) {
        input.GetPoint(vtkIdType(i), p);
        any |= bad[i] = !isFinite(p);
    }
    const vtkIdType cells = input.GetNumberOfCells();
    if (!any) {
        surface.tallies.push_back({Tally::Of::corners, path, 0, 0, cells});
        return &input;
    }
    auto finite = withoutBadCells(input, [&](vtkIdType corner) { return bad[std::size_t(corner)] != 0; });
    const vtkIdType dropped = cells - finite->GetNumberOfCells();
    if (dropped == cells && !surface.piece)
        throw InputError(
            path,
            fmt::format("all {} cells {}", cells, cutOut ? "touch masked values" : "have a corner that is not finite"),
            cutOut ? "a cut through values that are not masked" : "finite coordinates");
    surface.tallies.push_back({Tally::Of::corners, path, dropped, 0, cells});
    return finite;
}

vtkSmartPointer<vtkPolyData> cutUp(vtkPolyData& input)
{
    const VtkMessages messages;  // A polygon that cannot be cut up is left out.
    vtkNew<vtkTriangleFilter> filter;
    filter->SetInputData(&input);
    filter->PassLinesOff();
    filter->PassVertsOff();
    filter->Update();
    return filter->GetOutput();
}

/// A hash of which points every polygon and strip joins: LoadedSurface::topology. Cost: one pass over the polygons.
std::uint64_t polygonsHash(vtkPolyData& polyData)
{
    Fnv hash;
    const auto mix = [&](vtkIdType number) { hash.mix(std::uint64_t(number)); };
    mix(polyData.GetNumberOfPoints());
    for (vtkCellArray* cells : {polyData.GetPolys(), polyData.GetStrips()}) {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        mix(cells->GetNumberOfCells());
        for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
            cells->GetCellAtId(cell, size, corners);
            mix(size);
            for (vtkIdType k = 0; k < size; ++k) mix(corners[k]);
        }
    }
    return knownTopology(hash.value);
}

/// Into how many triangles each cell was cut.
std::vector<vtkIdType> trianglesOfCells(vtkPolyData& input)
{
    vtkNew<vtkPolyData> numbered;
    numbered->CopyStructure(&input);
    vtkNew<vtkIdTypeArray> numbers;
    numbers->SetName("cell");
    for (vtkIdType cell = 0; cell < input.GetNumberOfCells(); ++cell) numbers->InsertNextValue(cell);
    numbered->GetCellData()->AddArray(numbers);
    std::vector<vtkIdType> counts(std::size_t(input.GetNumberOfCells()), 0);
    const auto cut = cutUp(*numbered);
    auto* sources = vtkIdTypeArray::SafeDownCast(cut->GetCellData()->GetArray("cell"));
    for (vtkIdType i = 0; i < sources->GetNumberOfValues(); ++i) ++counts[std::size_t(sources->GetValue(i))];
    return counts;
}

/// `input` without lines and vertices, where polygons that VTK does not cut up, because they cross or touch themselves,
/// are fans of triangles about their first corner.
vtkSmartPointer<vtkPolyData> withFans(vtkPolyData& input)
{
    const std::vector<vtkIdType> triangles = trianglesOfCells(input);
    auto output = vtkSmartPointer<vtkPolyData>::New();
    output->SetPoints(input.GetPoints());
    output->GetPointData()->ShallowCopy(input.GetPointData());
    vtkNew<vtkIdList> sources;
    vtkNew<vtkCellArray> polygons;
    vtkIdType size = 0, first = input.GetNumberOfVerts() + input.GetNumberOfLines();
    const vtkIdType* corners = nullptr;
    for (vtkIdType cell = 0; cell < input.GetNumberOfPolys(); ++cell) {
        input.GetPolys()->GetCellAtId(cell, size, corners);
        if (size < 3 || triangles[std::size_t(first + cell)] == size - 2) {
            polygons->InsertNextCell(size, corners);
            sources->InsertNextId(first + cell);
            continue;
        }
        for (vtkIdType k = 1; k + 1 < size; ++k) {
            polygons->InsertNextCell({corners[0], corners[k], corners[k + 1]});
            sources->InsertNextId(first + cell);
        }
    }
    first += input.GetNumberOfPolys();
    for (vtkIdType cell = 0; cell < input.GetNumberOfStrips(); ++cell) sources->InsertNextId(first + cell);
    output->SetPolys(polygons);
    output->SetStrips(input.GetStrips());
    takeTuples(*input.GetCellData(), *sources, *output->GetCellData());
    return output;
}

/// How many triangles polygons and strips have.
vtkIdType trianglesIn(vtkPolyData& input)
{
    vtkIdType count = 0;
    for (vtkCellArray* cells : {input.GetPolys(), input.GetStrips()})
        for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
            count += std::max<vtkIdType>(cells->GetCellSize(cell) - 2, 0);
    return count;
}

/// Triangles only: polygons and strips cut up, lines and vertices left out.
vtkSmartPointer<vtkPolyData> triangulated(vtkPolyData& input)
{
    const bool onlyTriangles =
        input.GetNumberOfCells() == input.GetNumberOfPolys() && input.GetPolys()->IsHomogeneous() == 3;
    if (onlyTriangles) return &input;
    const auto cut = cutUp(input);
    return cut->GetNumberOfPolys() == trianglesIn(input) ? cut : cutUp(*withFans(input));
}

/// Which points and cells of the polydata became which of the mesh.
struct Kept {
    std::vector<vtkIdType> points, cells;  ///< Their indices in the polydata.
};

Kept copyGeometry(vtkPolyData& polyData, LoadedSurface& surface)
{
    SurfaceMesh& mesh = surface.mesh;
    const vtkIdType pointCount = polyData.GetNumberOfPoints(), cellCount = polyData.GetNumberOfCells();
    auto* ghosts =
        vtkUnsignedCharArray::SafeDownCast(polyData.GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
    Kept kept;
    kept.cells.reserve(std::size_t(cellCount));
    std::vector<std::uint32_t> newIndex(std::size_t(pointCount), unused);
    vtkCellArray* polys = polyData.GetPolys();
    for (vtkIdType cell = 0; cell < cellCount; ++cell) {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        polys->GetCellAtId(cell, size, corners);
        if (size != 3 || (ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL))) continue;
        std::array<std::uint32_t, 3> triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t& index = newIndex[std::size_t(corners[k])];
            if (index == unused) {
                index = std::uint32_t(kept.points.size());
                kept.points.push_back(corners[k]);
            }
            triangle[k] = index;
        }
        mesh.triangles.push_back(triangle);
        kept.cells.push_back(cell);
    }
    const auto pointWorld = [&](vtkIdType id) {
        double p[3];
        polyData.GetPoint(id, p);
        return glm::dvec3(p[0], p[1], p[2]);
    };
    if (surface.piece) {
        for (const vtkIdType id : kept.points) surface.pointsWorld.push_back(pointWorld(id));
        return kept;
    }
    Bounds bounds;
    for (const vtkIdType id : kept.points) bounds.add(pointWorld(id));
    if (!kept.points.empty()) mesh.originWorld = bounds.center();
    for (const vtkIdType id : kept.points) mesh.positions.emplace_back(pointWorld(id) - mesh.originWorld);
    return kept;
}

/// The tuples of these numbers, as floats or vectors of three.
template <class Value>
std::vector<Value> gathered(vtkFloatArray& values, const std::vector<vtkIdType>& ids)
{
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    std::vector<Value> out(ids.size());
    const auto* source = reinterpret_cast<const Value*>(values.GetPointer(0));
    parallelRanges(ids.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) out[i] = source[ids[i]];
    });
    return out;
}

/// The array of `polyData`, which `uncut` became. Messages count masked cells of `uncut`, which users know.
vtkSmartPointer<vtkFloatArray> maskedFloats(vtkPolyData& uncut, vtkPolyData& polyData, const ArrayInfo& array,
                                            LoadedSurface& surface)
{
    auto floats = toFloats(findArray(polyData, array.name, array.onPoints));
    MaskResult result = maskInvalid(*floats, polyData, array.onPoints);
    if (!array.onPoints && &uncut != &polyData) {
        result.all = uncut.GetNumberOfCells();
        if (result.masked + result.nonFinite > 0)
            result = countInvalid(*findArray(uncut, array.name, false), uncut, false);
    }
    surface.tallies.push_back(result.tally(surface.mesh.name, array));
    return floats;
}

void copyArrays(vtkPolyData& uncut, vtkPolyData& polyData, const SurfaceArrays& wanted, const Kept& kept,
                LoadedSurface& surface)
{
    const std::string& where = surface.where;
    const std::vector<ArrayInfo> arrays = arraysOf(polyData);
    surface.arrays = listArrays(withJoined(arrays));
    surface.offered = offeredArrays(withJoined(arrays));
    const ArrayInfo* vectors = nullptr;
    if (wanted.wantVectors) {
        vectors = &chooseVectors(arrays, wanted.vectors, where);
        const auto floats = maskedFloats(uncut, polyData, *vectors, surface);
        (vectors->onPoints ? surface.mesh.pointVectors : surface.mesh.cellVectors) =
            gathered<glm::vec3>(*floats, vectors->onPoints ? kept.points : kept.cells);
        surface.vectorsName = vectors->name;
    }
    if (wanted.colorBy.empty()) return;
    const auto scalar = findScalar(arrays, wanted.colorBy, where);
    if (!scalar) return;
    requireOfVectors(*scalar, vectors, where);
    tellColors(*scalar, surface);
    if (needsNormal(scalar->part)) return;
    auto floats = maskedFloats(uncut, polyData, scalar->array, surface);
    if (scalar->part != ArrayPart::whole) floats = partOf(*floats, scalar->part);
    (scalar->array.onPoints ? surface.mesh.pointScalars : surface.mesh.cellScalars) =
        gathered<float>(*floats, scalar->array.onPoints ? kept.points : kept.cells);
}

/// Copies the file's own normals, if every one of them is a direction.
void copyNormals(vtkPolyData& polyData, const Kept& kept, SurfaceMesh& mesh)
{
    vtkDataArray* array = polyData.GetPointData()->GetNormals();
    if (!array) array = polyData.GetPointData()->GetArray("Normals");
    if (!array || array->GetNumberOfComponents() != 3) return;
    mesh.normals = gathered<glm::vec3>(*toFloats(array), kept.points);
    for (glm::vec3& normal : mesh.normals) {
        const float length = glm::length(normal);
        if (!(length > 1e-6f && std::isfinite(length))) {
            mesh.normals.clear();
            return;
        }
        normal /= length;
    }
}

/// How many of `triangles`' cells come from polygons; the others, behind them, from strips.
vtkIdType trianglesOfPolygons(vtkPolyData& input, vtkPolyData& triangles)
{
    if (input.GetNumberOfStrips() == 0) return triangles.GetNumberOfPolys();
    vtkNew<vtkPolyData> polygons;
    polygons->SetPoints(input.GetPoints());
    polygons->SetPolys(input.GetPolys());
    return triangulated(*polygons)->GetNumberOfPolys();
}

/// Where a piece's triangles stand among all: a file's pieces are put together polygons first, then strips, each in the
/// pieces' order, and ranks hold runs of them.
void numberTriangles(vtkPolyData& input, vtkPolyData& triangles, const Kept& kept, int rank, SurfaceMesh& mesh)
{
    // In data that came from the reader it is an array of the type's own name.
    vtkDataArray* const places = triangles.GetCellData()->GetArray(kTrianglesPlaces);
    if (places && places->GetDataType() == VTK_TYPE_UINT64 && places->GetNumberOfComponents() == 1) {
        const auto* values = static_cast<const vtkTypeUInt64*>(places->GetVoidPointer(0));
        for (const vtkIdType cell : kept.cells) mesh.order.push_back(values[cell]);
        return;
    }
    const vtkIdType polygons = trianglesOfPolygons(input, triangles);
    for (std::size_t i = 0; i < kept.cells.size(); ++i)
        mesh.order.push_back(std::uint64_t(kept.cells[i] >= polygons) << 63 | std::uint64_t(rank) << 40 | i);
}

}  // namespace

void tellColors(const ScalarChoice& scalar, LoadedSurface& surface)
{
    surface.scalarLabel = scalar.label();
    if (needsNormal(scalar.part)) surface.ofVectors = scalar.part;
}

LoadedSurface meshFromPolyData(vtkPolyData& given, const std::string& path, const SurfaceArrays& asked, bool cutOut,
                               const std::string& pieces)
{
    LoadedSurface surface;
    SurfaceArrays arrays = asked;
    surface.piece = arrays.part.split();
    surface.placed = !surface.piece;
    surface.mesh.name = path;
    surface.where = path + pieces;
    surface.cutOut = cutOut;
    requireSurface(given, surface.where, surface.piece);
    const bool isEmpty = given.GetNumberOfPolys() + given.GetNumberOfStrips() == 0;  // Of pieces alone.
    const vtkSmartPointer<vtkPolyData> whole =
        isEmpty ? &given : withVectors(given, arrays, surface.where).GetPointer();
    vtkPolyData& input = *whole;
    const vtkSmartPointer<vtkPolyData> finite = finiteCells(input, surface);
    surface.topology = polygonsHash(*finite);
    const bool empty = finite->GetNumberOfPolys() + finite->GetNumberOfStrips() == 0;
    if (empty && surface.piece) return surface;
    const vtkSmartPointer<vtkPolyData> polyData = triangulated(*finite);
    const Kept kept = copyGeometry(*polyData, surface);
    if (surface.piece) numberTriangles(*finite, *polyData, kept, arrays.part.rank, surface.mesh);
    surface.pointIds.assign(kept.points.begin(), kept.points.end());
    copyArrays(*finite, *polyData, arrays, kept, surface);
    copyNormals(*polyData, kept, surface.mesh);
    if (surface.mesh.triangles.empty() && !surface.piece)
        throw InputError(surface.where, "no polygon can be cut into triangles", "at least one triangle with an area");
    return surface;
}

}  // namespace aeolic
