#include "data/vtk/lagrange_cells.h"

#include <vtkCellType.h>
#include <vtkHigherOrderHexahedron.h>
#include <vtkHigherOrderQuadrilateral.h>
#include <vtkHigherOrderTetra.h>
#include <vtkHigherOrderTriangle.h>
#include <vtkHigherOrderWedge.h>

#include <algorithm>
#include <glm/glm.hpp>
#include <map>
#include <tuple>

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

/// The numbers of a simplex's points by where they are: how many steps from its first corner to each of the others.
/// `Cell`: VTK's class of it.
template <class Cell, std::size_t Corners>
std::map<std::array<vtkIdType, Corners - 1>, vtkIdType> pointsOfSimplex(int degree, vtkIdType points)
{
    std::array<std::size_t, Corners> isAt{};  // Which coordinate is greatest at a corner.
    const auto coordinates = [&](vtkIdType point) {
        std::array<vtkIdType, Corners> b{};
        Cell::BarycentricIndex(point, b.data(), degree);
        return b;
    };
    for (std::size_t corner = 0; corner < Corners; ++corner) {
        const auto b = coordinates(vtkIdType(corner));
        isAt[corner] = std::size_t(std::max_element(b.begin(), b.end()) - b.begin());
    }
    std::map<std::array<vtkIdType, Corners - 1>, vtkIdType> numbers;
    for (vtkIdType point = 0; point < points; ++point) {
        const auto b = coordinates(point);
        std::array<vtkIdType, Corners - 1> place{};
        for (std::size_t k = 1; k < Corners; ++k) place[k - 1] = b[isAt[k]];
        numbers[place] = point;
    }
    return numbers;
}

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
    const auto numbers = pointsOfSimplex<vtkHigherOrderTriangle, 3>(degree, vtkIdType(degree + 1) * (degree + 2) / 2);
    forEachTriangle(degree, [&](const Place2& a, const Place2& b, const Place2& c) {
        for (const Place2& place : {a, b, c}) cut.points.push_back(numbers.at(place));
    });
    return cut;
}

LagrangeCut cutTetra(int degree)
{
    LagrangeCut cut{VTK_TETRA, 4, {}};
    const auto numbers =
        pointsOfSimplex<vtkHigherOrderTetra, 4>(degree, vtkIdType(degree + 1) * (degree + 2) * (degree + 3) / 6);
    forEachTetra(degree, [&](const std::array<Place3, 4>& places) {
        for (const Place3& place : places) cut.points.push_back(numbers.at(place));
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

}  // namespace

bool isOfHigherOrder(int vtkType)
{
    return linearCellOf(vtkType).count > 0;
}

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

}  // namespace aeolic
