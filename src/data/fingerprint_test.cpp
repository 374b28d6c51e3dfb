#include "data/fingerprint.h"

#include <gtest/gtest.h>

#include <functional>

#include "data/builtin/flows.h"
#include "data/builtin/surfaces.h"

namespace aeolic {
namespace {

Scene someScene()
{
    Scene scene;
    scene.surface = makeBuiltinSurface("sphere:80");
    scene.surface.pointVectors.assign(scene.surface.positions.size(), {1, 2, 3});
    scene.surface.pointScalars.assign(scene.surface.positions.size(), 0.5f);
    scene.boundsWorld = scene.surface.bounds();
    scene.field = makeBuiltinFlow("abc:6,7,8", scene.boundsWorld);
    scene.maxVector = scene.field->maxMagnitude;
    scene.hasScalar = true;
    return scene;
}

/// A copy of the field with other facts.
void changeField(Scene& scene, const std::function<void(GridField&)>& change)
{
    GridField field = *scene.field;
    change(field);
    scene.field = std::make_shared<const GridField>(field);
}

TEST(Fingerprint, EqualScenesHaveEqualOnes)
{
    EXPECT_EQ(fingerprint(someScene()), fingerprint(someScene()));
}

TEST(Fingerprint, ChangesWithEverythingThatReachesThePicture)
{
    const std::function<void(Scene&)> changes[] = {
        [](Scene& s) { s.surface.positions[7].z += 1e-6f; },
        [](Scene& s) { s.surface.normals[7] = -s.surface.normals[7]; },
        [](Scene& s) { std::swap(s.surface.triangles[3][0], s.surface.triangles[3][1]); },
        [](Scene& s) { s.surface.triangles.pop_back(); },
        [](Scene& s) { s.surface.originWorld.x += 1000; },
        [](Scene& s) { s.surface.pointVectors[0].x = -1; },
        [](Scene& s) { s.surface.cellVectors.swap(s.surface.pointVectors); },
        [](Scene& s) { s.surface.pointScalars[0] = 0.25f; },
        [](Scene& s) { s.maxVector *= 2; },
        [](Scene& s) { s.scalarRange[1] = 9; },
        [](Scene& s) { s.hasScalar = false; },
        [](Scene& s) { s.field = nullptr; },
        [](Scene& s) { changeField(s, [](GridField& f) { f.originWorld.y += 1; }); },
        [](Scene& s) { changeField(s, [](GridField& f) { f.spacingWorld.z *= 2; }); },
        [](Scene& s) { changeField(s, [](GridField& f) { std::swap(f.dims[0], f.dims[1]); }); },
    };
    const std::string before = fingerprint(someScene());
    for (std::size_t i = 0; i < std::size(changes); ++i) {
        Scene scene = someScene();
        changes[i](scene);
        EXPECT_NE(fingerprint(scene), before) << "change " << i;
    }
}

/// Two time steps of one simulation: the same grid, the same largest vector, other vectors.
TEST(Fingerprint, TellsFieldsApartThatDifferOnlyInTheirSamples)
{
    Scene one = someScene(), other = someScene();
    const auto samples = std::make_shared<std::vector<float>>(3 * other.field->sampleCount(), 1.0f);
    changeField(other, [&](GridField& f) { f.samples = std::shared_ptr<const void>(samples, samples->data()); });
    EXPECT_NE(fingerprint(one), fingerprint(other));
}

/// Each rank holds another part, and all are right.
TEST(Fingerprint, OfBricksLooksAtNoSamples)
{
    std::string first;
    for (const int rank : {0, 1, 2}) {
        Scene scene = someScene();
        const double maxVector = scene.maxVector;  // The whole scene's, as ranks agree on it.
        scene.field = makeBuiltinFlow("abc:6,7,8", scene.boundsWorld, {rank, 3});
        scene.maxVector = maxVector;
        if (first.empty()) first = fingerprint(scene);
        EXPECT_EQ(fingerprint(scene), first) << rank;
    }
}

}  // namespace
}  // namespace aeolic
