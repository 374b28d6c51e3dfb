#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "aeolic/renderer.h"
#include "color_testing.h"

/// Colours can be read back: the mean of streaks over a small area is close to the colour map's own colour for the
/// value there.
namespace aeolic {
namespace {

using namespace testkit;

constexpr int kArea = 25;  // Pixels, squared.

Picture draw(const std::string& surface, const std::string& field, const std::string& colorMap, double blend)
{
    SceneDescription d;
    d.surface.spec = surface;
    d.field.spec = field;
    d.shading.colorBy = "tornado:mag";
    d.shading.colormap = colorMap;
    d.shading.lighting = false;
    d.shading.blend = blend;
    d.shading.scalarBar = false;
    d.shading.background = "transparent";
    d.output.width = 500;
    d.output.height = 400;
    d.run.backend = BackendChoice::cpu;
    return Renderer(d).render({d.camera});
}

/// The mean of an area; nothing where not all of it is surface.
bool meanOf(const Picture& picture, int x0, int y0, Triple& mean)
{
    mean = {};
    for (int y = y0; y < y0 + kArea; ++y)
        for (int x = x0; x < x0 + kArea; ++x) {
            const std::uint8_t* pixel = &picture.pixels[std::size_t(4 * (y * picture.width + x))];
            if (pixel[3] < 255) return false;
            for (std::size_t c = 0; c < 3; ++c) mean[c] += double(pixel[c]) / (kArea * kArea);
        }
    return true;
}

TEST(ReadBack, TheMeanOfStreaksIsTheMapsColour)
{
    for (const char* surface : {"teapot:20000", "sphere:20000"})
        for (const char* colorMap : {"viridis", "coolwarm"}) {
            const Picture streaks = draw(surface, "tornado:32,32,32", colorMap, 0.8),
                          plain = draw(surface, "tornado:32,32,32", colorMap, 0);
            std::vector<double> off;
            for (int y = 0; y + kArea <= streaks.height; y += kArea)
                for (int x = 0; x + kArea <= streaks.width; x += kArea) {
                    Triple seen, meant;
                    if (meanOf(streaks, x, y, seen) && meanOf(plain, x, y, meant))
                        off.push_back(ciede2000(labOf(seen), labOf(meant)));
                }
            ASSERT_GT(off.size(), 30u);
            std::sort(off.begin(), off.end());
            EXPECT_LE(off[off.size() / 2], 2) << surface << ", " << colorMap;
            EXPECT_LE(off.back(), 5) << surface << ", " << colorMap;
        }
}

}  // namespace
}  // namespace aeolic
