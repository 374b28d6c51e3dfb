#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "base/half.h"
#include "data/field_tiles.h"
#include "data/load/loaded_scene.h"
#include "render_testing.h"
#include "same_bytes_testing.h"

/// Fields whose samples lie in tiles draw the same bits as fields whose samples lie in rows.
namespace aeolic {
namespace {

using namespace testkit;

class TiledField : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, TiledField, allBackends, backendName);

/// A part of a field, in memory of its own: with nothing behind the last sample but what halves need.
std::shared_ptr<GridField> partOf(const GridField& whole, const std::optional<Brick>& brick, FieldPrecision precision)
{
    auto part = std::make_shared<GridField>(whole);
    part->brick = brick;
    part->precision = precision;
    const GridIndex held = part->heldDims(), first = part->firstSample();
    const bool half = precision == FieldPrecision::float16;
    const auto memory = std::make_shared<std::vector<std::byte>>(part->bytes() + (half ? 4 : 0));
    std::size_t at = 0;
    for (std::int64_t z = 0; z < held[2]; ++z)
        for (std::int64_t y = 0; y < held[1]; ++y)
            for (std::int64_t i = 0; i < 3 * held[0]; ++i) {
                const std::int64_t row = (z + first[2]) * whole.dims[1] + y + first[1];
                const float value = whole.floats()[3 * (row * whole.dims[0] + first[0]) + i];
                const std::uint16_t rounded = halfFromFloat(value);
                half ? std::memcpy(memory->data() + at, &rounded, 2) : std::memcpy(memory->data() + at, &value, 4);
                at += half ? 2 : 4;
            }
    part->samples = std::shared_ptr<const void>(memory, memory->data());
    return part;
}

glm::vec3 swirl(const glm::dvec3& p)
{
    if (p.x > 0.6 && p.y > 0.1) return glm::vec3(std::numeric_limits<float>::quiet_NaN());
    return {std::sin(3 * p.y + p.z), std::cos(2 * p.x), std::sin(p.x * p.y * 5)};
}

/// A grid with whole tiles and with partial ones at its ends. Cells lie in all of them.
const std::array<std::int64_t, 3> someDims[] = {{33, 18, 11}, {31, 9, 8}, {46, 5, 7}, {2, 2, 2}};

TEST_P(TiledField, ShowsWhatItShowsInRows)
{
    for (const auto& dims : someDims)
        for (const FieldPrecision precision : {FieldPrecision::float32, FieldPrecision::float16}) {
            const auto field = makeField({{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}}, dims, swirl);
            const auto rows = partOf(*field, {}, precision), tiles = partOf(*field, {}, precision);
            toTiles(*tiles);
            const SurfaceMesh mesh = makeBuiltinScene("sphere:2000", "uniform:2,2,2").surface;
            for (const double azimuthDeg : {20.0, 200.0}) {
                CameraOptions options;
                options.azimuth = azimuthDeg;
                Stages inRows(GetParam(), makeScene(mesh, rows)), inTiles(GetParam(), makeScene(mesh, tiles));
                const Camera camera = fitCamera(inRows.scene, options, 150, 120);
                const GBuffer& expected = inRows.project(camera, directLic(10));
                const GBuffer& found = inTiles.project(camera, directLic(10));
                for (int y = 0; y < 120; ++y)
                    ASSERT_TRUE(std::equal(&found.flow.at(0, y), &found.flow.at(0, y) + 150, &expected.flow.at(0, y)))
                        << dims[0] << "x" << dims[1] << "x" << dims[2] << ", row " << y;
            }
        }
}

TEST(TiledField, BricksShowWhatTheyShowInRows)
{
    const auto field = makeField({{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}}, {70, 41, 37}, swirl);
    const SurfaceMesh mesh = makeBuiltinScene("sphere:2000", "uniform:2,2,2").surface;
    int shown = 0;
    for (const int rank : {0, 1, 2, 3, 4})
        for (const FieldPrecision precision : {FieldPrecision::float32, FieldPrecision::float16}) {
            const Brick brick = brickOf(*field, {rank, 5});
            const auto rows = partOf(*field, brick, precision), tiles = partOf(*field, brick, precision);
            toTiles(*tiles);
            const Scene inRows = makeScene(mesh, rows), inTiles = makeScene(mesh, tiles);
            const auto one = makeBackend(BackendChoice::cpu, inRows), other = makeBackend(BackendChoice::cpu, inTiles);
            const Camera camera = fitCamera(inRows, {}, 150, 120);
            const View view = makeView(camera, inRows, directLic(10));
            const auto pixelsOf = [&](Backend& backend) -> const FieldPixels& {
                return *std::get<BrickShare>(backend.project(view, wholeImage(camera))).mine;
            };
            const FieldPixels &expected = pixelsOf(*one), &found = pixelsOf(*other);
            ASSERT_EQ(found.drawn, expected.drawn);
            for (int y = found.drawn.y0; y < found.drawn.y1; ++y)
                for (int x = found.drawn.x0; x < found.drawn.x1; ++x) {
                    ASSERT_EQ(found.flow.at(x, y), expected.flow.at(x, y)) << "rank " << rank << ": " << x << "," << y;
                    shown += found.flow.at(x, y) != 0;
                }
        }
    EXPECT_GT(shown, 5000);
}

/// The field is large enough for tiles; its bricks are not.
TEST(TiledField, FromFieldsThatAreAndBricksThatAreNot)
{
    const Case c =
        makeCase("tiles and rows", 120, 101, licOf(LicMethod::hierarchical, 40), "torus:3000", "abc:150,160,121");
    ASSERT_TRUE(loadScene(c.description).field->tiled);
    const std::vector<Picture> alone = draw("cpu", c, {}, 1, 1);
    expectSameBytes("cpu", c, alone, runOptions("hybrid", "estimate", "auto", "on"), 2);
}

}  // namespace
}  // namespace aeolic
