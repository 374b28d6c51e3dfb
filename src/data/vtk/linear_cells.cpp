#include "data/vtk/linear_cells.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCompositeDataIterator.h>
#include <vtkHigherOrderHexahedron.h>
#include <vtkHigherOrderQuadrilateral.h>
#include <vtkHigherOrderTetra.h>
#include <vtkHigherOrderTriangle.h>
#include <vtkHigherOrderWedge.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <glm/glm.hpp>
#include <map>
#include <tuple>

#include "base/memory.h"
#include "data/vtk/arrays.h"

namespace aeolic {
namespace {

constexpr int kMostDegree = 10;  // VTK's own limit.

/// The degree for which count(degree) is the number of points; 0 where there is none.
template <class Count>
int degreeOf(vtkIdType points, const Count& count)
{
    for (int degree = 1; degree <= kMostDegree; ++degree)
        if (count(degree) == points) return degree;
    return 0;
}

/// Where a point of a simplex is: how many steps from its first corner to each of the others.
using Place2 = std::array<vtkIdType, 2>;
using Place3 = std::array<vtkIdType, 3>;

/// Calls take(a, b, c) for the places of the small triangles, which run around as the large one does.
template <class Take>
void forEachTriangle(int degree, const Take& take)
{
    for (vtkIdType i = 0; i < degree; ++i)
        for (vtkIdType j = 0; i + j < degree; ++j) {
            take(Place2{i, j}, Place2{i + 1, j}, Place2{i, j + 1});
            if (i + j + 1 < degree) take(Place2{i + 1, j}, Place2{i + 1, j + 1}, Place2{i, j + 1});
        }
}

/// Calls take(places) for the small tetrahedra: those at corners, four in the octahedra between, those upside down.
template <class Take>
void forEachTetra(int degree, const Take& take)
{
    const auto give = [&](std::array<Place3, 4> t) {
        const auto at = [&](int k) {
            return glm::dvec3(t[std::size_t(k)][0], t[std::size_t(k)][1], t[std::size_t(k)][2]);
        };
        if (glm::dot(at(1) - at(0), glm::cross(at(2) - at(0), at(3) - at(0))) < 0) std::swap(t[2], t[3]);
        take(t);
    };
    for (vtkIdType i = 0; i < degree; ++i)
        for (vtkIdType j = 0; i + j < degree; ++j)
            for (vtkIdType k = 0; i + j + k < degree; ++k) {
                const auto p = [&](int x, int y, int z) { return Place3{i + x, j + y, k + z}; };
                give({p(0, 0, 0), p(1, 0, 0), p(0, 1, 0), p(0, 0, 1)});
                if (i + j + k + 2 <= degree) {
                    const Place3 ring[] = {p(0, 1, 0), p(1, 1, 0), p(1, 0, 1), p(0, 0, 1)};
                    for (std::size_t r = 0; r < 4; ++r) give({p(1, 0, 0), p(0, 1, 1), ring[r], ring[(r + 1) % 4]});
                }
                if (i + j + k + 3 <= degree) give({p(1, 1, 0), p(1, 0, 1), p(0, 1, 1), p(1, 1, 1)});
            }
}

LagrangeCut cutTriangle(int degree)
{
    LagrangeCut cut{VTK_TRIANGLE, 3, {}};
    forEachTriangle(degree, [&](const Place2& a, const Place2& b, const Place2& c) {
        for (const auto& [i, j] : {a, b, c}) {
            const vtkIdType steps[] = {i, j, degree - i - j};  // VTK counts the first corner's last.
            cut.points.push_back(vtkHigherOrderTriangle::Index(steps, degree));
        }
    });
    return cut;
}

LagrangeCut cutTetra(int degree)
{
    LagrangeCut cut{VTK_TETRA, 4, {}};
    forEachTetra(degree, [&](const std::array<Place3, 4>& places) {
        for (const auto& [i, j, k] : places) {
            const vtkIdType steps[] = {i, j, k, degree - i - j - k};
            cut.points.push_back(vtkHigherOrderTetra::Index(steps, degree));
        }
    });
    return cut;
}

LagrangeCut cutWedge(int degree, int layers)
{
    LagrangeCut cut{VTK_WEDGE, 6, {}};
    const int order[4] = {degree, degree, layers, (degree + 1) * (degree + 2) / 2 * (layers + 1)};
    for (int k = 0; k < layers; ++k)
        forEachTriangle(degree, [&](const Place2& a, const Place2& b, const Place2& c) {
            for (const int level : {k, k + 1})
                for (const Place2& place : {a, b, c})
                    cut.points.push_back(
                        vtkHigherOrderWedge::PointIndexFromIJK(int(place[0]), int(place[1]), level, order));
        });
    return cut;
}

LagrangeCut cutQuad(const std::array<int, 3>& degrees)
{
    LagrangeCut cut{VTK_QUAD, 4, {}};
    for (int j = 0; j < degrees[1]; ++j)
        for (int i = 0; i < degrees[0]; ++i)
            for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                cut.points.push_back(vtkHigherOrderQuadrilateral::PointIndexFromIJK(i + x, j + y, degrees.data()));
    return cut;
}

LagrangeCut cutHexahedron(const std::array<int, 3>& degrees)
{
    LagrangeCut cut{VTK_HEXAHEDRON, 8, {}};
    for (int k = 0; k < degrees[2]; ++k)
        for (int j = 0; j < degrees[1]; ++j)
            for (int i = 0; i < degrees[0]; ++i)
                for (const int z : {0, 1})
                    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                        cut.points.push_back(
                            vtkHigherOrderHexahedron::PointIndexFromIJK(i + x, j + y, k + z, degrees.data()));
    return cut;
}

LagrangeCut cornersAlone(int vtkType, vtkIdType corners)
{
    LagrangeCut cut{vtkType, std::size_t(corners), {}};
    for (vtkIdType k = 0; k < corners; ++k) cut.points.push_back(k);
    return cut;
}

/// A linear cell and its corners; of no type where a cell of the type is none of higher order.
struct LinearCell {
    int vtkType = VTK_EMPTY_CELL;
    vtkIdType count = 0;
};

LinearCell linearCellOf(int vtkType)
{
    constexpr LinearCell corners[] = {{VTK_LINE, 2},       {VTK_TRIANGLE, 3}, {VTK_QUAD, 4},   {VTK_TETRA, 4},
                                      {VTK_HEXAHEDRON, 8}, {VTK_WEDGE, 6},    {VTK_PYRAMID, 5}};
    if (vtkType >= VTK_LAGRANGE_CURVE && vtkType <= VTK_LAGRANGE_PYRAMID) return corners[vtkType - VTK_LAGRANGE_CURVE];
    if (vtkType >= VTK_BEZIER_CURVE && vtkType <= VTK_BEZIER_PYRAMID) return corners[vtkType - VTK_BEZIER_CURVE];
    return {};
}

/// Along each axis; zeros where the number of points does not fit.
std::array<int, 3> degreesOf(int linearType, vtkIdType points, const std::array<int, 3>& told)
{
    const auto pow = [](vtkIdType n, int exponent) { return exponent == 2 ? n * n : n * n * n; };
    const bool areTold = *std::min_element(told.begin(), told.begin() + (linearType == VTK_QUAD ? 2 : 3)) >= 1 &&
                         *std::max_element(told.begin(), told.end()) <= kMostDegree;
    const vtkIdType a = told[0] + 1, b = told[1] + 1, c = told[2] + 1;
    int same = 0;
    switch (linearType) {
        case VTK_TRIANGLE:  // One more is in the middle of some quadratic ones.
            same = points == 7 ? 2 : degreeOf(points, [](vtkIdType n) { return (n + 1) * (n + 2) / 2; });
            break;
        case VTK_TETRA:
            same = points == 15 ? 2 : degreeOf(points, [](vtkIdType n) { return (n + 1) * (n + 2) * (n + 3) / 6; });
            break;
        case VTK_QUAD:
            if (areTold && a * b == points) return told;
            same = degreeOf(points, [&](vtkIdType n) { return pow(n + 1, 2); });
            break;
        case VTK_HEXAHEDRON:
            if (areTold && a * b * c == points) return told;
            same = degreeOf(points, [&](vtkIdType n) { return pow(n + 1, 3); });
            break;
        case VTK_WEDGE:
            if (areTold && a * (a + 1) / 2 * c == points) return told;
            same = degreeOf(points, [&](vtkIdType n) { return pow(n + 1, 2) * (n + 2) / 2; });
            break;
        default:
            break;
    }
    return {same, same, same};
}

/// Whether it is the type of a Lagrange or Bezier cell.
bool isOfHigherOrder(int vtkType)
{
    return linearCellOf(vtkType).count > 0;
}

/// The cuts of a grid's cells, each made once.
class Cuts {
public:
    explicit Cuts(vtkUnstructuredGrid& grid) : grid_(grid)
    {
        vtkDataArray* degrees = grid.GetCellData()->GetHigherOrderDegrees();
        if (!degrees) degrees = grid.GetCellData()->GetArray(kHigherOrderDegrees);
        if (degrees && degrees->GetNumberOfComponents() == 3 && degrees->GetNumberOfTuples() == grid.GetNumberOfCells())
            degrees_ = degrees;
    }

    /// Nothing where the cell stays.
    const LagrangeCut* of(vtkIdType cell)
    {
        const int type = grid_.GetCellType(cell);
        if (!isOfHigherOrder(type)) return nullptr;
        std::array<int, 3> degrees{0, 0, 0};
        for (std::size_t k = 0; degrees_ && k < 3; ++k)
            degrees[k] = int(std::clamp(degrees_->GetComponent(cell, int(k)), 0.0, 1e3));
        const vtkIdType points = grid_.GetCells()->GetCellSize(cell);
        const auto [at, isNew] = known_.try_emplace({type, points, degrees});
        if (isNew) at->second = lagrangeCut(type, points, degrees);
        return at->second ? &*at->second : nullptr;
    }

private:
    vtkUnstructuredGrid& grid_;
    vtkDataArray* degrees_ = nullptr;
    std::map<std::tuple<int, vtkIdType, std::array<int, 3>>, std::optional<LagrangeCut>> known_;
};

void makeLinear(vtkUnstructuredGrid& grid, const std::string& path)
{
    vtkUnsignedCharArray* const types = grid.GetCellTypesArray();
    const vtkIdType count = grid.GetNumberOfCells();
    if (!types || !grid.GetCells() || types->GetNumberOfValues() != count || grid.GetFaces()) return;
    if (std::none_of(types->GetPointer(0), types->GetPointer(0) + count,
                     [](int type) { return isOfHigherOrder(type); }))
        return;
    Cuts cuts(grid);
    std::uint64_t cells = 0, corners = 0;
    for (vtkIdType cell = 0; cell < count; ++cell) {
        const LagrangeCut* cut = cuts.of(cell);
        cells += cut ? cut->points.size() / cut->corners : 1;
        corners += cut ? cut->points.size() : std::uint64_t(grid.GetCells()->GetCellSize(cell));
    }
    requireMemory(path, fmt::format("cutting {} cells into {} linear ones", count, cells), 8 * corners + 32 * cells);
    vtkNew<vtkCellArray> linear;
    linear->AllocateExact(vtkIdType(cells), vtkIdType(corners));
    vtkNew<vtkUnsignedCharArray> linearTypes;
    vtkNew<vtkIdList> sources;
    vtkNew<vtkIdList> own;
    for (vtkIdType cell = 0; cell < count; ++cell) {
        grid.GetCells()->GetCellAtId(cell, own);
        const LagrangeCut* cut = cuts.of(cell);
        if (!cut) {
            linear->InsertNextCell(own);
            linearTypes->InsertNextValue(types->GetValue(cell));
            sources->InsertNextId(cell);
            continue;
        }
        for (std::size_t first = 0; first < cut->points.size(); first += cut->corners) {
            linear->InsertNextCell(int(cut->corners));
            for (std::size_t k = first; k < first + cut->corners; ++k)
                linear->InsertCellPoint(own->GetId(cut->points[k]));
            linearTypes->InsertNextValue(static_cast<unsigned char>(cut->vtkType));
            sources->InsertNextId(cell);
        }
    }
    vtkNew<vtkCellData> values;
    takeTuples(*grid.GetCellData(), *sources, *values);
    grid.SetCells(linearTypes, linear);
    grid.GetCellData()->ShallowCopy(values);
}

/// Whether each array of the cells has a value for each: else who checks the data says so.
bool hasValues(vtkUnstructuredGrid& grid)
{
    vtkCellData& all = *grid.GetCellData();
    for (int k = 0; k < all.GetNumberOfArrays(); ++k)
        if (all.GetAbstractArray(k)->GetNumberOfTuples() != grid.GetNumberOfCells()) return false;
    return true;
}

}  // namespace

std::optional<LagrangeCut> lagrangeCut(int vtkType, vtkIdType points, const std::array<int, 3>& degrees)
{
    const LinearCell corners = linearCellOf(vtkType);
    if (corners.count == 0 || points < corners.count) return std::nullopt;
    const bool onlyCorners =
        vtkType >= VTK_BEZIER_CURVE || corners.vtkType == VTK_LINE || corners.vtkType == VTK_PYRAMID;
    if (onlyCorners) return cornersAlone(corners.vtkType, corners.count);
    if (corners.vtkType == VTK_WEDGE && points == 21) return cornersAlone(VTK_WEDGE, 6);
    const std::array<int, 3> d = degreesOf(corners.vtkType, points, degrees);
    if (d[0] == 0) return std::nullopt;
    switch (corners.vtkType) {
        case VTK_TRIANGLE:
            return cutTriangle(d[0]);
        case VTK_TETRA:
            return cutTetra(d[0]);
        case VTK_QUAD:
            return cutQuad(d);
        case VTK_HEXAHEDRON:
            return cutHexahedron(d);
        default:
            return cutWedge(d[0], d[2]);
    }
}

void makeCellsLinear(vtkDataObject& data, const std::string& path)
{
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data); grid && hasValues(*grid)) makeLinear(*grid, path);
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(&data);
    if (!blocks) return;
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
        if (auto* grid = vtkUnstructuredGrid::SafeDownCast(at->GetCurrentDataObject()); grid && hasValues(*grid))
            makeLinear(*grid, path);
}

}  // namespace aeolic
