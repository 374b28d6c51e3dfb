#include "stream/client/frame_assembler.h"

#include <gtest/gtest.h>

#include <functional>

#include "stream/codec/codec_testing.h"

namespace aeolic::stream {
namespace {

/// A tile with these rows of `picture`, as a rank sends it.
WireMessage tileOf(const test::Picture& picture, std::uint32_t frame, int firstRow, int rows,
                   const std::function<void(TileHeader&)>& change = {}, Codec codec = Codec::png)
{
    const std::size_t rowBytes = std::size_t(picture.width) * std::size_t(picture.channels);
    ByteVector pixels;
    encode(codec, {picture.bytes.data() + std::size_t(firstRow) * rowBytes, picture.width, rows, picture.channels}, 80,
           pixels);
    TileHeader header{frame,
                      std::uint32_t(firstRow),
                      std::uint32_t(rows),
                      std::uint32_t(picture.width),
                      0,
                      std::uint8_t(codec),
                      std::uint8_t(picture.channels),
                      crc32(pixels)};
    if (change) change(header);
    ByteVector message = beginMessage(MessageType::tile);
    putTileHeader(message, header);
    message.insert(message.end(), pixels.begin(), pixels.end());
    return endMessage(std::move(message));
}

class FrameAssembly : public testing::Test {
protected:
    FrameAssembly() { assembler.asked(picture.width, picture.rows); }
    std::optional<StreamFrame> take(const WireMessage& message)
    {
        return assembler.take(parseMessage(*message, Sender::gateway));
    }
    void begin(std::uint32_t frame)
    {
        EXPECT_FALSE(take(frameMessage({frame, 2, 3, std::uint32_t(picture.width), std::uint32_t(picture.rows),
                                        std::uint32_t(picture.width) * 2, true})));
    }
    std::optional<StreamFrame> end(std::uint32_t frame) { return take(frameEndMessage(frame, R"({"bytes":1})")); }

    test::Picture picture = test::streaks(31, 20, 3);
    FrameAssembler assembler;
};

TEST_F(FrameAssembly, TilesInAnyOrderAndOfAnyCodec)
{
    begin(9);
    EXPECT_FALSE(take(tileOf(picture, 9, 13, 7)));
    EXPECT_FALSE(take(tileOf(picture, 9, 0, 1, {}, Codec::raw)));
    EXPECT_FALSE(take(tileOf(picture, 9, 1, 12, {}, Codec::lz4)));
    const auto frame = end(9);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->picture.pixels, picture.bytes);
    EXPECT_EQ(frame->picture.width, 31);
    EXPECT_EQ(frame->picture.height, 20);
    EXPECT_EQ(frame->picture.channels, 3);
    EXPECT_EQ(frame->frame, 9u);
    EXPECT_EQ(frame->viewer, 2u);
    EXPECT_EQ(frame->view, 3u);
    EXPECT_EQ(frame->askedWidth, 62);
    EXPECT_TRUE(frame->lossless);
    EXPECT_EQ(frame->stats, R"({"bytes":1})");
}

TEST_F(FrameAssembly, TransparentPictures)
{
    picture = test::streaks(7, 20, 4);
    begin(1);
    take(tileOf(picture, 1, 0, 20));
    const auto frame = end(1);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->picture.channels, 4);
    EXPECT_EQ(frame->picture.pixels, picture.bytes);
}

TEST_F(FrameAssembly, ANewFrameReplacesOneThatNeverEnded)
{
    begin(1);
    take(tileOf(picture, 1, 0, 10));
    begin(2);
    take(tileOf(picture, 2, 0, 20));
    EXPECT_FALSE(end(1)) << "the end of a frame that was left";
    const auto frame = end(2);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->picture.pixels, picture.bytes);
    EXPECT_FALSE(end(2)) << "only once";
}

TEST_F(FrameAssembly, TilesOfUnknownFramesAreLeftAside)
{
    EXPECT_FALSE(take(tileOf(picture, 1, 0, 20)));
    EXPECT_FALSE(end(1));
    begin(2);
    EXPECT_FALSE(take(tileOf(picture, 1, 0, 20)));
    take(tileOf(picture, 2, 0, 20));
    EXPECT_TRUE(end(2));
}

TEST_F(FrameAssembly, OverlapsAndRowsTwice)
{
    begin(1);
    take(tileOf(picture, 1, 0, 10));
    EXPECT_THROW(take(tileOf(picture, 1, 9, 5)), ProtocolError);
    begin(2);
    take(tileOf(picture, 2, 0, 20));
    EXPECT_THROW(take(tileOf(picture, 2, 0, 20)), ProtocolError);
}

TEST_F(FrameAssembly, AnEndBeforeAllRowsAreHere)
{
    begin(1);
    EXPECT_THROW(end(1), ProtocolError);
    begin(2);
    take(tileOf(picture, 2, 0, 19));
    EXPECT_THROW(end(2), ProtocolError);
}

TEST_F(FrameAssembly, TilesThatAreNotOfThisFrame)
{
    const auto refused = [&](const char* what, const std::function<void(TileHeader&)>& change) {
        begin(1);
        EXPECT_THROW(take(tileOf(picture, 1, 0, 20, change)), ProtocolError) << what;
    };
    refused("a wrong checksum", [](TileHeader& tile) { tile.crc ^= 1; });
    refused("too wide", [](TileHeader& tile) { ++tile.width; });
    refused("too narrow", [](TileHeader& tile) { --tile.width; });
    refused("beyond the end", [](TileHeader& tile) { tile.firstRow = 1; });
    refused("far beyond the end", [](TileHeader& tile) { tile.firstRow = 32767, tile.rows = 32768; });
    refused("fewer rows than encoded", [](TileHeader& tile) { tile.rows = 19; });
    refused("other channels than encoded", [](TileHeader& tile) { tile.channels = 4; });
    refused("another codec", [](TileHeader& tile) { tile.codec = 3; });
    refused("no codec", [](TileHeader& tile) { tile.codec = 200; });
}

TEST_F(FrameAssembly, FramesLargerThanWhatWasAskedFor)
{
    const auto frame = [&](FrameAssembler& of, std::uint32_t width, std::uint32_t height) {
        of.take(parseMessage(*frameMessage({1, 2, 3, width, height, width, true}), Sender::gateway));
    };
    EXPECT_NO_THROW(frame(assembler, 31, 20));
    EXPECT_NO_THROW(frame(assembler, 1, 1));
    EXPECT_THROW(frame(assembler, 32, 20), ProtocolError);
    EXPECT_THROW(frame(assembler, 31, 21), ProtocolError);
    assembler.asked(10, 40);
    EXPECT_NO_THROW(frame(assembler, 31, 20)) << "it may be on its way still";
    EXPECT_NO_THROW(frame(assembler, 10, 40));
    assembler.asked(32768, 32768);
    EXPECT_NO_THROW(frame(assembler, 16384, 16384));
    EXPECT_THROW(frame(assembler, 32768, 8193), ProtocolError);
    EXPECT_THROW(frame(assembler, 32768, 32768), ProtocolError) << "whatever was asked for";
    FrameAssembler fresh;
    EXPECT_THROW(frame(fresh, 1, 1), ProtocolError) << "none was asked for";
}

TEST_F(FrameAssembly, TilesOfDifferentKindsInOneFrame)
{
    begin(1);
    take(tileOf(picture, 1, 0, 10));
    const test::Picture other = test::streaks(31, 20, 4);
    EXPECT_THROW(take(tileOf(other, 1, 10, 10)), ProtocolError);
}

TEST_F(FrameAssembly, ADamagedTileBehindAGoodChecksum)
{
    begin(1);
    const WireMessage good = tileOf(picture, 1, 0, 20);
    ByteVector bad(*good);
    bad.resize(bad.size() - 20);  // Half a PNG file is left.
    const std::uint32_t crc = crc32(ByteView(bad).subspan(kHeaderBytes + kTileHeaderBytes));
    for (int i = 0; i < 4; ++i) bad[kHeaderBytes + kTileHeaderBytes - 4 + std::size_t(i)] = std::uint8_t(crc >> 8 * i);
    EXPECT_THROW(take(endMessage(std::move(bad))),
                 ProtocolError);  // Every byte arrived as it was sent: the checksum fits.
}

}  // namespace
}  // namespace aeolic::stream
