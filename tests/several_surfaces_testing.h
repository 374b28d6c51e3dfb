#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "data/vtk/testing/sample_files.h"
#include "description/choices.h"
#include "description/colormap.h"
#include "render_testing.h"

namespace aeolic::testkit {

using namespace test;

inline SurfaceItem item(const std::string& spec)
{
    SurfaceItem one;
    one.spec = spec;
    return one;
}

inline SurfaceItem context(const std::string& spec)
{
    SurfaceItem one = item(spec);
    one.streaks = false;
    one.colorBy = "";
    return one;
}

/// Two sheets of 1 x 1 beside each other, from x = 0 and from x = 2, seen from above, 100 pixels a unit.
class SeveralSurfaces : public BackendTest {
protected:
    void SetUp() override
    {
        BackendTest::SetUp();
        SheetSample left, right;
        right.shift = {2, 0, 0};
        right.scale = 10;
        writeSheetFile(folder.file("left.vtp"), left);
        writeSheetFile(folder.file("right.vtp"), right);
        GridSample grid;
        grid.dims = {17, 9, 9};
        grid.origin = {-0.5, -0.5, -1};
        writeGridFile(folder.file("grid.vti"), grid);
        writeGridFile(folder.file("cells.vtu"), grid);
        scene.field.vectors = "tau";
        scene.shading.lighting = scene.shading.scalarBar = scene.shading.antialias = false;
        scene.lic.steps = 10;
        scene.output.width = 400;
        scene.output.height = 200;
        scene.run.backend = *choiceNamed<BackendChoice>(GetParam());
        scene.camera.position = Vec3{1.5, 0.5, 10};
        scene.camera.focal = Vec3{1.5, 0.5, 0};
        scene.camera.up = Vec3{0, 1, 0};
        scene.camera.fov = 2 * std::atan(0.1) * 180 / 3.14159265358979;
    }

    SurfaceItem left() const { return item(folder.file("left.vtp")); }
    SurfaceItem right() const { return item(folder.file("right.vtp")); }
    Picture draw() const { return Renderer(scene).render({scene.camera}); }

    std::string complaint() const
    {
        try {
            draw();
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    TempFolder folder;
    SceneDescription scene;
};

inline Color colorAt(const Picture& picture, int x, int y)
{
    const std::uint8_t* p = picture.pixels.data() + (std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * 3;
    return {p[0], p[1], p[2]};
}

/// Counts pixels that differ in columns [x0, x1).
inline int differing(const Picture& a, const Picture& b, int x0, int x1)
{
    int count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = x0; x < x1; ++x) count += colorAt(a, x, y) != colorAt(b, x, y);
    return count;
}

/// How many colours there are in a square.
inline std::size_t coloursIn(const Picture& picture, int x0, int y0, int side)
{
    std::set<Color> colors;
    for (int y = y0; y < y0 + side; ++y)
        for (int x = x0; x < x0 + side; ++x) colors.insert(colorAt(picture, x, y));
    return colors.size();
}

}  // namespace aeolic::testkit
