#include "cluster/picture_gather.h"

#include <gtest/gtest.h>

#include "cluster/thread_communicator.h"

namespace aeolic {
namespace {

using Color = std::array<std::uint8_t, 4>;
constexpr Color kWhite{255, 255, 255, 255}, kClear{0, 0, 0, 0};
constexpr int kWidth = 7, kHeight = 12;

/// What frame `frame` shows at a pixel: a block that moves, each frame's of another shade; else background.
Color colorAt(int x, int y, int frame, const Color& background)
{
    const bool covered = x >= frame % 3 && x < frame % 3 + 3 && y >= frame && y < frame + 3;
    return covered ? Color{std::uint8_t(x), std::uint8_t(y), std::uint8_t(frame), 255} : background;
}

/// As the processor's backend does: background beside the block alone.
void draw(Tile& tile, const Extent& rows, int frame, const Color& background)
{
    tile.setBackground(background);
    for (int y = rows.y0; y < rows.y1; ++y) {
        const bool covered = y >= frame && y < frame + 3;
        tile.clearBeside(y, covered ? ColumnSpan{frame % 3, frame % 3 + 3} : ColumnSpan{});
        for (int x = 0; x < kWidth; ++x)
            if (colorAt(x, y, frame, background) != background) {
                const Color color = colorAt(x, y, frame, background);
                std::copy(color.begin(), color.end(), tile.row(y) + 4 * std::ptrdiff_t(x));
            }
    }
}

void expectFrame(const Tile& picture, int frame, const Color& background)
{
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Color expected = colorAt(x, y, frame, background);
            EXPECT_TRUE(std::equal(expected.begin(), expected.end(), picture.row(y) + 4 * std::ptrdiff_t(x)))
                << x << ' ' << y << " in frame " << frame;
        }
}

void drawTogether(Communicator& communicator, const Stripes& stripes, Tile& picture, Tile& stripe, int frame,
                  const Color& background)
{
    BusyClock busy;
    const Extent own = stripes.extent(communicator.rank(), kWidth);
    Tile& tile = communicator.isRoot() ? picture : stripe;
    tile.resize(communicator.isRoot() ? Extent{0, 0, kWidth, kHeight} : own);
    draw(tile, own, frame, background);
    if (communicator.isRoot())
        receivePainted(communicator, stripes, picture, busy);
    else
        sendPainted(communicator, stripe);
}

TEST(PictureGather, NothingIsLeftOfFramesBefore)
{
    for (const int ranks : {1, 2, 3, 5})
        runRanks(ranks, [&](Communicator& communicator) {
            Tile picture, stripe;
            for (const Color& background : {kWhite, kClear})
                for (int frame = 0; frame < 14; ++frame) {
                    const Stripes stripes = frame % 2 ? equalStripes(kHeight, ranks) : Stripes{[&] {
                        std::vector<int> firstRow(std::size_t(ranks), std::min(frame, kHeight));  // Some are empty.
                        firstRow.front() = 0;
                        firstRow.push_back(kHeight);
                        return firstRow;
                    }()};
                    drawTogether(communicator, stripes, picture, stripe, frame, background);
                    if (communicator.isRoot()) expectFrame(picture, frame, background);
                }
        });
}

TEST(PictureGather, BackgroundIsNotSent)
{
    runRanks(2, [](Communicator& communicator) {
        Tile picture, stripe;
        const Stripes stripes = equalStripes(kHeight, 2);
        drawTogether(communicator, stripes, picture, stripe, 7, kWhite);  // In rows 7, 8 and 9 of 6 to 11.
        if (communicator.rank() == 1) {
            EXPECT_EQ(communicator.sent(), (Traffic{12 + 3 * kWidth * 4, 2}));
        }
        const Traffic before = communicator.sent();
        drawTogether(communicator, stripes, picture, stripe, 0, kWhite);  // In none of them.
        if (communicator.rank() == 1) {
            EXPECT_EQ(communicator.sent().bytes - before.bytes, 12);
        }
    });
}

TEST(PictureGather, WhatSomebodyElsePaintedIsSentWhole)
{
    runRanks(2, [](Communicator& communicator) {
        BusyClock busy;
        const Stripes stripes = equalStripes(kHeight, 2);
        Tile tile;
        tile.resize(communicator.isRoot() ? Extent{0, 0, kWidth, kHeight} : stripes.extent(1, kWidth));
        std::fill(tile.rgba.begin(), tile.rgba.end(), std::uint8_t(10 + communicator.rank()));
        if (!communicator.isRoot()) {
            sendPainted(communicator, tile);
            return;
        }
        receivePainted(communicator, stripes, tile, busy);
        EXPECT_EQ(tile.row(5)[3], 10);
        EXPECT_EQ(tile.row(6)[0], 11);
        EXPECT_EQ(tile.row(11)[4 * kWidth - 1], 11);
    });
}

}  // namespace
}  // namespace aeolic
