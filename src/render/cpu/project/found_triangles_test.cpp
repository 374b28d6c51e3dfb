#include "render/cpu/project/found_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "render/cpu/project/edge_pixels.h"
#include "render_testing.h"

namespace aeolic::cpu {
namespace {

using namespace testkit;

bool anyMarked(const EdgeMask& mask, const Extent& box)
{
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x)
            if ((mask.row(y)[x / 64] >> (x % 64) & 1) != 0) return true;
    return false;
}

EdgeMask randomMask(const Extent& rows, int pixels, std::mt19937& random)
{
    EdgeMask mask;
    mask.clear(rows);
    for (int i = 0; i < pixels; ++i) {
        const int x = int(random() % unsigned(rows.x1)), y = rows.y0 + int(random() % unsigned(rows.height()));
        mask.row(y)[x / 64] |= std::uint64_t{1} << (x % 64);
    }
    return mask;
}

TEST(MarkedBoxes, SaysOfEveryBoxOfATileWhetherItHasMarkedPixels)
{
    std::mt19937 random(1);
    for (const Extent& rows :
         {Extent{0, 0, 300, 200}, Extent{0, 37, 129, 90}, Extent{0, 5, 64, 6}, Extent{0, 0, 1, 1}}) {
        const EdgeMask mask = randomMask(rows, rows.width() * rows.height() / 400 + 1, random);
        const MarkedBoxes marked(mask);
        for (int i = 0; i < 20000; ++i) {
            const int side = i % 2 == 0 ? 9 : 64;
            const int x0 = int(random() % unsigned(rows.x1)), y0 = rows.y0 + int(random() % unsigned(rows.height()));
            const Extent box{x0, y0, std::min(x0 + 1 + int(random() % unsigned(side)), rows.x1),
                             std::min(y0 + 1 + int(random() % unsigned(side)), rows.y1)};
            ASSERT_EQ(marked.mayHave(box), anyMarked(mask, box)) << x0 << ' ' << y0 << ' ' << box.x1 << ' ' << box.y1;
        }
    }
}

/// The quick answer may be yes where the other is no, but seldom, and never the other way round.
TEST(MarkedBoxes, TheQuickAnswerMissesNothing)
{
    std::mt19937 random(3);
    const EdgeMask mask = randomMask({0, 37, 300, 190}, 40, random);
    const MarkedBoxes marked(mask);
    int quick = 0, right = 0;
    for (int i = 0; i < 20000; ++i) {
        const int x0 = int(random() % 300u), y0 = 37 + int(random() % 153u);
        const Extent box{x0, y0, std::min(x0 + 1 + int(random() % 9u), 300),
                         std::min(y0 + 1 + int(random() % 9u), 190)};
        const bool mayBe = marked.mayBeNear(box.x0, box.y0, box.x1, box.y1), has = anyMarked(mask, box);
        ASSERT_TRUE(mayBe || !has) << x0 << ' ' << y0;
        quick += mayBe, right += has;
    }
    EXPECT_GT(right, 200);
    EXPECT_LT(quick, 20000 / 2);
    EXPECT_TRUE(marked.mayBeNear(0, 37, 300, 190));
    marked.mayBeNear(299, 5000, 300, 190);  // Empty and below the rows: any answer, but nothing beyond memory is read.
}

TEST(MarkedBoxes, LargerBoxesAreNotLookedAt)
{
    EdgeMask mask;
    mask.clear({0, 0, 300, 200});
    EXPECT_FALSE(MarkedBoxes(mask).mayHave({0, 0, 64, 64}));
    EXPECT_TRUE(MarkedBoxes(mask).mayHave({0, 0, 65, 1}));
}

/// What findMarked() has to find, from the points alone.
std::vector<std::uint32_t> overMarked(const SceneArrays& arrays, const ScreenVertices& screen, const EdgeMask& mask)
{
    std::vector<std::uint32_t> ids;
    const auto& triangles = arrays.scene->surface.triangles;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto span = [&](std::int32_t ScreenVertex::*v, int begin, int end) {
            const auto corner = [&](std::size_t k) { return screen[triangles[i][k]].*v; };
            const auto [least, most] = std::minmax({corner(0), corner(1), corner(2)});
            int first = begin, past = end;  // Pixels whose centre, with the margin, the triangle reaches.
            while (first < end && first * kSubpixels + kSubpixels / 2 + kSampleMargin < least) ++first;
            while (past > first && (past - 1) * kSubpixels + kSubpixels / 2 - kSampleMargin > most) --past;
            return std::pair(first, past);
        };
        const auto [x0, x1] = span(&ScreenVertex::x, mask.rows.x0, mask.rows.x1);
        const auto [y0, y1] = span(&ScreenVertex::y, mask.rows.y0, mask.rows.y1);
        if (x0 < x1 && y0 < y1 && anyMarked(mask, {x0, y0, x1, y1})) ids.push_back(std::uint32_t(i));
    }
    return ids;
}

TEST(FoundTriangles, FindsWhatMayCoverASampleOfAMarkedPixelAndThatMayLieBetweenCentres)
{
    std::mt19937 random(2);
    // Triangles of many pixels, of about one, and far smaller ones. Their numbers are no whole vectors.
    for (const char* surface : {"teapot:301", "teapot:6007", "teapot:60011"}) {
        const Scene scene = makeBuiltinScene(surface, "uniform:2,2,2");
        const SceneArrays arrays(scene);
        const View view = makeView(fitCamera(scene, {}, 200, 150), scene, {});
        const Extent whole{0, 0, 200, 150};
        FoundTriangles found;
        found.find(arrays, view, whole);
        EXPECT_TRUE(found.has(arrays, view, {10, 10, 20, 20}));
        EXPECT_FALSE(found.has(arrays, view, {10, 10, 20, 151}));
        const EdgeMask mask = randomMask({0, 20, 200, 120}, 300, random);
        const MarkedBoxes marked(mask);
        std::vector<TriangleBox> boxes;
        std::size_t atCentres = 0;
        for (std::size_t i = 0; i < found.chunks(); ++i) {
            found.findMarked(i, marked, mask.rows, boxes);
            atCentres += found.boxes(i).size();
        }
        std::vector<std::uint32_t> ids;
        for (const TriangleBox& box : boxes) ids.push_back(box.id);
        std::sort(ids.begin(), ids.end());
        EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end()) << surface;
        const std::vector<std::uint32_t> needed = overMarked(arrays, found.screen(), mask);
        ASSERT_GT(needed.size(), 20u) << surface;
        EXPECT_TRUE(std::includes(ids.begin(), ids.end(), needed.begin(), needed.end())) << surface;
        EXPECT_LT(ids.size(), 3 * needed.size() + 100) << surface;
        EXPECT_GT(atCentres, 0u);
    }
}

}  // namespace
}  // namespace aeolic::cpu
