#include "data/field_tiles.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "data/load/series/interpolate.h"
#include "data/surface_range.h"

namespace aeolic {
namespace {

/// Thinner than a tile, as large as some, and all that is left over.
const GridIndex someDims[] = {{2, 2, 2}, {15, 3, 4}, {16, 5, 5}, {31, 2, 9}, {14, 7, 3}, {45, 1, 8}, {61, 17, 23}};

/// Every sample another one.
GridField numbered(const GridIndex& dims, FieldPrecision precision = FieldPrecision::float32)
{
    GridField field;
    field.dims = dims;
    field.precision = precision;
    const auto samples = std::make_shared<std::vector<std::byte>>(field.bytes() + 4);
    if (precision == FieldPrecision::float32) {
        for (std::size_t i = 0; i < 3 * field.sampleCount(); ++i) {
            const float value = float(i);
            std::memcpy(samples->data() + 4 * i, &value, 4);
        }
    } else {
        for (std::size_t i = 0; i < 3 * field.sampleCount(); ++i) {
            const auto value = std::uint16_t(i);
            std::memcpy(samples->data() + 2 * i, &value, 2);
        }
    }
    field.samples = std::shared_ptr<const void>(samples, samples->data());
    return field;
}

TEST(FieldTiles, EverySampleHasAPlaceOfItsOwn)
{
    for (const GridIndex& dims : someDims) {
        std::vector<int> taken(std::size_t(dims[0] * dims[1] * dims[2]), 0);
        for (std::int64_t z = 0; z < dims[2]; ++z)
            for (std::int64_t y = 0; y < dims[1]; ++y)
                for (std::int64_t x = 0; x < dims[0]; ++x) {
                    const auto index = FieldTiles::index(dims, x, y, z);
                    ASSERT_GE(index, 0);
                    ASSERT_LT(index, std::int64_t(taken.size()));
                    ++taken[std::size_t(index)];
                }
        EXPECT_EQ(taken, std::vector<int>(taken.size(), 1)) << dims[0] << "x" << dims[1] << "x" << dims[2];
    }
}

TEST(FieldTiles, RowsComeOutAsTheyWentIn)
{
    for (const GridIndex& dims : someDims)
        for (const FieldPrecision precision : {FieldPrecision::float32, FieldPrecision::float16}) {
            const GridField rows = numbered(dims, precision);
            GridField tiles = numbered(dims, precision);
            toTiles(tiles);
            EXPECT_TRUE(tiles.tiled);
            EXPECT_EQ(std::memcmp(static_cast<const std::byte*>(tiles.samples.get()) + tiles.bytes(),
                                  static_cast<const std::byte*>(rows.samples.get()) + rows.bytes(), 4),
                      0)
                << "written past the end";
            const std::size_t rowBytes = std::size_t(dims[0]) * rows.sampleBytes();
            std::vector<std::byte> expected(rowBytes), found(rowBytes);
            for (std::int64_t z = 0; z < dims[2]; ++z)
                for (std::int64_t y = 0; y < dims[1]; ++y) {
                    copyRow(rows, y, z, expected.data());
                    copyRow(tiles, y, z, found.data());
                    ASSERT_EQ(found, expected) << dims[0] << "x" << dims[1] << "x" << dims[2] << ": " << y << ", " << z;
                }
        }
}

TEST(FieldTiles, OnlyLargeFieldsOfVectors)
{
    GridField field;
    field.dims = {256, 256, 256};
    EXPECT_TRUE(worthTiling(field));
    field.components = 1;
    EXPECT_FALSE(worthTiling(field));
    field.components = 3;
    field.dims = {64, 64, 64};
    EXPECT_FALSE(worthTiling(field));
    field.dims = {20000, 20000, 4};
    EXPECT_FALSE(worthTiling(field)) << "a group of layers of 19 GB";
    field.dims = {1600, 1600, 1600};
    EXPECT_TRUE(worthTiling(field));
    field.dims = {1630, 1630, 1630};
    EXPECT_FALSE(worthTiling(field)) << "more samples than 32 bits count";
    const auto small = std::make_shared<const GridField>(numbered({4, 4, 4}));
    EXPECT_EQ(inTiles(small), small);
}

TEST(FieldTiles, BetweenMomentsInTiles)
{
    const GridIndex dims{31, 6, 9};
    const GridField rows = numbered(dims);
    GridField tiles = numbered(dims);
    toTiles(tiles);
    EXPECT_FALSE(sameGrid(rows, tiles));
    const auto between = interpolated(tiles, tiles, 0.25);
    EXPECT_TRUE(between->tiled);
    EXPECT_EQ(std::memcmp(between->samples.get(), tiles.samples.get(), tiles.bytes()), 0);
    EXPECT_NE(interpolated(rows, rows, 0.5, between)->samples, between->samples);
}

TEST(FieldTiles, TheSameRangeOnASurface)
{
    const GridField rows = numbered({33, 18, 11});
    GridField tiles = numbered({33, 18, 11});
    toTiles(tiles);
    SurfaceMesh mesh;
    mesh.positions = {{3.1f, 2.7f, 0.4f}, {30.2f, 15.5f, 3.3f}, {16.4f, 1.2f, 9.6f}};
    mesh.triangles = {{0, 1, 2}};
    const auto expected = rangeOnSurface(mesh, rows);
    ASSERT_TRUE(expected);
    EXPECT_EQ(rangeOnSurface(mesh, tiles), expected);
}

}  // namespace
}  // namespace aeolic
