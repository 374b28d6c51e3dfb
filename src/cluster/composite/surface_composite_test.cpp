#include "cluster/composite/composite.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "cluster/composite/pixel_messages.h"
#include "composite_testing.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

constexpr int kWidth = 20, kHeight = 12;

/// A pixel of a rank's piece; depth 0: none.
struct Seen {
    float depth = 0;
    std::uint64_t order = 0;
};
using SeenAt = std::function<Seen(int rank, int x, int y)>;

/// Told by who drew it.
float valueOf(int rank, int x, int y, int image)
{
    return float(1000 * rank + 100 * image + x) + 0.25f * float(y);
}

SurfacePixels pixelsOf(int rank, const Extent& drawn, bool withScalar, const SeenAt& seenAt)
{
    SurfacePixels pixels;
    pixels.drawn = drawn;
    pixels.depth.resize(drawn);
    pixels.order.resize(drawn);
    pixels.seen.resize(drawn, withScalar);
    for (int y = drawn.y0; y < drawn.y1; ++y)
        for (int x = drawn.x0; x < drawn.x1; ++x) {
            const Seen seen = seenAt(rank, x, y);
            pixels.depth.at(x, y) = std::bit_cast<std::uint32_t>(seen.depth);
            pixels.order.at(x, y) = seen.order;
            pixels.seen.invDepth.at(x, y) = valueOf(rank, x, y, 0);
            pixels.seen.gradX.at(x, y) = valueOf(rank, x, y, 1);
            pixels.seen.gradY.at(x, y) = valueOf(rank, x, y, 2);
            pixels.seen.light.at(x, y) = valueOf(rank, x, y, 3);
            pixels.seen.flow.at(x, y) = std::uint32_t(valueOf(rank, x, y, 4));
            if (withScalar) pixels.seen.scalar.at(x, y) = valueOf(rank, x, y, 5);
        }
    return pixels;
}

void clear(GBuffer& buffer, const Extent& rows, bool withScalar)
{
    buffer.resize(rows, withScalar);
    for (int y = rows.y0; y < rows.y1; ++y)
        for (int x = rows.x0; x < rows.x1; ++x) buffer.invDepth.at(x, y) = 0, buffer.flow.at(x, y) = 0;
}

/// The triangle to be seen at a pixel: the greatest 1 / depth, of equal ones the least order; -1: none.
int nearestAt(int ranks, int x, int y, const SeenAt& seenAt)
{
    int nearest = -1;
    for (int r = 0; r < ranks; ++r) {
        const Seen mine = seenAt(r, x, y), best = nearest < 0 ? Seen{0, ~0ull} : seenAt(nearest, x, y);
        if (mine.depth > best.depth || (mine.depth > 0 && mine.depth == best.depth && mine.order < best.order))
            nearest = r;
    }
    return nearest;
}

void expectNearest(int ranks, bool withScalar, const SeenAt& seenAt)
{
    runRanks(ranks, [&](Communicator& communicator) {
        const std::vector<Extent> rowsOf = testkit::overlappingRows(ranks, kWidth, kHeight);
        const Extent rows = rowsOf[std::size_t(communicator.rank())];
        GBuffer buffer;
        clear(buffer, rows, withScalar);
        const SurfacePixels mine = pixelsOf(communicator.rank(), {0, 0, kWidth, kHeight}, withScalar, seenAt);
        composite(communicator, {&mine, &buffer}, rowsOf);
        for (int y = rows.y0; y < rows.y1; ++y)
            for (int x = rows.x0; x < rows.x1; ++x) {
                const int nearest = nearestAt(ranks, x, y, seenAt);
                if (nearest < 0) {
                    ASSERT_EQ(buffer.invDepth.at(x, y), 0) << x << ", " << y;
                    continue;
                }
                ASSERT_EQ(buffer.invDepth.at(x, y), valueOf(nearest, x, y, 0)) << x << ", " << y;
                ASSERT_EQ(buffer.gradX.at(x, y), valueOf(nearest, x, y, 1));
                ASSERT_EQ(buffer.gradY.at(x, y), valueOf(nearest, x, y, 2));
                ASSERT_EQ(buffer.light.at(x, y), valueOf(nearest, x, y, 3));
                ASSERT_EQ(buffer.flow.at(x, y), std::uint32_t(valueOf(nearest, x, y, 4)));
                if (withScalar) {
                    ASSERT_EQ(buffer.scalar.at(x, y), valueOf(nearest, x, y, 5));
                }
            }
    });
}

/// A triangle that reaches into several bricks is drawn by several ranks: each pixel by all of them, sampled by one.
TEST(CompositeSurface, WhatComesFromTheFieldIsTheOwners)
{
    constexpr int kRanks = 3;
    constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
    const auto ownerOf = [](int x, int y) { return (x + y) % 4; };  // 3: nobody's cell.
    runRanks(kRanks, [&](Communicator& communicator) {
        const int rank = communicator.rank();
        const Extent rows{0, 0, kWidth, kHeight};
        SurfacePixels pixels = pixelsOf(rank, rows, true, [](int, int, int) { return Seen{0.5f, 7}; });
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                pixels.seen.light.at(x, y) = valueOf(0, x, y, 3);
                if (ownerOf(x, y) == rank) continue;
                pixels.seen.flow.at(x, y) = 0;
                pixels.seen.scalar.at(x, y) = kNothing;
            }
        GBuffer buffer;
        clear(buffer, rows, true);
        composite(communicator, {&pixels, &buffer}, std::vector<Extent>(kRanks, rows));
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const int owner = ownerOf(x, y);
                EXPECT_EQ(buffer.light.at(x, y), valueOf(0, x, y, 3));
                EXPECT_EQ(buffer.flow.at(x, y), owner < kRanks ? std::uint32_t(valueOf(owner, x, y, 4)) : 0u);
                if (owner < kRanks)
                    EXPECT_EQ(buffer.scalar.at(x, y), valueOf(owner, x, y, 5));
                else
                    EXPECT_TRUE(std::isnan(buffer.scalar.at(x, y)));
            }
    });
}

TEST(CompositeSurface, TheNearestPieceShows)
{
    const SeenAt slopes = [](int rank, int x, int y) {
        if ((x * y + rank) % 5 == 4) return Seen{};
        return Seen{0.5f + 0.01f * float((7 * x + 3 * y + 11 * rank) % 17), std::uint64_t(rank)};
    };
    for (const int ranks : {1, 2, 3, 5})
        for (const bool withScalar : {false, true}) expectNearest(ranks, withScalar, slopes);
}

/// At the border of two pieces both draw the same edge.
TEST(CompositeSurface, OfEquallyNearOnesTheFirstOfTheWholeSurface)
{
    const SeenAt ties = [](int rank, int x, int y) {
        return Seen{1.0f + 0.5f * float(y % 2), std::uint64_t((x + rank) % 4) << 40 | std::uint64_t(rank)};
    };
    expectNearest(4, true, ties);
}

TEST(CompositeSurface, NobodysPixelsStayBackground)
{
    expectNearest(3, true, [](int, int, int) { return Seen{}; });
    expectNearest(3, false, [](int rank, int x, int) { return Seen{rank == 1 && x == 7 ? 2.0f : 0.0f, 9}; });
}

/// Pieces are seen in different parts of the image, one of them nowhere. Only seen pixels travel.
TEST(CompositeSurface, OnlyWhatIsSeenTravels)
{
    const SeenAt everywhere = [](int, int, int) { return Seen{1, 3}; };
    runRanks(3, [&](Communicator& communicator) {
        const int rank = communicator.rank();
        const Extent drawn = rank == 0 ? Extent{} : rank == 1 ? Extent{3, 2, 8, 6} : Extent{8, 5, 12, 9};
        const std::vector<Extent> rowsOf{{0, 0, kWidth, 4}, {0, 4, kWidth, 8}, {0, 8, kWidth, kHeight}};
        const Extent rows = rowsOf[std::size_t(rank)];
        GBuffer buffer;
        clear(buffer, rows, false);
        const SurfacePixels mine = pixelsOf(rank, drawn, false, everywhere);
        const std::int64_t before = communicator.sent().bytes;
        composite(communicator, {&mine, &buffer}, rowsOf);
        for (int y = rows.y0; y < rows.y1; ++y)
            for (int x = rows.x0; x < rows.x1; ++x) {
                const int owner = Extent{3, 2, 8, 6}.contains(x, y) ? 1 : Extent{8, 5, 12, 9}.contains(x, y) ? 2 : -1;
                ASSERT_EQ(buffer.invDepth.at(x, y), owner < 0 ? 0 : valueOf(owner, x, y, 0)) << x << ", " << y;
            }
        // 8 bytes to every other rank; then two rows of five pixels to rank 0, three rows of four to rank 1.
        const std::int64_t lengths = 2 * 8, sent = communicator.sent().bytes - before;
        if (rank == 0) {
            EXPECT_EQ(sent, lengths);
        }
        if (rank == 1) {
            EXPECT_EQ(sent, lengths + 8 + 2 * (2 + 4 + 5 * 32));
        }
        if (rank == 2) {
            EXPECT_EQ(sent, lengths + 8 + 3 * (2 + 4 + 4 * 32));
        }
    });
}

/// What rank 0 of two says to `message` from rank 1.
std::string complaintAbout(const Bytes& message)
{
    std::string complaint;
    const std::vector<Extent> rowsOf{{0, 2, kWidth, 6}, {0, 6, kWidth, kHeight}};
    runRanks(2, [&](Communicator& communicator) {
        if (communicator.rank() == 1) {
            communicator.exchange({{0, message}});
            return;
        }
        GBuffer buffer;
        clear(buffer, rowsOf[0], false);
        const SurfacePixels mine = pixelsOf(0, {}, false, nullptr);
        try {
            composite(communicator, {&mine, &buffer}, rowsOf);
        } catch (const std::runtime_error& error) {
            complaint = error.what();
        }
        for (int y = 2; y < 6; ++y)
            for (int x = 0; x < kWidth; ++x)
                if (!complaint.empty()) {
                    EXPECT_EQ(buffer.invDepth.at(x, y), 0) << "nothing is written of a bad message";
                }
    });
    return complaint;
}

Bytes messageOf(const MessageRows& rows, const std::vector<PixelRun>& runs, std::size_t pixels)
{
    Bytes bytes;
    appendBytes(bytes, &rows, 1);
    appendRuns(bytes, runs);
    bytes.resize(bytes.size() + pixels * 32, std::byte{0x3f});
    return bytes;
}

TEST(CompositeSurface, MessagesThatAreNoneOfOursAreRefused)
{
    EXPECT_EQ(complaintAbout(messageOf({3, 4}, {{2, 5}, {7, 8}}, 4)), "");
    EXPECT_EQ(complaintAbout(messageOf({3, 4}, {{2, 5}, {7, 8}}, 3)), "pixels from rank 1 end too early");
    EXPECT_EQ(complaintAbout(messageOf({3, 4}, {{2, 5}, {7, 8}}, 5)), "pixels from rank 1 go on too long");
    EXPECT_EQ(complaintAbout(messageOf({1, 2}, {{2, 5}}, 3)), "pixels from rank 1 are of other rows");
    EXPECT_EQ(complaintAbout(messageOf({5, 7}, {{2, 5}}, 3)), "pixels from rank 1 are of other rows");
    EXPECT_EQ(complaintAbout(messageOf({4, 3}, {}, 0)), "pixels from rank 1 are of other rows");
    EXPECT_EQ(complaintAbout(messageOf({3, 4}, {{18, 21}}, 3)), "pixels from rank 1 are of other columns");
    EXPECT_EQ(complaintAbout(messageOf({3, 4}, {{5, 5}}, 0)), "pixels from rank 1 are of other columns");
    EXPECT_EQ(complaintAbout(messageOf({3, 4}, {{7, 9}, {3, 4}}, 3)), "pixels from rank 1 are of other columns");
    EXPECT_EQ(complaintAbout(Bytes(5)), "pixels from rank 1 end too early");
}

}  // namespace
}  // namespace aeolic
