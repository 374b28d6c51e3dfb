#include "cluster/composite/composite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <mutex>

#include "composite_testing.h"
#include "ranks/thread_communicator.h"
#include "render/gbuffer.h"

namespace aeolic {
namespace {

constexpr int kWidth = 20, kHeight = 12;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::uint32_t flowAt(int x, int y)
{
    return std::uint32_t(1000 * y + x + 1);
}
float scalarAt(int x, int y)
{
    return float(x) - 100.0f * float(y);
}

/// Which rank's brick shows at a pixel: a chequerboard with holes, so that rows have many runs.
int ownerAt(int x, int y, int ranks)
{
    return (x * y) % 5 == 4 ? -1 : (x / 3 + y) % ranks;
}

FieldPixels pixelsOf(int rank, int ranks, bool withScalar)
{
    FieldPixels pixels;
    pixels.drawn = {2, 1, kWidth, kHeight};  // Nothing of the first row and columns is anyone's.
    pixels.flow.resize(pixels.drawn);
    if (withScalar) pixels.scalar.resize(pixels.drawn);
    for (int y = pixels.drawn.y0; y < pixels.drawn.y1; ++y)
        for (int x = pixels.drawn.x0; x < pixels.drawn.x1; ++x) {
            const bool mine = ownerAt(x, y, ranks) == rank;
            // A masked vector (flow 0) whose scalar counts all the same.
            pixels.flow.at(x, y) = mine && x != 7 ? flowAt(x, y) : 0;
            if (withScalar) pixels.scalar.at(x, y) = mine ? scalarAt(x, y) : kNan;
        }
    return pixels;
}

GBuffer emptyBuffer(const Extent& rows, bool withScalar)
{
    GBuffer buffer;
    buffer.resize(rows, withScalar);
    for (int y = rows.y0; y < rows.y1; ++y)
        for (int x = rows.x0; x < rows.x1; ++x) {
            buffer.flow.at(x, y) = 0;
            if (withScalar) buffer.scalar.at(x, y) = kNan;
        }
    return buffer;
}

void expectWhole(int ranks, bool withScalar)
{
    runRanks(ranks, [&](Communicator& communicator) {
        const std::vector<Extent> rowsOf = testkit::overlappingRows(ranks, kWidth, kHeight);
        const Extent rows = rowsOf[std::size_t(communicator.rank())];
        GBuffer buffer = emptyBuffer(rows, withScalar);
        const FieldPixels mine = pixelsOf(communicator.rank(), ranks, withScalar);
        composite(communicator, {&mine, {&buffer.flow, withScalar ? &buffer.scalar : nullptr}}, rowsOf);
        for (int y = rows.y0; y < rows.y1; ++y)
            for (int x = rows.x0; x < rows.x1; ++x) {
                const bool owned = y >= 1 && x >= 2 && ownerAt(x, y, ranks) >= 0;
                ASSERT_EQ(buffer.flow.at(x, y), owned && x != 7 ? flowAt(x, y) : 0u) << x << ", " << y;
                if (!withScalar) continue;
                if (owned)
                    ASSERT_EQ(buffer.scalar.at(x, y), scalarAt(x, y));
                else
                    ASSERT_TRUE(std::isnan(buffer.scalar.at(x, y)));
            }
    });
}

TEST(CompositeField, EveryRowGetsEveryBricksPixels)
{
    for (const int ranks : {1, 2, 3, 5}) {
        expectWhole(ranks, true);
    }
}

TEST(CompositeField, WithoutAScalarOnlyFlowTravels)
{
    expectWhole(3, false);
    std::int64_t with = 0, without = 0;
    for (const bool scalar : {false, true})
        runRanks(2, [&](Communicator& communicator) {
            const std::vector<Extent> rowsOf{{0, 0, kWidth, kHeight}, {0, kHeight, kWidth, kHeight}};
            GBuffer buffer = emptyBuffer(rowsOf[std::size_t(communicator.rank())], scalar);
            const FieldPixels mine = pixelsOf(communicator.rank(), 2, scalar);
            composite(communicator, {&mine, {&buffer.flow, scalar ? &buffer.scalar : nullptr}}, rowsOf);
            if (communicator.rank() == 1) (scalar ? with : without) = communicator.sent().bytes;
        });
    EXPECT_GT(without, 0);
    EXPECT_LT(without, with);
}

}  // namespace
}  // namespace aeolic
