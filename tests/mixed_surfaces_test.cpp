#include "several_surfaces_testing.h"

#include "same_bytes_testing.h"

/// Surfaces in one picture whose values come from different places: their own, and a field's.
namespace aeolic {
namespace {

using namespace testkit;
using namespace test;

class MixedSurfaces : public SeveralSurfaces {};
INSTANTIATE_TEST_SUITE_P(Backends, MixedSurfaces, allBackends, backendName);

/// Its streaks are not those of the field that colours it.
TEST_P(MixedSurfaces, OneInAListHasItsOwnVectorsWhateverColoursIt)
{
    scene.field.spec = folder.file("grid.vti");
    scene.field.vectors = "U";
    scene.shading.colorBy = "field:p";
    scene.surfaces = {left()};
    const Picture ofField = draw();
    scene.surfaces[0].vectors = "tau";
    EXPECT_GT(differing(ofField, draw(), 0, 200), 1000);
}

/// The same vectors of a uniform field on both, sampled at every pixel; and beside one that has its own.
TEST_P(MixedSurfaces, OwnVectorsBesideThoseOfAField)
{
    scene.field.spec = folder.file("grid.vti");
    scene.field.vectors = "U";
    scene.surfaces = {left(), right()};
    const Picture sampled = draw();
    scene.surfaces[0].vectors = "tau";
    const Picture mixed = draw();
    EXPECT_GT(differing(sampled, mixed, 0, 200), 1000) << "tau is not U";
    // U is linear, so that what the points carry is what pixels sample, but for rounding.
    int far = 0;
    for (int y = 60; y < 140; ++y)
        for (int x = 260; x < 340; ++x) far += std::abs(colorAt(sampled, x, y)[0] - colorAt(mixed, x, y)[0]) > 24;
    EXPECT_LT(far, 300);
}

/// Where the field is masked a pixel is blank or not, as it is without the other surface: no triangle is blank as a
/// whole.
TEST_P(MixedSurfaces, AMaskedSliceIsTheSameBesideOwnVectors)
{
    GridSample grid;
    grid.dims = {17, 9, 9};
    grid.origin = {-0.5, -0.5, -1};
    for (int z = 0; z < 9; ++z)
        for (const int at : {3 * 17 + 11, 4 * 17 + 11, 4 * 17 + 12, 5 * 17 + 13})
            grid.nanPoints.push_back(at + 153 * z);
    writeGridFile(folder.file("masked.vti"), grid);
    scene.field.spec = folder.file("masked.vti");
    scene.field.vectors = "U";
    scene.shading.colorBy = "field:p";
    scene.shading.colorRange = std::array{0.0, 40.0};
    scene.surfaces = {left(), item("slice:2.5,0,-0.5:0,0,1")};
    const Picture sampled = draw();
    EXPECT_EQ(coloursIn(sampled, 267, 96, 8), 1u) << "it is masked there";
    EXPECT_GT(coloursIn(sampled, 320, 96, 8), 10u);
    scene.surfaces[0].vectors = "tau";
    EXPECT_EQ(differing(sampled, draw(), 200, 400), 0);
    scene.surfaces[0].colorBy = "surface:q";
    scene.surfaces[1].legend = "p";  // Colours of its own.
    EXPECT_EQ(differing(sampled, draw(), 200, 400), 0);
}

/// A slice and a wall out of the same cells: the slice carries its values, the wall looks them up.
TEST_P(MixedSurfaces, CutsBesideSurfacesFromFiles)
{
    for (const char* grid : {"grid.vti", "cells.vtu"}) {
        scene.field.spec = folder.file(grid);
        scene.field.vectors = "U";
        scene.shading.colorBy = "p";
        scene.surfaces = {left(), item("slice:2.5,0,-0.5:0,0,1")};
        const Picture both = draw();
        EXPECT_GT(coloursIn(both, 70, 70, 60), 200u) << grid;
        EXPECT_GT(coloursIn(both, 270, 70, 60), 200u) << grid;
        scene.surfaces[0].shown = false;
        EXPECT_GT(differing(both, draw(), 0, 200), 5000) << grid;
    }
}

TEST_P(MixedSurfaces, ValuesOnTrianglesBesideValuesOnPoints)
{
    scene.surface.cells = CellValues::steps;
    scene.lic.method = LicMethod::none;
    scene.shading.blend = 0;
    scene.surfaces = {left(), right()};
    scene.surfaces[0].vectors = "cellTau";
    scene.surfaces[0].colorBy = "cellQ";
    const Picture picture = draw();
    EXPECT_EQ(coloursIn(picture, 52, 78, 20), 1u) << "within a cell";
    EXPECT_GT(coloursIn(picture, 52, 60, 90), 8u);
}

/// Vectors and colours are the surfaces' own or the field's, in any combination, also beyond the field's box and where
/// short vectors are masked.
TEST_P(MixedSurfaces, AnyRanksGiveTheSameBytesWhereSomeCarryTheirOwn)
{
    SheetSample outside;
    outside.shift = {3.2, 0, 0};
    writeSheetFile(folder.file("outside.vtp"), outside);
    scene.field.spec = folder.file("grid.vti");
    scene.field.vectors = "U";
    scene.shading.lighting = scene.shading.antialias = true;
    scene.lic.maskBelow = 1.2;
    scene.surfaces = {left(), item("slice:2.5,0,-0.5:0,0,1"), item(folder.file("outside.vtp")), right()};
    scene.surfaces[0].vectors = scene.surfaces[2].vectors = "tau";
    scene.surfaces[0].colorBy = "field:p";
    scene.surfaces[1].colorBy = "field:p";
    scene.surfaces[2].colorBy = scene.surfaces[3].colorBy = "surface:q";
    CameraOptions camera;
    const Case c{"mixed", scene, camera};
    const auto one = testkit::draw(GetParam(), c, runOptions("static", "estimate", "auto"), 1, 2);
    for (const char* bricks : {"off", "on"})
        expectSameBytes(GetParam(), c, one, runOptions("hybrid", "bound", "project", bricks), 3);
}

}  // namespace
}  // namespace aeolic
