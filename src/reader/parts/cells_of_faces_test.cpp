#include "reader/parts/cells_of_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "aeolic/error.h"
#include "reader/openfoam/foam_volume.h"

namespace aeolic {
namespace {

using Corners = std::vector<std::int64_t>;

/// All faces belong to cell 1, seen from outside of it. `turned`: which of them stand the other way round, as the faces
/// of a neighbour do.
CellsOfFaces oneCell(const std::vector<Corners>& faces, FirstCorner firstCorner, unsigned turned)
{
    MeshFaces mesh;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        Corners face = faces[i];
        const bool other = (turned >> i & 1) != 0;
        if (other) std::reverse(face.begin(), face.end());
        mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
        mesh.ends.push_back(mesh.corners.size());
        mesh.inside.push_back(other ? 0 : 1);
        mesh.outside.push_back(other ? 1 : 0);
    }
    return {std::move(mesh), 1, firstCorner, "a mesh"};
}

double volumeOf(const std::array<glm::dvec3, 4>& p)
{
    return glm::dot(p[1] - p[0], glm::cross(p[2] - p[0], p[3] - p[0])) / 6;
}

/// Positive where the corners stand in the order of the shape.
double volumeOf(CellShape shape, const Corners& corners, const std::vector<glm::dvec3>& points)
{
    const auto tetra = [&](std::array<std::size_t, 4> of) {
        const auto at = [&](std::size_t k) { return points[std::size_t(corners[of[k]])]; };
        return volumeOf({at(0), at(1), at(2), at(3)});
    };
    if (shape == CellShape::tetra) return tetra({0, 1, 2, 3});
    if (shape == CellShape::pyramid) return tetra({0, 1, 2, 4}) + tetra({0, 2, 3, 4});
    if (shape == CellShape::wedge) return tetra({0, 1, 2, 3}) + tetra({1, 2, 3, 4}) + tetra({2, 3, 4, 5});
    return tetra({0, 1, 3, 4}) + tetra({1, 2, 3, 6}) + tetra({1, 3, 4, 6}) + tetra({4, 6, 5, 1}) + tetra({4, 7, 6, 3});
}

struct Simple {
    CellShape shape;
    std::vector<glm::dvec3> points;
    std::vector<Corners> faces;
    double volume;
};

const std::vector<glm::dvec3> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

const std::vector<Simple> simple{{CellShape::tetra,
                                  {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                  {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}},
                                  1. / 6},
                                 {CellShape::pyramid,
                                  {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}},
                                  {{0, 1, 4}, {0, 3, 2, 1}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
                                  1. / 3},
                                 {CellShape::wedge,
                                  {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                                  {{0, 1, 4, 3}, {0, 2, 1}, {3, 4, 5}, {1, 2, 5, 4}, {2, 0, 3, 5}},
                                  0.5},
                                 {CellShape::hexahedron,
                                  cube,
                                  {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
                                  1}};

TEST(CellsOfFaces, SimpleCellsAreKnownHoweverTheirFacesStand)
{
    for (const Simple& cell : simple)
        for (const FirstCorner first : {FirstCorner::last, FirstCorner::first})
            for (unsigned turned = 0; turned < 1u << cell.faces.size(); ++turned) {
                const auto cells = oneCell(cell.faces, first, turned).cells(1, 1);
                ASSERT_EQ(cells.size(), 1u);
                ASSERT_EQ(cells[0].shape, cell.shape);
                EXPECT_TRUE(sizesFit(cells[0]));
                EXPECT_NEAR(volumeOf(cell.shape, cells[0].corners, cell.points), cell.volume, 1e-12) << turned;
            }
}

/// Its corners begin where those of VTK's reader of OpenFOAM began, whose pictures are kept.
TEST(CellsOfFaces, TheFirstCornerIsThatOfTheBase)
{
    const auto& faces = simple[3].faces;
    EXPECT_EQ(oneCell(faces, FirstCorner::first, 0).cells(1, 1)[0].corners, (Corners{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(oneCell(faces, FirstCorner::last, 0).cells(1, 1)[0].corners, (Corners{1, 2, 3, 0, 5, 6, 7, 4}));
    EXPECT_EQ(oneCell(faces, FirstCorner::first, 1).cells(1, 1)[0].corners, (Corners{1, 2, 3, 0, 5, 6, 7, 4}));
}

/// A cube whose side at x = 1 is two triangles.
const std::vector<Corners> splitCube{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6},
                                     {1, 6, 5},    {2, 3, 7, 6}, {3, 0, 4, 7}};

TEST(CellsOfFaces, OtherCellsArePolyhedra)
{
    for (const unsigned turned : {0u, 5u, 127u}) {
        const auto cells = oneCell(splitCube, FirstCorner::first, turned).cells(1, 1);
        ASSERT_EQ(cells.size(), 1u);
        EXPECT_EQ(cells[0].shape, CellShape::polyhedron);
        EXPECT_EQ(cells[0].sizes, Corners{7});
        EXPECT_EQ(cells[0].ofFaces, (Corners{4, 4, 4, 3, 3, 4, 4}));
    }
}

TEST(CellsOfFaces, StarsFillThePolyhedron)
{
    for (const unsigned turned : {0u, 5u, 127u}) {
        const CellsOfFaces all = oneCell(splitCube, FirstCorner::first, turned);
        std::vector<PartCells> cells = all.cells(1, 1);
        std::vector<glm::dvec3> points = cube;
        EXPECT_EQ(cutIntoStars(all, cells, points), (std::vector<std::size_t>(6, 0)));
        ASSERT_EQ(points.size(), 9u);
        EXPECT_EQ(points.back(), glm::dvec3(0.5));
        double sum = 0;
        std::size_t count = 0;
        for (const PartCells& each : cells)
            for (std::size_t i = 0; i < each.count; ++i, ++count) {
                const auto begin = each.corners.begin() + std::ptrdiff_t(i * cornersOf(each.shape));
                const double volume =
                    volumeOf(each.shape, {begin, begin + std::ptrdiff_t(cornersOf(each.shape))}, points);
                EXPECT_GT(volume, 0);
                sum += volume;
            }
        EXPECT_EQ(count, 7u) << "a pyramid or a tetrahedron on each face";
        EXPECT_NEAR(sum, 1, 1e-12);
    }
}

TEST(CellsOfFaces, ACellOfThreeFacesIsRefused)
{
    const CellsOfFaces all = oneCell({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}, FirstCorner::last, 0);
    EXPECT_THROW(all.cells(1, 1), InputError);
}

TEST(CellsOfFaces, EdgesMakeAPolygonInAnyOrder)
{
    const auto polygons = oneCell({{0, 1}, {3, 2}, {1, 2}, {3, 0}}, FirstCorner::last, 0).polygons(1, 1);
    ASSERT_EQ(polygons.size(), 1u);
    EXPECT_EQ(polygons[0].corners, (Corners{0, 1, 2, 3}));
    EXPECT_THROW(oneCell({{0, 1}, {1, 2}, {2, 3}}, FirstCorner::last, 0).polygons(1, 1), InputError);
}

}  // namespace
}  // namespace aeolic
