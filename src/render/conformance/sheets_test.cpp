#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "render_testing.h"

/// A pixel's links: to all neighbours on its own sheet of the surface, to none on another. Nothing of a picture's front
/// may depend on what lies behind it.
namespace aeolic {
namespace {

using namespace testkit;

class Sheets : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Sheets, allBackends, backendName);

bool linked(const GBuffer& buffer, int x, int y, int sx, int sy)
{
    return buffer.links.at(x, y) >> linkBit(sx, sy) & 1;
}

/// Calls visit(x, y, sx, sy) for every pair of neighbours that both have flow.
void forEachPair(const GBuffer& buffer, const std::function<void(int x, int y, int sx, int sy)>& visit)
{
    const Extent& all = buffer.valid();
    for (int y = all.y0; y < all.y1; ++y)
        for (int x = all.x0; x < all.x1; ++x)
            for (int sy = -1; sy <= 1; ++sy)
                for (int sx = -1; sx <= 1; ++sx) {
                    if ((sx == 0 && sy == 0) || !all.contains(x + sx, y + sy)) continue;
                    if (buffer.flow.at(x, y) != 0 && buffer.flow.at(x + sx, y + sy) != 0) visit(x, y, sx, sy);
                }
}

struct Counts {
    int within = 0, withinLinked = 0, between = 0, betweenLinked = 0;
};

/// Neighbours on the same side, and on different sides, of a depth that separates two parts of the scene.
Counts countAcross(const GBuffer& buffer, double depth)
{
    Counts counts;
    forEachPair(buffer, [&](int x, int y, int sx, int sy) {
        const bool frontA = double(buffer.invDepth.at(x, y)) * depth > 1,
                   frontB = double(buffer.invDepth.at(x + sx, y + sy)) * depth > 1;
        const bool isLinked = linked(buffer, x, y, sx, sy);
        (frontA == frontB ? counts.within : counts.between) += 1;
        (frontA == frontB ? counts.withinLinked : counts.betweenLinked) += isLinked;
    });
    return counts;
}

const VectorAt kAlongX = [](const glm::dvec3&) { return glm::vec3(1, 0, 0); };
const VectorAt kAlongY = [](const glm::dvec3&) { return glm::vec3(0, 1, 0); };

SurfaceMesh plane(double z, double half, const VectorAt& flow)
{
    SurfaceMesh mesh = makeRectangle({0, 0, z}, {half, 0, 0}, {0, half, 0});
    setPointVectors(mesh, flow);
    return mesh;
}

TEST_P(Sheets, LinksAreMutual)
{
    Stages stages(GetParam(), makeBuiltinScene("teapot:6000", "abc:16,16,16"));
    const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, 120, 90), directLic(8));
    forEachPair(buffer, [&](int x, int y, int sx, int sy) {
        EXPECT_EQ(linked(buffer, x, y, sx, sy), linked(buffer, x + sx, y + sy, -sx, -sy)) << x << "," << y;
    });
}

TEST_P(Sheets, BackgroundAndTheImagesBorderAreLinkedToNothing)
{
    Stages stages(GetParam(), makeBuiltinScene("torus:2000", "abc:16,16,16"));
    CameraOptions close;
    close.zoom = 1.7;  // Runs out of the image.
    const GBuffer& buffer = stages.project(fitCamera(stages.scene, close, 70, 50), directLic(8));
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 70; ++x)
            for (int sy = -1; sy <= 1; ++sy)
                for (int sx = -1; sx <= 1; ++sx) {
                    if (sx == 0 && sy == 0) continue;
                    const bool inside = buffer.valid().contains(x + sx, y + sy);
                    const bool bothFlow = inside && buffer.flow.at(x, y) != 0 && buffer.flow.at(x + sx, y + sy) != 0;
                    EXPECT_FALSE(!bothFlow && linked(buffer, x, y, sx, sy)) << x << "," << y;
                }
}

/// The flow of the surface in front and that of the surface behind do not touch each other, bit by bit.
TEST_P(Sheets, FlowBehindASilhouetteChangesNothingInFront)
{
    constexpr double middle = 4.5;
    const auto valuesWith = [&](const VectorAt& front, const VectorAt& back, bool wantFront) {
        SurfaceMesh mesh = plane(1, 0.5, front);
        append(mesh, plane(0, 2, back));
        Stages stages(GetParam(), makeScene(std::move(mesh)));
        const LicOptions lic = directLic(30);
        const GBuffer& buffer = stages.project(frontCamera(stages.scene, 5, 100, 80), lic);
        const Image<float>& found = stages.convolve(lic);
        std::vector<float> values;
        for (int y = 0; y < 80; ++y)
            for (int x = 0; x < 100; ++x) {
                const double invDepth = double(buffer.invDepth.at(x, y));
                if (invDepth > 0 && (invDepth * middle > 1) == wantFront) values.push_back(found.at(x, y));
            }
        return values;
    };
    const std::vector<float> front = valuesWith(kAlongX, kAlongX, true), back = valuesWith(kAlongX, kAlongX, false);
    ASSERT_GT(front.size(), 500u);
    ASSERT_GT(back.size(), 500u);
    EXPECT_EQ(front, valuesWith(kAlongX, kAlongY, true));
    EXPECT_EQ(back, valuesWith(kAlongY, kAlongX, false));
    EXPECT_NE(front, valuesWith(kAlongY, kAlongX, true));
    EXPECT_NE(back, valuesWith(kAlongX, kAlongY, false));
}

/// However flat the view, a plane is one sheet: a fixed tolerance of depth would tear it into single pixels.
TEST_P(Sheets, APlaneAtAGrazingAngleIsOneSheet)
{
    for (const double elevation : {45.0, 10.0, 2.0, 0.5}) {
        Stages stages(GetParam(), makeScene([] {
                          SurfaceMesh mesh = makeRectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 8);
                          setPointVectors(mesh, kAlongX);
                          return mesh;
                      }()));
        CameraOptions options;
        options.azimuth = 20;
        options.elevation = elevation;
        options.zoom = 1.2;
        const GBuffer& buffer = stages.project(fitCamera(stages.scene, options, 160, 160), directLic(8));
        const Counts counts = countAcross(buffer, 1e-3);
        EXPECT_GT(counts.within, 100);
        EXPECT_EQ(counts.withinLinked, counts.within) << elevation;
    }
}

/// A crease is not a silhouette: streaks run over the edges of a cube, not from the cube onto the wall behind it.
TEST_P(Sheets, ACubesEdgesAreLinkedAndItsSilhouetteIsNot)
{
    for (const auto& [azimuth, elevation] :
         {std::pair(30.0, 20.0), std::pair(45.0, 35.26), std::pair(3.0, 2.0), std::pair(80.0, 60.0)}) {
        SurfaceMesh mesh = makeCube({0, 0, 0}, 0.5);
        setPointVectors(mesh, [](const glm::dvec3& p) { return glm::vec3(1 + p.y, 0.5 - p.z, 0.7 + p.x); });
        CameraOptions options;
        options.azimuth = azimuth;
        options.elevation = elevation;
        options.fov = 20;
        const Camera direction = makeCamera(options, mesh.bounds(), 0.9, 120, 120);
        // A wall behind, across the view.
        SurfaceMesh wall = makeRectangle(4.0 * direction.forward, 6.0 * direction.right, 6.0 * direction.up);
        setPointVectors(wall, [&](const glm::dvec3&) { return glm::vec3(direction.right); });
        append(mesh, wall);
        Stages stages(GetParam(), makeScene(std::move(mesh)));
        options.position = Vec3{direction.positionWorld.x, direction.positionWorld.y, direction.positionWorld.z};
        options.focal = Vec3{0, 0, 0};
        options.up = Vec3{0, 0, 1};
        const GBuffer& buffer = stages.project(fitCamera(stages.scene, options, 120, 120), directLic(8));
        const Counts counts = countAcross(buffer, direction.focalDistance + 2);
        EXPECT_GT(counts.between, 100);
        EXPECT_EQ(counts.betweenLinked, 0) << azimuth << "," << elevation;
        EXPECT_EQ(counts.withinLinked, counts.within) << azimuth << "," << elevation;
    }
}

/// At the limb the sphere's own slope goes to infinity: hardly any of its pixels may come loose, none may be tied to
/// the plane.
TEST_P(Sheets, ASphereStandsOutFromThePlaneBehindIt)
{
    for (const double gap : {0.2, 1.0, 10.0}) {
        SurfaceMesh mesh = makeBuiltinScene("sphere:20000", "uniform:2,2,2").surface;
        setPointVectors(mesh, [](const glm::dvec3& p) { return glm::vec3(-p.y, p.x, 0.3); });
        append(mesh, plane(-1 - gap, 3 + gap, kAlongX));
        Stages stages(GetParam(), makeScene(std::move(mesh)));
        const GBuffer& buffer = stages.project(frontCamera(stages.scene, 8, 160, 160, 25), directLic(8));
        // What of the sphere is in view lies in front of its centre.
        const Counts counts = countAcross(buffer, 8.0);
        EXPECT_GT(counts.between, 200);
        EXPECT_EQ(counts.betweenLinked, 0) << gap;
        EXPECT_GT(counts.withinLinked, 0.997 * counts.within) << gap;
    }
}

/// A curved surface without silhouettes inside has no seams, however coarse its facets.
TEST_P(Sheets, FacetsOfASmoothSurfaceAreOneSheet)
{
    for (const char* surface : {"sphere:100", "sphere:1000", "sphere:25000"}) {
        Stages stages(GetParam(), makeBuiltinScene(surface, "abc:16,16,16"));
        const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, 150, 150), directLic(8));
        const Counts counts = countAcross(buffer, 1e-3);
        EXPECT_GT(counts.within, 50000);
        EXPECT_GT(counts.withinLinked, 0.997 * counts.within) << surface;
    }
}

}  // namespace
}  // namespace aeolic
