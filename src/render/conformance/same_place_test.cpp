#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "render_testing.h"

/// Faces in the same place: of a thin wall the side that is turned to the viewer shows, all over.
namespace aeolic {
namespace {

using namespace testkit;

class SamePlace : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, SamePlace, allBackends, backendName);

constexpr int kWidth = 160, kHeight = 120;

/// Sides differ in their scalar.
void setScalar(SurfaceMesh& mesh, float value)
{
    mesh.pointScalars.assign(mesh.positions.size(), value);
}

void turnRound(SurfaceMesh& mesh)
{
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    for (glm::vec3& n : mesh.normals) n = -n;
}

/// Another corner first, and another order of triangles: nothing that is seen.
void shuffle(SurfaceMesh& mesh, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    for (auto& t : mesh.triangles) std::rotate(t.begin(), t.begin() + random() % 3, t.end());
}

SurfaceMesh side(int cells, float value, const glm::dvec3& u = {2, 0.3, 0.4}, const glm::dvec3& v = {-0.2, 1.5, 1.1})
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, u, v, cells);
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(1, 0.2, 0); });
    setScalar(mesh, value);
    return mesh;
}

void add(SurfaceMesh& mesh, const SurfaceMesh& other)
{
    std::vector<float> scalars = mesh.pointScalars;
    scalars.insert(scalars.end(), other.pointScalars.begin(), other.pointScalars.end());
    append(mesh, other);
    mesh.pointScalars = scalars;
}

/// The share of the pixels of `mesh` seen from `camera` that shows `value`.
double shareOf(const std::string& backend, SurfaceMesh mesh, const CameraOptions& camera, float value,
               bool frontOnly = false)
{
    Scene scene = makeScene(std::move(mesh));
    scene.hasScalar = true;
    scene.scalarRange = {0, 4};
    scene.frontFacesOnly = frontOnly;
    Stages stages(backend, std::move(scene));
    const GBuffer& buffer = stages.project(fitCamera(stages.scene, camera, kWidth, kHeight), directLic(4));
    int all = 0, found = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            if (buffer.invDepth.at(x, y) <= 0) continue;
            ++all;
            found += buffer.scalar.at(x, y) == value;
        }
    return all == 0 ? -1 : double(found) / all;
}

std::vector<CameraOptions> viewsAround()
{
    std::vector<CameraOptions> views;
    for (const double azimuth : {20.0, 75.0, 140.0, 200.0, 290.0})
        for (const double elevation : {-50.0, 8.0, 40.0}) {
            CameraOptions view;
            view.azimuth = azimuth;
            view.elevation = elevation;
            views.push_back(view);
        }
    return views;
}

/// From every side exactly one of the two is turned to the viewer, and shows alone.
void expectOneSide(const std::string& backend, const SurfaceMesh& both, const std::string& what)
{
    int sawFront = 0, sawBack = 0;
    for (const CameraOptions& view : viewsAround()) {
        const double front = shareOf(backend, both, view, 1), back = shareOf(backend, both, view, 3);
        EXPECT_GE(std::max(front, back), 0.999) << what << " from " << view.azimuth << ", " << view.elevation;
        sawFront += front > 0.5;
        sawBack += back > 0.5;
    }
    EXPECT_GE(sawFront, 3) << what;
    EXPECT_GE(sawBack, 3) << what;
}

TEST_P(SamePlace, DoubleSidedPlate)
{
    SurfaceMesh plate = side(7, 1), back = side(7, 3);
    turnRound(back);
    shuffle(back, 1);
    shuffle(plate, 2);
    add(plate, back);
    expectOneSide(GetParam(), plate, "back after front");
    SurfaceMesh other = back;
    add(other, side(7, 1));
    expectOneSide(GetParam(), other, "front after back");
}

TEST_P(SamePlace, PlateCutDifferentlyOnEitherSide)
{
    SurfaceMesh plate = side(9, 1), back = side(4, 3);
    turnRound(back);
    add(plate, back);
    expectOneSide(GetParam(), plate, "nine cells against four");
    SurfaceMesh coarse = side(1, 1), fine = side(23, 3);
    turnRound(fine);
    add(coarse, fine);
    expectOneSide(GetParam(), coarse, "one cell against 23");
}

/// The larger plate's points lie on the smaller one's edges, not its corners.
TEST_P(SamePlace, PlateOfOneSizeOnAnother)
{
    SurfaceMesh plate = side(5, 1), back = side(3, 3, {1, 0.15, 0.2}, {-0.1, 0.75, 0.55});
    turnRound(back);
    add(plate, back);
    for (const CameraOptions& view : viewsAround()) {
        const double share = shareOf(GetParam(), plate, view, 3);
        EXPECT_TRUE(share < 0.001 || std::abs(share - 0.25) < 0.03) << share << " from " << view.azimuth;
    }
}

/// The same faces twice, the same way round: the first shows.
TEST_P(SamePlace, TheSameFacesTwice)
{
    SurfaceMesh plate = side(7, 1), again = side(7, 3);
    for (auto& t : again.triangles) std::rotate(t.begin(), t.begin() + 1, t.end());
    add(plate, again);
    for (const CameraOptions& view : viewsAround()) EXPECT_EQ(shareOf(GetParam(), plate, view, 1), 1.0);
}

/// Where surfaces cross, each shows where it is nearer: the line between them stays where it is, within a pixel.
TEST_P(SamePlace, CrossingPlatesStayApart)
{
    SurfaceMesh plates = makeRectangle({0, 0, 0}, {2, 0, 0.5}, {0, 2, 0});
    setPointVectors(plates, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    setScalar(plates, 1);
    SurfaceMesh other = makeRectangle({0, 0, 0}, {2, 0, -0.5}, {0, 2, 0});
    setPointVectors(other, [](const glm::dvec3&) { return glm::vec3(1, 0, 0); });
    setScalar(other, 3);
    turnRound(other);  // One is turned to the viewer, the other away.
    add(plates, other);
    Scene scene = makeScene(std::move(plates));
    scene.hasScalar = true;
    Stages stages(GetParam(), std::move(scene));
    const GBuffer& buffer = stages.project(frontCamera(stages.scene, 8, 160, 120), directLic(4));
    for (int y = 30; y < 90; ++y)
        for (int x = 50; x < 110; ++x) {
            if (std::abs(x - 79.5) < 1.5) continue;
            EXPECT_EQ(buffer.scalar.at(x, y), x > 79 ? 1.0f : 3.0f) << x << ", " << y;
        }
}

TEST_P(SamePlace, FrontFacesAloneAreHalfOfAClosedBody)
{
    SurfaceMesh cube = makeCube({0, 0, 0}, 1);
    setPointVectors(cube, [](const glm::dvec3&) { return glm::vec3(1, 0.2, 0.1); });
    setScalar(cube, 1);
    EXPECT_EQ(shareOf(GetParam(), cube, {}, 1, true), 1.0) << "nothing is missing";
    SurfaceMesh plate = side(5, 1);
    int seen = 0, unseen = 0;
    for (const CameraOptions& view : viewsAround()) {
        const double share = shareOf(GetParam(), plate, view, 1, true);
        (share == 1 ? seen : unseen)++;
        EXPECT_TRUE(share == 1 || share == -1);
    }
    EXPECT_GE(seen, 3);
    EXPECT_GE(unseen, 3);
}

/// Turned inside out, a closed body shows its far side's inside.
TEST_P(SamePlace, AnInsideOutBodyIsWholeWithBothFaces)
{
    SurfaceMesh inside = makeCube({0, 0, 0}, 1);
    setPointVectors(inside, [](const glm::dvec3&) { return glm::vec3(1, 0.2, 0.1); });
    SurfaceMesh outside = inside;
    turnRound(inside);
    const auto depths = [&](const SurfaceMesh& mesh) {
        Stages stages(GetParam(), makeScene(mesh));
        const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, kWidth, kHeight), directLic(4));
        std::vector<float> all;
        for (int y = 0; y < kHeight; ++y)
            all.insert(all.end(), buffer.invDepth.row(y), buffer.invDepth.row(y) + kWidth);
        return all;
    };
    const std::vector<float> a = depths(inside), b = depths(outside);
    int differ = 0;
    for (std::size_t i = 0; i < a.size(); ++i) differ += std::abs(a[i] - b[i]) > 1e-4f * b[i];
    EXPECT_LE(differ, 2);
}

}  // namespace
}  // namespace aeolic
