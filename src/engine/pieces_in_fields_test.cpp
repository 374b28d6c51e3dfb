#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "pieces_scenes_testing.h"

/// Pieces of a surface in a field of their own: every rank samples it on what it holds, and the picture is that of one
/// rank, byte for byte.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

class PiecesInAField : public PiecesTest {};

/// Every rank samples the field on its own piece.
TEST_F(PiecesInAField, ThatEveryRankHolds)
{
    Case c = torus(licOf(LicMethod::hierarchical, 30), {}, "abc:mag");
    c.description.field.spec = "abc:20,20,20";
    c.split = Split{false, true};
    expectSame(c, {2, 3, 7}, {runOptions("pixels", "bound", "auto")});
    writeWindingField(folder_.file("far.vti"));
    c.description.field.spec = folder_.file("far.vti");
    c.description.shading.colorBy = "";
    const auto complaint = [&](int ranks) {
        std::string found;
        try {
            draw("cpu", c, runOptions("pixels", "bound", "auto"), ranks, 1);
        } catch (const std::exception& error) {
            found = error.what();
        }
        return found.substr(found.find("the field"));
    };
    EXPECT_EQ(complaint(3), complaint(1)) << "with the bounds of all pieces";
}

/// Whoever reads a triangle, it is drawn by those into whose bricks it reaches.
TEST_F(PiecesInAField, InBricks)
{
    const std::vector<RunOptions> options{kHybrid, runOptions("static", "estimate", "receive", "on"),
                                          runOptions("pixels", "bound", "project", "on")};
    Case c = torus(licOf(LicMethod::hierarchical, 40), {}, "abc:mag");
    c.description.field.spec = "abc:20,20,20";
    expectSame(c, {2, 3, 5, 8}, options);
    c.description.shading.colorBy = "q";
    expectSame(c, {3, 13}, {kHybrid});
    c = torus(licOf(LicMethod::direct, 30, Kernel::hann, false), {}, "");
    c.description.field.spec = "tornado:9,10,11";
    c.description.field.precision = FieldPrecision::float16;
    expectSame(c, {5}, {kHybrid});
}

/// Large triangles reach across several bricks, and some are beyond the field, where nothing flows.
TEST_F(PiecesInAField, ThatTheyReachOutOf)
{
    TorusPieces coarse;
    coarse.pieces = 5;
    coarse.aroundWedge = 1;
    coarse.aroundTube = 3;
    coarse.strips = 1;
    coarse.onCells = true;
    coarse.noArea = 3;
    GridSample small;
    small.dims = {13, 12, 9};
    small.origin = {1000.1, -20.9, 4.3};
    small.spacing = {0.11, 0.12, 0.1};
    small.nanPoints = {600, 601, 602, 620, 700};
    writeGridFile(folder_.file("small.vti"), small);
    for (const char* colorBy : {"q", "p", "U:mag"}) {
        Case c = torus(licOf(LicMethod::hierarchical, 30), coarse, colorBy);
        c.description.field.spec = folder_.file("small.vti");
        c.description.shading.background = "ff00ff";
        expectSame(c, {2, 5, 13}, {kHybrid});
    }
    Case c = torus(licOf(LicMethod::hierarchical, 30));
    c.description.field.spec = folder_.file("small.vti");
    c.camera.position = Vec3{1001.3, -20, 5.02};  // Inside the tube.
    c.camera.focal = Vec3{1001.3, -19, 5};
    expectSame(c, {3, 8}, {kHybrid}, 1);
}

/// Ranks say what a rank alone says: a field far away, and a moving one.
TEST_F(PiecesInAField, InBricksThatMoveOrAreElsewhere)
{
    Case c = torus(licOf(LicMethod::hierarchical, 20), {}, "U:mag");
    for (int i = 0; i < 3; ++i) {
        GridSample sample;
        sample.dims = {11, 12, 9};
        sample.origin = {998.8, -21.5, 4.5};
        sample.spacing = {0.3, 0.3, 0.2};
        sample.scale = 1 + i;
        writeGridFile(folder_.file("g_" + std::to_string(i) + ".vti"), sample);
    }
    c.description.field.spec = folder_.file("g_*.vti");
    for (const double moment : {0.0, 1.5}) {
        c.description.time.moment = moment;
        expectSame(c, {3, 5}, {kHybrid}, 1);
    }
    SceneDescription description = c.description;
    description.time = {};
    writeWindingField(folder_.file("far.vti"));
    description.field.spec = folder_.file("far.vti");
    description.run.bricks = BrickChoice::on;
    description.run.threads = 1;
    EXPECT_EQ(complaintOf(description, 3), complaintOf(description, 1));
    EXPECT_NE(complaintOf(description, 3).find("does not meet the surface"), std::string::npos);
}

}  // namespace
}  // namespace aeolic
