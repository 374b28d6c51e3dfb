#include "engine/surface_pick.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "cluster/comm/communicator.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

glm::dvec3 toGlm(const Vec3& v)
{
    return {v[0], v[1], v[2]};
}

SceneDescription described(const std::string& surface, const std::string& field)
{
    SceneDescription scene;
    scene.surface.spec = surface;
    scene.field.spec = field;
    scene.output.width = 90;
    scene.output.height = 70;
    scene.lic.steps = 4;
    scene.shading.background = "transparent";
    scene.run.backend = BackendChoice::cpu;
    return scene;
}

/// The picture and what is picked are the same surface: rasterizing moves corners by up to half a sub-pixel.
TEST(SurfacePick, ThereIsAPlaceWhereThePictureHasOne)
{
    for (const char* surface : {"torus:2000", "teapot:3000", "plane"}) {
        SceneDescription scene = described(surface, "abc:9,9,9");
        scene.shading.antialias = false;
        Renderer renderer(scene);
        const Picture picture = renderer.render();
        ASSERT_EQ(picture.channels, 4);
        int others = 0, covered = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const bool isCovered = picture.pixels[std::size_t(4 * (y * picture.width + x) + 3)] > 0;
                covered += isCovered;
                others += isCovered != renderer.pick(x, y).has_value();
            }
        EXPECT_GT(covered, 500) << surface;
        EXPECT_LE(others, 6) << surface;
    }
}

TEST(SurfacePick, APlaceLiesOnTheSurfaceAndHasItsFieldsVector)
{
    SceneDescription scene = described("sphere:20000", "rotation:65,65,65");
    scene.shading.colorBy = "rotation:mag";
    Renderer renderer(scene);
    const auto place = renderer.pick(50, 20);
    ASSERT_TRUE(place && place->vector && place->tangential && place->scalar);
    const glm::dvec3 position = toGlm(place->position), normal = toGlm(place->normal), vector = toGlm(*place->vector);
    EXPECT_NEAR(glm::length(position), 1, 2e-3) << "a sphere of triangles";
    EXPECT_GT(glm::dot(glm::normalize(position), normal), 0.999) << "the near side, seen from outside";
    // The built-in flow turns around z.
    const double turns = glm::length(vector) / std::hypot(position.x, position.y);
    EXPECT_NEAR(vector.x / turns, -position.y, 1e-4);
    EXPECT_NEAR(vector.y / turns, position.x, 1e-4);
    EXPECT_NEAR(glm::dot(toGlm(*place->tangential), normal), 0, 1e-9);
    EXPECT_NEAR(*place->scalar, glm::length(vector), 1e-9);
    EXPECT_EQ(place->scalarName, "|rotation|");
    EXPECT_FALSE(renderer.pick(0, 0));
}

/// Two triangles, one behind the other.
class PickOfTriangles : public testing::Test {
protected:
    PickOfTriangles()
    {
        scene_.surface.positions = {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, {-1, 2, -1}, {1, 2, -1}, {0, 2, 1}};
        scene_.surface.triangles = {{3, 4, 5}, {0, 1, 2}};
        scene_.surface.pointVectors = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
        scene_.surface.pointScalars = {10, 20, 30, 0, 0, 0};
        scene_.hasScalar = true;
        scene_.scalarName = "p";
        camera_.positionWorld = {0, -10, 0};
        camera_.width = camera_.height = 101;
        camera_.focalPx = 500;
        camera_.nearDepth = 1;
        camera_.farDepth = 20;
    }

    Scene scene_;
    Camera camera_;  // It looks along +y. A pixel is 0.02 wide at the near triangle, whose tip is in the uppermost row.
};

TEST_F(PickOfTriangles, ValuesAreExactAtCornersAndLinearBetween)
{
    const auto corner = pickSurface(scene_, camera_, 50, 0);
    ASSERT_TRUE(corner && corner->vector && corner->tangential);
    EXPECT_EQ(corner->position, (Vec3{0, 0, 1}));
    EXPECT_EQ(*corner->vector, (Vec3{7, 8, 9}));
    EXPECT_EQ(corner->scalar, 30);
    EXPECT_EQ(corner->triangle, 1u);
    EXPECT_EQ(corner->depth, 10);
    EXPECT_EQ(corner->normal, (Vec3{0, -1, 0}));
    EXPECT_EQ(*corner->tangential, (Vec3{7, 0, 9}));
    const auto middle = pickSurface(scene_, camera_, 50, 50);
    ASSERT_TRUE(middle && middle->vector && middle->scalar);
    EXPECT_NEAR(*middle->scalar, 22.5, 1e-12);
    EXPECT_NEAR((*middle->vector)[0], 4.75, 1e-12);
    EXPECT_FALSE(pickSurface(scene_, camera_, 0, 0));
}

TEST_F(PickOfTriangles, FacesBeforeTheEyeAndInTheSamePlace)
{
    camera_.nearDepth = 11;
    EXPECT_EQ(pickSurface(scene_, camera_, 50, 50)->triangle, 0u) << "the near one is cut away";
    camera_.nearDepth = 1;
    scene_.surface.triangles = {{0, 2, 1}, {0, 1, 2}};
    EXPECT_EQ(pickSurface(scene_, camera_, 50, 50)->triangle, 1u) << "the one that is turned to the viewer";
    scene_.surface.triangles = {{0, 1, 2}, {0, 1, 2}};
    EXPECT_EQ(pickSurface(scene_, camera_, 50, 50)->triangle, 0u) << "the first one";
    scene_.surface.triangles = {{0, 2, 1}};
    EXPECT_EQ(pickSurface(scene_, camera_, 50, 50)->normal, (Vec3{0, -1, 0})) << "towards the viewer";
    scene_.frontFacesOnly = true;
    EXPECT_FALSE(pickSurface(scene_, camera_, 50, 50));
}

TEST_F(PickOfTriangles, MaskedValuesAndSurfacesWithoutThem)
{
    scene_.surface.pointVectors[2] = glm::vec3(NAN);
    scene_.surface.pointScalars[2] = NAN;
    const auto masked = pickSurface(scene_, camera_, 50, 50);
    EXPECT_FALSE(masked->vector || masked->tangential || masked->scalar);
    EXPECT_EQ(masked->scalarName, "p");
    scene_.surface.surfaceOf = {1, 1, 1, 0, 0, 0};
    scene_.surfaces = {{.name = "far.vtp"}, {.name = "near.vtp", .streaks = false}};
    const auto plain = pickSurface(scene_, camera_, 50, 50);
    EXPECT_EQ(plain->surface, "near.vtp");
    EXPECT_FALSE(plain->vector || plain->scalar);
    EXPECT_EQ(plain->scalarName, "");
    scene_.surface.triangles.clear();
    EXPECT_FALSE(pickSurface(scene_, camera_, 50, 50));
}

TEST(SurfacePick, PixelsOutsideAreRefused)
{
    const SceneDescription scene = described("torus:500", "abc:9,9,9");
    Renderer renderer(scene);
    for (const auto& [x, y] : {std::pair{-1, 0}, {90, 0}, {0, 70}}) EXPECT_THROW(renderer.pick(x, y), InputError);
    try {
        renderer.pick(3, 70);
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "pick: pixel 3,70; expected 0,0 to 89,69");
    }
}

TEST(SurfacePick, AllRanksFindTheSame)
{
    const SceneDescription scene = described("torus:500", "abc:9,9,9");
    SceneDescription split = scene;
    split.run.bricks = BrickChoice::on;
    const auto alone = Renderer(scene).pick(45, 20);
    ASSERT_TRUE(alone);
    runRanks(2, [&](Communicator& group) {
        const std::shared_ptr<Communicator> ranks(&group, [](Communicator*) {});
        Renderer whole(scene, ranks);
        const auto place = whole.pick(45, 20);
        EXPECT_TRUE(place && place->position == alone->position && place->vector == alone->vector);
        const auto inBricks = Renderer(split, ranks).pick(45, 20);
        EXPECT_TRUE(inBricks && inBricks->position == alone->position && inBricks->vector == alone->vector);
    });
}

}  // namespace
}  // namespace aeolic
