#include <gtest/gtest.h>

#include "pieces_scenes_testing.h"

/// Ranks that hold different pieces of the surface draw the picture of one that holds all, byte for byte.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

class Pieces : public PiecesTest {};

TEST_F(Pieces, OfATorusThatCarriesItsVectors)
{
    expectSame(torus(licOf(LicMethod::hierarchical, 40)), {2, 3, 5},
               {kHybrid, runOptions("static", "estimate", "receive", "on"),
                runOptions("pixels", "bound", "project", "on"), runOptions("timing", "bound", "auto", "on")});
}

TEST_F(Pieces, OfAnIsosurfaceInBricks)
{
    expectSame(
        winding(licOf(LicMethod::hierarchical, 40)), {2, 3, 5, 8},
        {kHybrid, runOptions("pixels", "estimate", "receive", "on"), runOptions("static", "bound", "project", "on")});
}

TEST_F(Pieces, DirectlyAndWithVectorsOfAnyLength)
{
    const LicOptions lic = licOf(LicMethod::direct, 30, Kernel::hann, false);
    expectSame(torus(lic), {3}, {kHybrid});
    Case occluded = winding(lic, true, "p");
    occluded.description.shading.occlusion = true;
    expectSame(occluded, {3}, {kHybrid});
    Case half = winding(lic);
    half.description.field.precision = FieldPrecision::float16;
    expectSame(half, {3, 8}, {kHybrid});
}

TEST_F(Pieces, OfPiecesThatAreEmptyOrComeAsStrips)
{
    TorusPieces odd;
    odd.empty = {2};
    odd.strips = 1;
    odd.onCells = true;
    odd.noArea = 0;
    expectSame(torus(licOf(LicMethod::hierarchical, 20), odd), {2, 4}, {kHybrid});
}

TEST_F(Pieces, MoreRanksThanPiecesOrRows)
{
    Case c = torus(licOf(LicMethod::hierarchical, 20));
    c.description.shading.occlusion = true;
    c.description.output.height = 9;
    expectSame(c, {13}, {kHybrid, runOptions("pixels", "bound", "receive", "on")});
    c = winding(licOf(LicMethod::direct, 20));
    c.description.output.height = 7;
    expectSame(c, {13}, {kHybrid});
}

/// Pieces reach behind the eye, and some are nowhere in the picture.
TEST_F(Pieces, FromInsideTheSurface)
{
    Case c = torus(licOf(LicMethod::hierarchical, 30));
    c.camera.position = Vec3{1001.3, -20, 5.02};
    c.camera.focal = Vec3{1001.3, -19, 5};
    expectSame(c, {3, 5}, {kHybrid}, 1);
    c = winding(licOf(LicMethod::hierarchical, 30));
    c.camera.position = Vec3{9.9, -6.2, 3.6};
    c.camera.focal = Vec3{10.5, -5.5, 3.9};
    expectSame(c, {5}, {kHybrid}, 1);
}

/// Just as many pixels are covered as by one rank, lit and unlit: no crack at any brick's face, nothing drawn twice.
TEST_F(Pieces, LeaveNoCracks)
{
    Case c = winding(licOf(LicMethod::none, 8), false, "");
    c.description.output.width = 400, c.description.output.height = 300;
    c.description.shading.background = "ff00ff";
    expectSame(c, {8, 13}, {kHybrid}, 3);
}

TEST_F(Pieces, AMovingIsosurfaceAtAnyMoment)
{
    for (int i = 0; i < 3; ++i) writeWindingField(folder_.file("f_" + std::to_string(i) + ".vti"), false, 0.3 * i);
    Case c = make("moving", "isosurface:p=0.1", folder_.file("f_*.vti"), licOf(LicMethod::hierarchical, 20), "p");
    for (const double moment : {0.0, 1.5, 2.0}) {
        c.description.time.moment = moment;
        expectSame(c, {3, 5}, {kHybrid}, 1);
    }
}

class PiecesLong : public Pieces {};

TEST_F(PiecesLong, AnyRanksBalancersGuardsAndMethods)
{
    std::vector<RunOptions> options;
    for (const char* balance : {"static", "timing", "pixels", "hybrid"})
        for (const char* guard : {"bound", "estimate"})
            for (const char* rows : {"project", "receive"})
                for (const char* bricks : {"on", "off"}) options.push_back(runOptions(balance, guard, rows, bricks));
    TorusPieces odd;
    odd.pieces = 9;
    odd.empty = {4};
    odd.strips = 6;
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        const LicOptions lic = licOf(method, 45);
        const std::vector<int> ranks{2, 3, 5, 8, 13};  // One after the other: files of the same name.
        expectSame(torus(lic), ranks, options);
        expectSame(torus(lic, odd), ranks, options);
        expectSame(winding(lic), ranks, options);
        expectSame(winding(lic, true, "p"), ranks, options);
        for (const char* colorBy : {"q", "abc:mag"}) {
            Case both = torus(lic, odd, colorBy);
            both.description.field.spec = "abc:24,20,22";
            expectSame(both, ranks, options);
        }
    }
}

}  // namespace
}  // namespace aeolic
