#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <mutex>

#include "aeolic/error.h"
#include "cluster/comm/together.h"
#include "data/fingerprint.h"
#include "data/load/loaded_scene.h"
#include "data/load/split.h"
#include "data/vtk/testing/sample_files.h"
#include "describe_testing.h"
#include "load_testing.h"
#include "pieces_testing.h"
#include "reader/openfoam/testing/sample_case.h"
#include "slab_pieces_testing.h"

/// Ranks read for each other: files in pieces are dealt to them, and whole files are read once.
namespace aeolic {
namespace {

using namespace test;
using namespace slab_pieces_testing;
using namespace testkit;
namespace fs = std::filesystem;

/// Without its last line, the hash of values.
std::string factsIn(const std::string& fingerprint)
{
    return fingerprint.substr(0, fingerprint.find("values with the hash"));
}

class DealtLoad : public testing::Test {
protected:
    void expectSameOnAnyRanks(const SceneDescription& description) const
    {
        const std::string alone = fingerprint(loadScene(description));
        for (const int ranks : {2, 3, 5, 8})
            for (const Scene& scene : loadParts(description, {}, ranks))
                EXPECT_EQ(fingerprint(scene), alone)
                    << description.surface.spec << " in " << description.field.spec << ", " << ranks << " ranks";
    }

    /// What each rank that fails says. No rank may fail alone.
    static std::vector<std::string> errorsOf(const std::function<void(Agreement&)>& action, int ranks)
    {
        std::mutex mutex;
        std::vector<std::string> errors;
        runRanks(ranks, [&](Communicator& communicator) {
            CommunicatorAgreement agreement(communicator);
            try {
                action(agreement);
            } catch (const InputError& error) {
                const std::lock_guard lock(mutex);
                EXPECT_TRUE(dynamic_cast<const Agreed*>(&error)) << "the job would be ended: " << error.what();
                errors.emplace_back(error.what());
            }
        });
        return errors;
    }
    static std::vector<std::string> errorsOf(const SceneDescription& description, int ranks)
    {
        return errorsOf([&](Agreement& agreement) { const LoadedScene loaded(description, {}, agreement); }, ranks);
    }

    std::string path(const std::string& name) const { return folder_.file(name); }
    std::string folder() const { return folder_.path().string(); }

    TempFolder folder_;
};

TEST_F(DealtLoad, PiecesOfAVolumeGiveWhatAllOfThemGive)
{
    for (const bool onCells : {true, false}) {
        SlabPieces slabs;
        slabs.onCells = onCells;
        const std::string volume = writeSlabs(folder(), onCells ? "cells" : "points", slabs);
        for (const std::string surface :
             {"sphere:20", "slice:0.5,0.5,0.5:1,2,3", "slice:0,0,0:1,0,0", "isosurface:r=0.3"})
            expectSameOnAnyRanks(describe(surface, volume, "U:mag"));
    }
}

/// Values of cells are means of all cells around a point, so nothing shows where pieces meet.
TEST_F(DealtLoad, PiecesMeetWithoutASeam)
{
    SlabPieces whole;
    whole.begins = {0, kSide};
    for (const bool onCells : {true, false}) {
        SlabPieces slabs;
        slabs.onCells = whole.onCells = onCells;
        slabs.originWorld = whole.originWorld = glm::dvec3(-1.2);
        slabs.sizeWorld = whole.sizeWorld = 2.4;
        const std::string pieces = writeSlabs(folder(), "p", slabs), all = writeSlabs(folder(), "w", whole);
        for (const std::string surface : {"slice:-0.31,0,0:1,2,3", "isosurface:r=0.3", "sphere:12"}) {
            const SurfaceMesh a = loadScene(describe(surface, pieces, "r")).surface,
                              b = loadScene(describe(surface, all, "r")).surface;
            ASSERT_EQ(a.triangles.size(), b.triangles.size()) << surface;
            EXPECT_EQ(a.positions.size(), b.positions.size()) << surface << ": points are joined";
            double furthest = 0;  // From the values of the whole at the same place.
            for (std::size_t i = 0; i < a.positions.size(); ++i) {
                double off = 1;  // Where the surface is sharp a place has several points.
                for (std::size_t k = 0; k < b.positions.size(); ++k)
                    off = std::min(off, double(glm::distance(a.positions[i], b.positions[k]) +
                                               glm::distance(a.pointVectors[i], b.pointVectors[k]) +
                                               std::abs(a.pointScalars[i] - b.pointScalars[k]) +
                                               glm::distance(a.normals[i], b.normals[k])));
                furthest = std::max(furthest, off);
            }
            EXPECT_LT(furthest, 2e-5) << surface << (onCells ? ", cells" : ", points");
        }
    }
}

TEST_F(DealtLoad, ProcessorsOfACaseGiveWhatAllOfThemGive)
{
    writeSampleCase(path("case"), {.binary = true, .processors = 4});
    SceneDescription walls = describe(path("case"), "", "p");
    walls.field.vectors = "wallShearStress";
    expectSameOnAnyRanks(walls);
    for (const std::string& addressing :
         {path("case/processor1/constant/polyMesh/faceProcAddressing"), path("case/processor0/nothing")}) {
        fs::remove(addressing);
        SceneDescription cells = describe(path("case"), path("case"), "U:mag");
        cells.field.vectors = "U";
        expectSameOnAnyRanks(cells);
        cells.surface.spec = "slice:2,1,1:0.1,0.2,1";
        expectSameOnAnyRanks(cells);
    }
}

TEST_F(DealtLoad, SurfacesInPiecesGiveWhatAllOfThemGive)
{
    TorusPieces torus;
    torus.pieces = 5;
    torus.empty = {1};
    torus.strips = 2;
    torus.onCells = true;
    torus.normals = true;
    expectSameOnAnyRanks(describe(writeTorusPieces(folder(), "torus", torus), "", "q"));
    torus.brokenNormal = 3;
    torus.noArea = torus.notFinite = 4;
    torus.onCells = false;
    expectSameOnAnyRanks(describe(writeTorusPieces(folder(), "other", torus), "", "q"));
}

/// Each of several surfaces is read in its own way.
TEST_F(DealtLoad, SeveralSurfacesGiveWhatTheyGiveAlone)
{
    const std::string volume = writeSlabs(folder(), "v");
    SceneDescription description = describe("", volume, "");
    SurfaceItem look, slice, context;
    look.spec = "sphere:16";
    look.colorBy = "U:mag";
    slice.spec = "slice:0.5,0.5,0.5:0,0,1";
    slice.colorBy = "U:mag";
    context.spec = writeTorusPieces(folder(), "torus");
    context.streaks = false;
    description.surfaces = {look, slice, context};
    expectSameOnAnyRanks(description);
}

TEST_F(DealtLoad, MomentsOfPiecesAreThoseOfTheWhole)
{
    std::string sets;
    for (int i = 0; i < 3; ++i) {
        SlabPieces slabs;
        slabs.phase = 0.4 * i;
        writeSlabs(folder(), fmt::format("t{}", i), slabs);
        sets += fmt::format("<DataSet timestep=\"{}\" file=\"t{}.pvtu\"/>\n", i, i);
    }
    writeBytes(path("t.pvd"), "<VTKFile type=\"Collection\"><Collection>\n" + sets + "</Collection></VTKFile>\n");
    for (const std::string surface : {"sphere:16", "slice:0.5,0.5,0.5:1,2,3"}) {
        const SceneDescription description = describe(surface, path("t.pvd"), "U:mag");
        OneRank one;
        LoadedScene alone(description, {}, one);
        for (const double moment : {0.5, 2.0, 0.0}) {
            alone.moveTo(moment);
            runRanks(3, [&](Communicator& communicator) {
                CommunicatorAgreement agreement(communicator);
                LoadedScene together(description, {}, agreement);
                together.readAhead(moment);
                together.moveTo(moment);
                EXPECT_EQ(fingerprint(together.scene()), fingerprint(alone.scene())) << surface << " at " << moment;
            });
        }
    }
}

/// A collection whose times have several files each, in any order.
TEST_F(DealtLoad, PartsOfACollectionAreThoseOfOneFile)
{
    for (int i = 0; i < 2; ++i) {
        SlabPieces slabs;
        slabs.phase = 0.4 * i;
        writeSlabs(folder(), fmt::format("v{}", i), slabs);
        TorusPieces torus;
        torus.empty = {1};
        torus.size = 1 + 0.1 * i;
        writeTorusPieces(folder(), fmt::format("s{}", i), torus);
    }
    const auto sets = [](const std::string& name, const char* extension) {
        std::string all;
        for (int part = 3; part >= 0; --part)
            for (int i = 0; i < 2; ++i)
                all += fmt::format("<DataSet timestep=\"{}\" part=\"{}\" file=\"{}{}_{}.{}\"/>\n", i, part, name, i,
                                   part, extension);
        return "<VTKFile type=\"Collection\"><Collection>\n" + all + "</Collection></VTKFile>\n";
    };
    writeBytes(path("v.pvd"), sets("v", "vtu"));
    writeBytes(path("s.pvd"), sets("s", "vtp"));
    for (const std::string surface : {"sphere:16", "slice:0.5,0.5,0.5:1,2,3", "isosurface:r=0.35"}) {
        const SceneDescription parts = describe(surface, path("v.pvd"), "U:mag");
        EXPECT_EQ(factsIn(fingerprint(loadScene(parts))),
                  factsIn(fingerprint(loadScene(describe(surface, path("v0.pvtu"), "U:mag")))));
        expectSameOnAnyRanks(parts);
    }
    const SceneDescription parts = describe(path("s.pvd"), "", "q");
    const SurfaceMesh a = loadScene(parts).surface, b = loadScene(describe(path("s0.pvtp"), "", "q")).surface;
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.pointScalars, b.pointScalars);
    expectSameOnAnyRanks(parts);
    SceneDescription later = parts;
    later.time.moment = 1;
    EXPECT_EQ(loadScene(later).surface.positions, loadScene(describe(path("s1.pvtp"), "", "q")).surface.positions);
    // What no part can tell alone is told by all together.
    SceneDescription outside = describe("boundary", path("v.pvd"), "");
    EXPECT_EQ(loadScene(outside).surface.triangles.size(), std::size_t(2 * 6 * kSide * kSide));
    expectSameOnAnyRanks(outside);
    outside.surface.spec = "sphere:9";
    outside.field.resampleSpacing = 0.1;
    expectSameOnAnyRanks(outside);
}

/// A surface of which each rank has its own pieces, in a volume of which each has others.
TEST_F(DealtLoad, PiecesOfSurfacesFindTheirCellsOnOtherRanks)
{
    SlabPieces slabs;
    slabs.originWorld = {998.05, -22.3, 3.1};  // Around the torus.
    slabs.sizeWorld = 4.5;
    const SceneDescription description =
        describe(writeTorusPieces(folder(), "torus"), writeSlabs(folder(), "v", slabs), "U:mag");
    const Scene alone = loadScene(description);
    ASSERT_FALSE(alone.surface.pointVectors.empty());
    for (const int ranks : {2, 3, 5}) {
        std::size_t points = 0;
        for (const Scene& part : loadParts(description, {false, true}, ranks)) {
            EXPECT_EQ(part.maxVector, alone.maxVector) << ranks;
            EXPECT_EQ(part.scalarRange, alone.scalarRange) << ranks;
            EXPECT_EQ(part.allTriangles, alone.allTriangles) << ranks;
            EXPECT_EQ(part.warnings, alone.warnings) << ranks;
            for (const float value : part.surface.pointScalars) points += std::isfinite(value);
        }
        EXPECT_GE(points, alone.surface.positions.size());
    }
}

TEST_F(DealtLoad, AHostHasAUniformFieldOnce)
{
    writeWindingField(path("f.vti"));
    std::mutex mutex;
    std::vector<const void*> samples;
    runRanks(3, [&](Communicator& communicator) {
        CommunicatorAgreement agreement(communicator);
        const LoadedScene loaded(describe("isosurface:p=0.1", path("f.vti"), "p"), {}, agreement);
        const std::lock_guard lock(mutex);
        samples.push_back(loaded.scene().field->samples.get());
        samples.push_back(loaded.scene().scalarField->samples.get());
    });
    ASSERT_EQ(samples.size(), 6u);
    for (std::size_t i = 2; i < samples.size(); ++i) EXPECT_EQ(samples[i], samples[i % 2]);
}

/// The scene does not depend on which rank has read it.
TEST_F(DealtLoad, ErrorsAreThoseOfOneRank)
{
    const std::string volume = writeSlabs(folder(), "v");
    const auto expectSame = [&](const SceneDescription& description, const std::string& part) {
        std::string alone;
        try {
            loadScene(description);
        } catch (const InputError& error) {
            alone = error.what();
        }
        EXPECT_NE(alone.find(part), std::string::npos) << alone;
        for (const int ranks : {2, 4})
            EXPECT_EQ(errorsOf(description, ranks), std::vector(std::size_t(ranks), alone)) << ranks;
    };
    expectSame(describe("slice:9,9,9:1,0,0", volume, ""), "misses the data");
    expectSame(describe("isosurface:r=7", volume, ""), "not within the array's range");
    expectSame(describe("sphere:9", volume, "nothing"), "no array 'nothing'");
    expectSame(describe(path("missing.vtp"), volume, ""), "no such file");
    SlabPieces nothing;
    nothing.begins = {3, 3, 3};
    expectSame(describe("sphere:9", writeSlabs(folder(), "nothing", nothing), ""), "no cells in any of its pieces");
    const std::string piece = readBytes(path("v_2.vtu"));
    writeBytes(path("v_2.vtu"), piece.substr(0, piece.size() / 2));
    expectSame(describe("sphere:9", volume, ""), "v_2.vtu");
    fs::remove(path("v_2.vtu"));
    expectSame(describe("sphere:9", volume, ""), "v_2.vtu");
}

TEST_F(DealtLoad, ErrorsAboutSeveralSurfacesAreThoseOfAllRanks)
{
    writeWindingField(path("f.vti"));
    SceneDescription bricks = describe("", path("f.vti"), "");
    bricks.run.bricks = BrickChoice::on;
    bricks.surfaces.resize(2);
    bricks.surfaces[0].spec = "sphere:9";
    bricks.surfaces[1].spec = "isosurface:p=0.1";
    const auto said = errorsOf([&](Agreement& agreement) { splitOf(bricks, agreement, 2, {}); }, 2);
    ASSERT_EQ(said.size(), 2u);
    EXPECT_NE(said[0].find("found among several, with the field in bricks"), std::string::npos) << said[0];

    SceneDescription kinds = describe("", path("f.vti"), "p");
    kinds.surfaces.resize(8);
    for (std::size_t i = 0; i < kinds.surfaces.size(); ++i) {
        kinds.surfaces[i].spec = "sphere:9";
        kinds.surfaces[i].colorRange = std::array{0.0, 1.0 + double(i)};
    }
    const auto tooMany = errorsOf(kinds, 2);
    ASSERT_EQ(tooMany.size(), 2u);
    EXPECT_NE(tooMany[0].find("found 8 kinds of colours"), std::string::npos) << tooMany[0];
}

}  // namespace
}  // namespace aeolic
