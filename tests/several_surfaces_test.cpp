#include "engine/renderer_internals.h"
#include "several_surfaces_testing.h"

#include "data/load/loaded_scene.h"
#include "data/scene.h"
#include "same_bytes_testing.h"

/// Several surfaces in one picture.
namespace aeolic {
namespace {

using namespace testkit;
using namespace test;

INSTANTIATE_TEST_SUITE_P(Backends, SeveralSurfaces, allBackends, backendName);

TEST_P(SeveralSurfaces, OneInAListIsThatOneAlone)
{
    scene.shading.colorBy = "q";
    scene.surface.spec = folder.file("left.vtp");
    const Picture alone = draw();
    scene.surfaces = {left()};
    EXPECT_EQ(draw().pixels, alone.pixels);
}

TEST_P(SeveralSurfaces, EachIsDrawnAsItIsAlone)
{
    scene.surfaces = {left(), right()};
    const Picture both = draw();
    scene.surfaces = {left(), right()};
    scene.surfaces[1].shown = false;
    const Picture first = draw();
    scene.surfaces[0].shown = false;
    scene.surfaces[1].shown = true;
    const Picture second = draw();
    EXPECT_EQ(differing(both, first, 0, 200), 0);
    EXPECT_EQ(differing(both, second, 200, 400), 0);
    EXPECT_GT(differing(both, first, 200, 400), 5000) << "the other is not there";
    EXPECT_GT(coloursIn(both, 70, 70, 60), 20u) << "streaks";
    EXPECT_GT(coloursIn(both, 270, 70, 60), 20u);
}

TEST_P(SeveralSurfaces, WhichAreShownChangesWithoutLoading)
{
    scene.surfaces = {left(), right()};
    scene.surfaces[1].shown = false;
    const Picture first = draw();
    scene.surfaces[1].shown = true;
    Renderer renderer(scene);
    const Picture both = renderer.render({scene.camera});
    const std::uint64_t all = renderer.info().triangles;
    renderer.setShown({true, false});
    EXPECT_EQ(renderer.render({scene.camera}).pixels, first.pixels);
    EXPECT_EQ(renderer.info().triangles, all / 2);
    renderer.setShown({false, false});
    EXPECT_EQ(coloursIn(renderer.render({scene.camera}), 0, 0, 200), 1u) << "nothing is left but the background";
    renderer.setShown({true, true});
    EXPECT_EQ(renderer.render({scene.camera}).pixels, both.pixels);
    EXPECT_THROW(renderer.setShown({true}), InputError);
}

/// What is hidden has no say in where the camera is and in what the colours mean.
TEST_P(SeveralSurfaces, CameraAndColoursGoByThoseThatAreShown)
{
    scene.camera = {};
    scene.shading.colorBy = "tau:mag";  // Ten times as long on the right one.
    scene.shading.scalarBar = true;
    scene.lic.normalize = false;
    scene.surfaces = {left(), right()};
    Renderer renderer(scene);
    const Picture both = renderer.render({scene.camera});
    const std::array<double, 2> all = RendererInternals::scene(renderer).scalarRange;
    renderer.setShown({true, false});
    EXPECT_NEAR(RendererInternals::scene(renderer).scalarRange[1], all[1] / 10, 1e-4 * all[1]);
    EXPECT_EQ(RendererInternals::scene(renderer).fit().boundsWorld.hi.x, 1);
    const Picture first = renderer.render({scene.camera});
    scene.surfaces[1].shown = false;
    EXPECT_EQ(draw().pixels, first.pixels) << "whatever was shown before";
    renderer.setShown({false, false});
    EXPECT_EQ(RendererInternals::scene(renderer).scalarRange, all) << "nothing is shown";
    renderer.setShown({true, true});
    EXPECT_EQ(renderer.render({scene.camera}).pixels, both.pixels);
}

/// Without streaks a pixel has the colour map's own colour: each surface by its own array, map and range.
TEST_P(SeveralSurfaces, EachHasItsOwnColours)
{
    scene.lic.method = LicMethod::none;
    scene.shading.blend = 0;
    scene.surfaces = {left(), right(), context(folder.file("right.vtp"))};
    scene.surfaces[0].colorBy = "q";  // x + y, from 0 to 2.
    scene.surfaces[1].colorBy = "tau:mag";
    scene.surfaces[1].colormap = "gray";
    scene.surfaces[1].colorRange = std::array{0.0, 100.0};
    scene.surfaces[2].shown = false;
    const Picture picture = draw();
    const auto near = [](const Color& a, const Color& b) {
        return std::abs(a[0] - b[0]) <= 2 && std::abs(a[1] - b[1]) <= 2 && std::abs(a[2] - b[2]) <= 2;
    };
    for (int x = 60; x < 150; x += 7) {
        // A sheet rises by 0.1 x, so that its pixels are a little larger to the right.
        const double u = (x + 0.5 - 50) / 100 - 0.005 * (x - 200) / 200, v = 0.5;
        const Color expected = colorMap("viridis")[std::size_t(std::clamp(256 * (u + v) / 2, 0.0, 255.0))];
        const Color seen = colorAt(picture, x, 100);
        EXPECT_TRUE(near(seen, expected) || near(seen, colorMap("viridis")[std::size_t(256 * (u + v) / 2) + 2])) << x;
    }
    // 10 sqrt(1 + x^2 + 0.01) of 100.
    const Color gray = colorAt(picture, 300, 100);
    EXPECT_NEAR(gray[0], 255 * 0.1 * std::sqrt(1 + 0.25 + 0.01), 3);
    EXPECT_EQ(gray[0], gray[1]);
}

TEST_P(SeveralSurfaces, ContextIsPlainAndWithoutStreaks)
{
    scene.shading.colorBy = "q";
    scene.surfaces = {left(), context(folder.file("right.vtp"))};
    const Picture picture = draw();
    EXPECT_EQ(coloursIn(picture, 270, 70, 60), 1u);
    const Color gray = colorAt(picture, 300, 100);
    EXPECT_TRUE(gray[0] == gray[1] && gray[1] == gray[2] && gray[0] > 200);
    EXPECT_GT(coloursIn(picture, 70, 70, 60), 20u);
    scene.shading.colorBy = "";
    EXPECT_EQ(colorAt(draw(), 300, 100), gray) << "whatever the others are coloured by";
}

/// No trace enters a surface without streaks, although it lies on the same sheet.
TEST_P(SeveralSurfaces, TracesEndWhereContextBegins)
{
    SheetSample beside;
    beside.shift = {1, 0, 0.1};
    writeSheetFile(folder.file("beside.vtp"), beside);
    scene.surfaces = {left(), context(folder.file("beside.vtp")), right()};
    const Picture joined = draw();
    scene.surfaces[1].shown = false;
    const Picture alone = draw();
    EXPECT_EQ(differing(joined, alone, 0, 149), 0);
}

TEST_P(SeveralSurfaces, OneMovesAndTheOtherStays)
{
    for (int step = 0; step < 3; ++step) {
        SheetSample sheet;
        sheet.scale = 1 + step;
        sheet.shift = {0, 0.1 * step, 0};
        writeSheetFile(folder.file("moving_" + std::to_string(step) + ".vtp"), sheet);
    }
    scene.shading.colorBy = "q";
    scene.surfaces = {item(folder.file("moving_%d.vtp")), right()};
    Renderer renderer(scene);
    const Picture start = renderer.render({scene.camera});
    for (const double moment : {1.5, 2.0, 0.25, 0.0}) {
        renderer.setTime(moment);
        scene.time.moment = moment;
        const Picture moved = renderer.render({scene.camera});
        EXPECT_EQ(moved.pixels, draw().pixels) << moment;
        EXPECT_EQ(differing(moved, start, 200, 400), 0) << "the other stays";
        EXPECT_EQ(differing(moved, start, 0, 200) > 1000, moment > 0);
    }
    renderer.setShown({false, true});
    renderer.setTime(2);
    renderer.setShown({true, true});
    scene.time.moment = 2;
    EXPECT_EQ(renderer.render({scene.camera}).pixels, draw().pixels) << "it went on while it was not seen";
}

TEST_P(SeveralSurfaces, FaultsNameTheSurface)
{
    scene.surfaces = {left(), item(folder.file("nowhere.vtp"))};
    EXPECT_NE(complaint().find("nowhere.vtp"), std::string::npos);
    scene.surfaces = {left(), right()};
    scene.surfaces[1].colorBy = "nothing";
    EXPECT_EQ(complaint().find(folder.file("right.vtp") + ": no array 'nothing' to colour by"), 0u) << complaint();
    scene.surfaces[1] = item("sphere");
    EXPECT_EQ(complaint().find("surface 'sphere': it has no vectors of its own"), 0u) << complaint();
    scene.surfaces[1] = context("sphere");
    EXPECT_EQ(complaint(), "");
    scene.surfaces[1] = item("slice:0,0,0:0,0,1");
    EXPECT_EQ(complaint().find("surface 'slice:0,0,0:0,0,1': there is no field to cut it out of"), 0u);

    scene.field.spec = folder.file("grid.vti");
    scene.field.vectors = "U";
    scene.surfaces = {left(), item("slice:2.5,0,-0.5:0,0,1")};
    scene.surfaces[1].vectors = "W";
    EXPECT_EQ(complaint().find("surface 'slice:2.5,0,-0.5:0,0,1': it has no array 'W' of its own"), 0u);
    scene.surfaces[1].vectors.reset();
    scene.surfaces[0].colorBy = "field:p";
    scene.surfaces[1].colorBy = "U:mag";
    EXPECT_EQ(
        complaint(),
        "surfaces: found the field's arrays 'p' and 'U:mag' to colour by; expected one array of the field for all "
        "surfaces, or surface:NAME");
    scene.surfaces[0].colorBy = "surface:q";
    EXPECT_EQ(complaint(), "");

    scene.surfaces.clear();
    for (int i = 0; i < 8; ++i) {
        scene.surfaces.push_back(left());
        scene.surfaces.back().colorBy = "surface:q";
        scene.surfaces.back().colorRange = std::array{0.0, 1.0 + i};
    }
    EXPECT_EQ(complaint().find("surfaces: found 8 kinds of colours; expected at most 7"), 0u) << complaint();
    scene.surfaces.pop_back();
    EXPECT_EQ(complaint(), "");
}

TEST_P(SeveralSurfaces, TwoHundredInThePlaceOfOneAreThatOne)
{
    scene.surfaces.assign(200, left());
    const Picture many = draw();
    scene.surfaces = {left()};
    EXPECT_EQ(draw().pixels, many.pixels);
}

TEST_P(SeveralSurfaces, AnyRanksGiveTheSameBytes)
{
    scene.field.spec = folder.file("grid.vti");
    scene.field.vectors = "U";
    scene.shading.lighting = scene.shading.antialias = true;
    scene.surfaces = {left(), item("slice:2.5,0,-0.5:0,0,1"), context(folder.file("right.vtp"))};
    scene.surfaces[1].colorBy = "p";
    CameraOptions camera;
    const Case c{"several", scene, camera};
    const auto one = testkit::draw(GetParam(), c, runOptions("static", "estimate", "auto"), 1, 2);
    for (const int ranks : {2, 3}) expectSameBytes(GetParam(), c, one, runOptions("hybrid", "estimate", "auto"), ranks);
    expectSameBytes(GetParam(), c, one, runOptions("pixels", "estimate", "auto", "on"), 3);
}

}  // namespace
}  // namespace aeolic
