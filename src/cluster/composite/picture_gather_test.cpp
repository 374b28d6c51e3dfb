#include "cluster/composite/picture_gather.h"

#include <gtest/gtest.h>

#include "ranks/thread_communicator.h"

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

/// Shades as the processor's backend does: background beside the block alone.
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

void expectFrame(const Picture& picture, int frame, const Color& background)
{
    const auto channels = std::size_t(picture.channels);
    ASSERT_EQ(channels, background == kWhite ? 3u : 4u);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Color expected = colorAt(x, y, frame, background);
            EXPECT_TRUE(std::equal(expected.begin(), expected.begin() + picture.channels,
                                   picture.pixels.data() + channels * std::size_t(y * kWidth + x)))
                << x << ' ' << y << " in frame " << frame;
        }
}

/// A rank's memory from frame to frame.
struct Memory {
    Tile stripe;
    PaintedPixels sent;
    std::vector<PaintedPixels> others;
};

void exchange(Communicator& communicator, const Stripes& stripes, Memory& memory)
{
    if (communicator.isRoot())
        receivePainted(communicator, stripes, kWidth, memory.others);
    else
        sendPainted(communicator, memory.stripe, memory.sent);
}

void drawTogether(Communicator& communicator, const Stripes& stripes, Memory& memory, int frame,
                  const Color& background)
{
    const Extent own = stripes.extent(communicator.rank(), kWidth);
    memory.stripe.resize(own);
    draw(memory.stripe, own, frame, background);
    exchange(communicator, stripes, memory);
}

Picture wholeOf(const Memory& root)
{
    Picture picture{kWidth, kHeight, channelsOn(root.stripe.background), {}};
    picture.pixels.assign(std::size_t(kWidth * kHeight * picture.channels), 99);
    layOut(root.stripe, picture);
    for (const PaintedPixels& rows : root.others) layOut(rows, picture);
    return picture;
}

TEST(PictureGather, NothingIsLeftOfFramesBefore)
{
    for (const int ranks : {1, 2, 3, 5})
        runRanks(ranks, [&](Communicator& communicator) {
            Memory memory;
            for (const Color& background : {kWhite, kClear})
                for (int frame = 0; frame < 14; ++frame) {
                    const Stripes stripes = frame % 2 ? equalStripes(kHeight, ranks) : Stripes{[&] {
                        std::vector<int> firstRow(std::size_t(ranks), std::min(frame, kHeight));  // Some are empty.
                        firstRow.front() = 0;
                        firstRow.push_back(kHeight);
                        return firstRow;
                    }()};
                    drawTogether(communicator, stripes, memory, frame, background);
                    if (communicator.isRoot()) expectFrame(wholeOf(memory), frame, background);
                }
        });
}

TEST(PictureGather, BackgroundAndOpaqueAlphaAreNotSent)
{
    runRanks(2, [](Communicator& communicator) {
        Memory memory;
        const Stripes stripes = equalStripes(kHeight, 2);
        constexpr std::int64_t columns = 4 + 6 * 8;
        const auto sentFor = [&](int frame, const Color& background) {
            const Traffic before = communicator.sent();
            drawTogether(communicator, stripes, memory, frame, background);
            return Traffic{communicator.sent().bytes - before.bytes, communicator.sent().messages - before.messages};
        };
        const Traffic opaque = sentFor(7, kWhite);  // In rows 7, 8 and 9 of 6 to 11, three pixels each.
        const Traffic nothing = sentFor(0, kWhite), alpha = sentFor(7, kClear);
        if (communicator.isRoot()) return;
        EXPECT_EQ(opaque, (Traffic{columns + 9 * 3, 1}));
        EXPECT_EQ(nothing, (Traffic{columns, 1}));
        EXPECT_EQ(alpha, (Traffic{columns + 9 * 4, 1}));
    });
}

TEST(PictureGather, WhatSomebodyElsePaintedIsSentWhole)
{
    runRanks(2, [](Communicator& communicator) {
        Memory memory;
        const Stripes stripes = equalStripes(kHeight, 2);
        memory.stripe.resize(stripes.extent(communicator.rank(), kWidth));
        std::fill(memory.stripe.rgba.begin(), memory.stripe.rgba.end(), std::uint8_t(10 + communicator.rank()));
        exchange(communicator, stripes, memory);
        if (!communicator.isRoot()) return;
        const Picture picture = wholeOf(memory);
        EXPECT_EQ(picture.pixels[6 * kWidth * 4 - 1], 10);
        EXPECT_EQ(picture.pixels[6 * kWidth * 4], 11);
        EXPECT_EQ(picture.pixels.back(), 11);
    });
}

TEST(PictureGather, RowsThatAreNotTheSendersOwnAreNamed)
{
    runRanks(2, [](Communicator& communicator) {
        Memory memory;
        const Stripes stripes = equalStripes(kHeight, 2);
        memory.stripe.resize({0, communicator.isRoot() ? 0 : 5, kWidth, communicator.isRoot() ? 6 : 12});
        if (!communicator.isRoot()) {
            const PaintedPixels none;
            communicator.gather(std::as_bytes(std::span(none.bytes)));
            return;
        }
        try {
            exchange(communicator, stripes, memory);
            ADD_FAILURE() << "taken for rows";
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(std::string(error.what()), "rank 0: the picture: rank 1 sends rows that are not its own");
        }
    });
}

}  // namespace
}  // namespace aeolic
