#include "render/overlay/mesh_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "data/builtin/surfaces.h"
#include "render/overlay/text_size.h"
#include "render_testing.h"

namespace aeolic {
namespace {

using namespace testkit;

constexpr int kSide = 201, kMiddle = 100;
constexpr double kFar = 10;

/// What an overlay paints of a mesh where nothing hides it.
class MeshLinesTest : public testing::Test {
protected:
    template <class Lines>
    void draw(const SurfaceMesh& mesh)
    {
        scene_ = makeScene(mesh);
        view_ = makeView(frontCamera(scene_, kFar, kSide, kSide), scene_, {});
        SeenSurface seen;
        seen.resize({0, 0, kSide, kSide});
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) seen.invDepth.at(x, y) = 0;
        tile_ = {};
        tile_.resize({0, 0, kSide, kSide});
        tile_.setBackground({255, 255, 255, 255});
        for (int y = 0; y < kSide; ++y) tile_.clearBeside(y, {});
        Lines(scene_.surface).draw(view_, seen, tile_);
    }

    /// The pixel that shows a place of the world is darker than the ground.
    bool isPainted(const glm::dvec3& world) const
    {
        const glm::vec3 way = fromEye(view_, glm::vec3(world - scene_.surface.originWorld));
        const StrokeEnd end = strokeEnd(view_, way);
        return isPainted(int(end.px.x), int(end.px.y));
    }
    bool isPainted(int x, int y) const { return tile_.row(y)[4 * x] < 230; }

    Scene scene_;
    View view_;
    Tile tile_;
};

TEST_F(MeshLinesTest, TheOutlineOfASphereIsACircle)
{
    draw<SurfaceOutline>(makeBuiltinSurface("sphere:20000"));
    const double radius = double(view_.focalPx) / std::sqrt(kFar * kFar - 1);
    int painted = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            if (!isPainted(x, y)) continue;
            ++painted;
            ASSERT_NEAR(std::hypot(x - kMiddle, y - kMiddle), radius, 2.5);
        }
    EXPECT_GT(painted, 6 * radius);
}

TEST_F(MeshLinesTest, TheOutlineOfACubeIsItsEdges)
{
    draw<SurfaceOutline>(makeCube({0, 0, 0}, 1));
    for (const double a : {-1, 1})
        for (const double b : {-1, 1}) {
            EXPECT_TRUE(isPainted({0.5, a, b}));
            EXPECT_TRUE(isPainted({a, 0.5, b}));
            EXPECT_TRUE(isPainted({a, b, 0.5}));
        }
    EXPECT_FALSE(isPainted({0.5, 0.5, 1}));  // The diagonal of a face.
}

TEST_F(MeshLinesTest, ABorderIsInTheOutlineAndADiagonalIsAnEdge)
{
    const SurfaceMesh plane = makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    draw<SurfaceOutline>(plane);
    EXPECT_TRUE(isPainted({0.3, 1, 0}) && isPainted({-1, 0.3, 0}));
    EXPECT_FALSE(isPainted({0.3, 0.3, 0}) || isPainted({0.3, -0.3, 0}));
    draw<MeshEdges>(plane);
    EXPECT_TRUE(isPainted({0.3, 1, 0}) && isPainted({-1, 0.3, 0}));
    EXPECT_TRUE(isPainted({0.3, 0.3, 0}) || isPainted({0.3, -0.3, 0}));
}

TEST_F(MeshLinesTest, AFaceThatIsThereTwiceHasNoBorder)
{
    SurfaceMesh plane = makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2);
    plane.triangles.push_back(plane.triangles[0]);
    draw<SurfaceOutline>(plane);
    // Where two of its sides are borders they no longer are.
    EXPECT_FALSE(isPainted({0, -0.5, 0}) || isPainted({-0.5, 0, 0}));
    EXPECT_TRUE(isPainted({1, 0.3, 0}) && isPainted({0.3, 1, 0}));
}

TEST_F(MeshLinesTest, EdgesThatAreShortInThePictureFade)
{
    draw<MeshEdges>(makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 200));
    int painted = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) painted += isPainted(x, y) ? 1 : 0;
    EXPECT_EQ(painted, 0);
}

/// Points of a mesh without a triangle, and an eye inside of it.
TEST_F(MeshLinesTest, NothingAndAllAroundAreInOrder)
{
    draw<MeshEdges>(makeCube({0, 0, kFar}, 1));
    draw<SurfaceOutline>(makeCube({0, 0, kFar}, 1));
    SurfaceMesh triangle;
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.normals.assign(3, {0, 0, 1});
    triangle.triangles = {{0, 1, 2}};
    draw<SurfaceOutline>(triangle);
    EXPECT_TRUE(isPainted({0.5, 0.5, 0}));
}

}  // namespace
}  // namespace aeolic
