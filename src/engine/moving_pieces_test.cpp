#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "data/scene.h"
#include "data/vtk/testing/sample_files.h"
#include "engine/renderer_internals.h"
#include "pieces_testing.h"
#include "ranks/thread_communicator.h"
#include "same_bytes_testing.h"

/// Surfaces in pieces, alone and in fields in bricks, of which either or both change in time.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

/// Pictures of moments, one after the other.
std::vector<Picture> picturesOf(SceneDescription description, const std::vector<double>& moments, int ranks)
{
    description.run.threads = 1;
    std::vector<Picture> pictures;
    runRanks(ranks, [&](Communicator& communicator) {
        Renderer renderer(description, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        for (const double moment : moments) {
            renderer.setTime(moment);
            Picture picture = renderer.render({description.camera});
            if (communicator.isRoot()) pictures.push_back(std::move(picture));
        }
    });
    return pictures;
}

/// The moments of one rank that holds everything, from ranks that hold pieces.
void expectSameMoments(SceneDescription description, const std::vector<int>& ranks)
{
    const std::vector<double> moments{0.5, 2, 1.75, 0, 1, 0.25};
    const std::vector<Picture> alone = picturesOf(description, moments, 1);
    description.run.bricks = BrickChoice::on;
    for (const int n : ranks) {
        const std::vector<Picture> together = picturesOf(description, moments, n);
        ASSERT_EQ(together.size(), alone.size());
        for (std::size_t i = 0; i < moments.size(); ++i)
            EXPECT_TRUE(together[i].pixels == alone[i].pixels) << n << " ranks at " << moments[i];
    }
    EXPECT_FALSE(alone[0].pixels == alone[1].pixels);
}

class MovingPieces : public testing::Test {
protected:
    static SceneDescription describe(const std::string& surface, const std::string& colorBy)
    {
        SceneDescription description = makeCase("torus", 130, 101, licOf(LicMethod::hierarchical, 20)).description;
        description.surface.spec = surface;
        description.field.spec = "";
        description.shading.colorBy = colorBy;
        description.camera.elevation = 35;
        return description;
    }
    /// A torus that grows, in three steps.
    SceneDescription growing(const TorusPieces& torus, const std::string& colorBy = "q") const
    {
        TorusPieces step = torus;
        for (int i = 0; i < 3; ++i) {
            step.size = 1 + 0.2 * i;
            writeTorusPieces(folder_.path().string(), "t_" + std::to_string(i), step);
        }
        SceneDescription description = describe(folder_.file("t_*.pvtp"), colorBy);
        return description;
    }
    /// Fields around it, on another grid at every step if `other`.
    std::string fields(bool other) const
    {
        for (int i = 0; i < 3; ++i) {
            GridSample sample;
            sample.dims = {14 + (other ? 3 * i : 0), 15, 9};
            sample.origin = {998.3 + (other ? 0.1 * i : 0), -22, 4.2};
            sample.spacing = {0.3, 0.3, 0.2};
            sample.scale = 1 + i;
            sample.nanPoints = {700, 701, 714};
            writeGridFile(folder_.file("g_" + std::to_string(i) + ".vti"), sample);
        }
        return folder_.file("g_*.vti");
    }
    /// Some of a fan of triangles that share no points, as a .vtp file.
    static std::string triangles(int first, int count, double size)
    {
        std::string points, vectors, corners, ends;
        for (int i = 0; i < count; ++i) {
            const double angle = 1.5 * (first + i);
            for (int k = 0; k < 3; ++k) {
                const double a = angle + 0.6 * k, r = k == 1 ? 0.2 * size : size;
                points += fmt::format("{} {} {} ", r * std::cos(a), r * std::sin(a), 0.1 * k * size);
                vectors += "1 0.5 0 ";
                corners += std::to_string(3 * i + k) + " ";
            }
            ends += std::to_string(3 * i + 3) + " ";
        }
        const auto array = [](const char* attributes, const std::string& values) {
            return fmt::format("<DataArray {} format=\"ascii\">{}</DataArray>", attributes, values);
        };
        return fmt::format(
            "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\"><PointData "
            "Vectors=\"U\">{}</PointData><Points>{}</Points><Polys>{}{}</Polys></Piece></PolyData></VTKFile>",
            3 * count, count, array("type=\"Float32\" Name=\"U\" NumberOfComponents=\"3\"", vectors),
            array("type=\"Float32\" NumberOfComponents=\"3\"", points),
            array("type=\"Int64\" Name=\"connectivity\"", corners), array("type=\"Int64\" Name=\"offsets\"", ends));
    }
    TempFolder folder_;
};

TEST_F(MovingPieces, AtAnyMoment)
{
    TorusPieces odd;
    odd.strips = 1;
    odd.noArea = 3;
    odd.empty = {2};
    expectSameMoments(growing({}), {2, 3, 5});
    expectSameMoments(growing(odd), {3, 7});
    odd.normals = true;
    expectSameMoments(growing(odd), {3});
}

TEST_F(MovingPieces, InAFieldInBricksThatMovesToo)
{
    SceneDescription description = growing({}, "U:mag");
    for (const bool other : {false, true}) {
        description.field.spec = fields(other);
        expectSameMoments(description, {2, 5});
    }
    description.shading.colorBy = "q";
    description.field.spec = "abc:15,16,17";
    expectSameMoments(description, {3});
}

/// Then its triangles are dealt again, by other bricks.
TEST_F(MovingPieces, AStillSurfaceInAFieldOnAnotherGridAtEveryStep)
{
    TorusPieces coarse;
    coarse.aroundWedge = 2;
    coarse.aroundTube = 4;
    SceneDescription description = describe(writeTorusPieces(folder_.path().string(), "torus", coarse), "U:mag");
    description.field.spec = fields(true);
    expectSameMoments(description, {2, 3, 8});
}

/// One piece of a step is another mesh: then none is interpolated, on no rank.
TEST_F(MovingPieces, AnotherMeshInOnePieceIsAnotherMesh)
{
    const SceneDescription description = growing({});
    TorusPieces other;
    other.size = 1.2;
    other.strips = 1;
    writeTorusPieces(folder_.path().string(), "t_1", other);
    expectSameMoments(description, {2, 4});
    SceneDescription split = description;
    split.run.bricks = BrickChoice::on;
    split.run.threads = 1;
    runRanks(4, [&](Communicator& communicator) {
        Renderer renderer(split, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        renderer.setTime(0.5);
        ASSERT_EQ(RendererInternals::scene(renderer).warnings.size(), 1u) << "every rank says so, once";
        EXPECT_NE(RendererInternals::scene(renderer).warnings[0].find("different meshes"), std::string::npos);
    });
}

/// A step that one rank alone cannot read is everybody's error, and they can go on with other moments.
TEST_F(MovingPieces, AStepThatOneRankCannotReadIsOneLineAndTheOthersStay)
{
    SceneDescription description = growing({});
    const std::vector<Picture> alone = picturesOf(description, {0.5, 1.0}, 1);
    description.run.bricks = BrickChoice::on;
    description.run.threads = 1;
    const std::string damaged = folder_.file("t_2_3.vtp"), whole = readBytes(damaged);
    writeBytes(damaged, whole.substr(0, whole.size() / 2));
    runRanks(4, [&](Communicator& communicator) {
        Renderer renderer(description, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
        const auto expectPicture = [&](double moment, const Picture& expected) {
            renderer.setTime(moment);
            const Picture picture = renderer.render({description.camera});
            if (communicator.isRoot()) {
                EXPECT_TRUE(picture.pixels == expected.pixels) << moment;
            }
        };
        expectPicture(0.5, alone[0]);
        for (int i = 0; i < 2; ++i) {
            EXPECT_THROW(renderer.setTime(2.0), InputError);
            expectPicture(1.0, alone[1]);
            EXPECT_THROW(renderer.setTime(1.5), InputError);
            expectPicture(0.5, alone[0]);
        }
    });
}

/// After a restart on other ranks, say.
TEST_F(MovingPieces, AnotherNumberOfPiecesIsAnotherMesh)
{
    const SceneDescription description = growing({});
    TorusPieces five;
    five.pieces = 5;
    five.size = 1.2;
    writeTorusPieces(folder_.path().string(), "t_1", five);
    expectSameMoments(description, {2, 3, 5, 7});
    SceneDescription inField = description;
    inField.field.spec = fields(false);
    inField.shading.colorBy = "U:mag";
    expectSameMoments(inField, {3});
}

/// Triangles that share no points are the same ones however they are cut into pieces. But a rank that holds some of
/// them would find others in the next step.
TEST_F(MovingPieces, TheSameTrianglesInOtherPiecesAreAnotherMesh)
{
    const auto write = [&](int step, const std::vector<int>& pieces) {
        const std::string name = "s_" + std::to_string(step);
        std::string names;
        int first = 0;
        for (std::size_t i = 0; i < pieces.size(); first += pieces[i++]) {
            const std::string piece = name + "_" + std::to_string(i) + ".vtp";
            writeBytes(folder_.file(piece), triangles(first, pieces[i], 1 + 0.3 * step));
            names += "<Piece Source=\"" + piece + "\"/>";
        }
        writeBytes(folder_.file(name + ".pvtp"),
                   "<VTKFile type=\"PPolyData\"><PPolyData GhostLevel=\"0\"><PPointData Vectors=\"U\"><PDataArray "
                   "type=\"Float32\" Name=\"U\" NumberOfComponents=\"3\"/></PPointData><PPoints><PDataArray "
                   "type=\"Float32\" NumberOfComponents=\"3\"/></PPoints>" +
                       names + "</PPolyData></VTKFile>");
    };
    for (const std::vector<int>& others : {std::vector{1, 3}, {3, 1}, {1, 2, 1}}) {
        write(0, {2, 2});
        write(1, others);
        write(2, {2, 2});
        expectSameMoments(describe(folder_.file("s_*.pvtp"), ""), {2, 3});
    }
}

TEST_F(MovingPieces, AStepWithoutPolygonsIsOneLineOnAllRanks)
{
    SceneDescription description = growing({});
    TorusPieces nothing;
    nothing.empty = {0, 1, 2, 3};
    writeTorusPieces(folder_.path().string(), "t_1", nothing);
    description.run.bricks = BrickChoice::on;
    description.run.threads = 1;
    description.time.moment = 1;
    EXPECT_NE(complaintOf(description, 3).find("no polygons in any of its pieces"), std::string::npos);
}

}  // namespace
}  // namespace aeolic
