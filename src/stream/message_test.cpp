#include "stream/message.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

/// The bytes of docs/protocol.md. A change that moves one of them makes another version of the protocol.
namespace aeolic::stream {
namespace {

ByteVector bytes(std::initializer_list<int> values)
{
    return ByteVector(values.begin(), values.end());
}

ByteVector with(ByteVector front, std::string_view text)
{
    putText(front, text);
    return front;
}

struct TypeRow {
    MessageType type;
    int number;
    std::size_t limit;
    std::vector<Sender> senders;
};

constexpr std::size_t KiB = 1024, MiB = 1024 * KiB;
constexpr std::array kSenders{Sender::viewer, Sender::gateway, Sender::rank, Sender::gatewayToRank};

// The table of docs/protocol.md, written by hand once more.
const std::vector<TypeRow> kTable{
    {MessageType::hello, 0x01, 4 * KiB, {Sender::viewer}},
    {MessageType::view, 0x02, 16 * KiB, {Sender::viewer}},
    {MessageType::shown, 0x03, 4, {Sender::viewer}},
    {MessageType::change, 0x04, 16 * KiB, {Sender::viewer}},
    {MessageType::follow, 0x05, 4, {Sender::viewer}},
    {MessageType::start, 0x06, 0, {Sender::viewer}},
    {MessageType::pick, 0x07, 16 * KiB, {Sender::viewer}},
    {MessageType::welcome, 0x41, MiB, {Sender::gateway}},
    {MessageType::state, 0x42, 64 * KiB, {Sender::gateway}},
    {MessageType::scene, 0x43, 4 * MiB, {Sender::gateway, Sender::rank}},
    {MessageType::frame, 0x44, 28, {Sender::gateway}},
    {MessageType::tile, 0x45, 64 * MiB, {Sender::gateway, Sender::rank}},
    {MessageType::frameEnd, 0x46, MiB, {Sender::gateway, Sender::rank}},
    {MessageType::notice, 0x47, 64 * KiB, {Sender::gateway, Sender::rank}},
    {MessageType::offer, 0x48, MiB, {Sender::gateway}},
    {MessageType::changed, 0x49, 4, {Sender::gateway}},
    {MessageType::picked, 0x4A, 64 * KiB, {Sender::gateway, Sender::rank}},
    {MessageType::join, 0x81, 4 * KiB, {Sender::rank}},
    {MessageType::knock, 0x89, KiB, {Sender::rank}},
    {MessageType::challenge, 0x8A, KiB, {Sender::gatewayToRank}},
    {MessageType::renewed, 0x8B, 0, {Sender::rank}},
    {MessageType::probe, 0x8C, 64 * KiB, {Sender::gatewayToRank}},
    {MessageType::load, 0x82, MiB, {Sender::gatewayToRank}},
    {MessageType::draw, 0x83, 64 * KiB, {Sender::gatewayToRank}},
    {MessageType::progress, 0x84, 4 * KiB, {Sender::rank}},
    {MessageType::quit, 0x85, 0, {Sender::gatewayToRank}},
    {MessageType::invite, 0x86, 4 * KiB, {Sender::gatewayToRank}},
    {MessageType::ping, 0x87, 0, {Sender::gatewayToRank}},
    {MessageType::pong, 0x88, 0, {Sender::rank}},
};

bool sends(const TypeRow& row, Sender sender)
{
    return std::find(row.senders.begin(), row.senders.end(), sender) != row.senders.end();
}

/// A header with that length field.
ByteVector header(int type, std::size_t length)
{
    return bytes({0xAE, 1, type, 0, int(length & 255), int(length >> 8 & 255), int(length >> 16 & 255),
                  int(length >> 24 & 255)});
}

TEST(MessageBytes, JsonTypesAreTheHeaderAndTheText)
{
    for (const TypeRow& row : kTable) {
        const ByteVector expected = with(header(row.number, 7), R"({"a":1})");
        EXPECT_EQ(*jsonMessage(row.type, R"({"a":1})"), expected) << row.number;
    }
    EXPECT_EQ(*jsonMessage(MessageType::hello, R"({"codecs":["png"]})"),
              with(bytes({0xAE, 1, 0x01, 0, 18, 0, 0, 0}), R"({"codecs":["png"]})"));
}

TEST(MessageBytes, LengthIsLittleEndian)
{
    const WireMessage message = jsonMessage(MessageType::load, std::string(0x012345, ' '));
    EXPECT_EQ(ByteVector(message->begin(), message->begin() + 8), bytes({0xAE, 1, 0x82, 0, 0x45, 0x23, 0x01, 0}));
    EXPECT_EQ(message->size(), 8u + 0x012345u);
}

TEST(MessageBytes, ShownFollowQuit)
{
    EXPECT_EQ(*numberMessage(MessageType::shown, 0x04030201), bytes({0xAE, 1, 0x03, 0, 4, 0, 0, 0, 1, 2, 3, 4}));
    EXPECT_EQ(*numberMessage(MessageType::follow, 0), bytes({0xAE, 1, 0x05, 0, 4, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(*emptyMessage(MessageType::quit), bytes({0xAE, 1, 0x85, 0, 0, 0, 0, 0}));
}

TEST(MessageBytes, Frame)
{
    const FrameHeader frame{0x04030201, 0x08070605, 0x0C0B0A09, 0x0190, 0x012C, 0x0320, true};
    const ByteVector expected = bytes({0xAE, 1, 0x44, 0, 28,   0, 0, 0,                    //
                                       1,    2, 3,    4, 5,    6, 7, 8, 9,    10, 11, 12,  //
                                       0x90, 1, 0,    0, 0x2C, 1, 0, 0, 0x20, 3,  0,  0,   //
                                       1,    0, 0,    0});
    EXPECT_EQ(*frameMessage(frame), expected);
    EXPECT_EQ(parseFrame(ByteView(expected).subspan(8)), frame);
    FrameHeader moving = frame;
    moving.lossless = false;
    EXPECT_EQ((*frameMessage(moving))[8 + 24], 0);
    EXPECT_EQ(parseFrame(ByteView(*frameMessage(moving)).subspan(8)), moving);
}

TEST(MessageBytes, Tile)
{
    const TileHeader tile{0x04030201, 64, 63, 0x0320, 0x0706, 3, 4, 0xDDCCBBAA};
    ByteVector message = beginMessage(MessageType::tile);
    putTileHeader(message, tile);
    putText(message, "pixels");
    const ByteVector expected = with(bytes({0xAE, 1, 0x45, 0, 30, 0, 0, 0,                       //
                                            1,    2, 3,    4, 64, 0, 0, 0, 63,   0,    0,    0,  //
                                            0x20, 3, 0,    0, 6,  7, 3, 4, 0xAA, 0xBB, 0xCC, 0xDD}),
                                     "pixels");
    EXPECT_EQ(*endMessage(std::move(message)), expected);
    ByteView encoded;
    EXPECT_EQ(parseTile(ByteView(expected).subspan(8), encoded), tile);
    EXPECT_EQ(std::string(encoded.begin(), encoded.end()), "pixels");
}

TEST(MessageBytes, FrameEnd)
{
    EXPECT_EQ(*frameEndMessage(0x0201, "{}"), with(bytes({0xAE, 1, 0x46, 0, 6, 0, 0, 0, 1, 2, 0, 0}), "{}"));
}

TEST(MessageLimits, AreThoseOfTheTable)
{
    for (const TypeRow& row : kTable)
        for (const Sender sender : kSenders) {
            SCOPED_TRACE(testing::Message() << "type " << row.number << " of sender " << int(sender));
            const ByteVector most = header(row.number, row.limit), tooMuch = header(row.number, row.limit + 1);
            EXPECT_THROW(parseHeader(tooMuch, sender), ProtocolError);
            if (!sends(row, sender)) {
                EXPECT_THROW(parseHeader(most, sender), ProtocolError);
                EXPECT_THROW(payloadLimit(std::uint8_t(row.number), sender), ProtocolError);
                continue;
            }
            EXPECT_EQ(parseHeader(most, sender).type, row.type);
            EXPECT_EQ(parseHeader(most, sender).payloadBytes, row.limit);
        }
}

TEST(MessageLimits, EveryOtherTypeIsRefusedFromEveryone)
{
    for (int number = 0; number < 256; ++number) {
        const bool known =
            std::any_of(kTable.begin(), kTable.end(), [&](const TypeRow& row) { return row.number == number; });
        if (known) continue;
        for (const Sender sender : kSenders)
            EXPECT_THROW(parseHeader(header(number, 0), sender), ProtocolError) << number;
    }
}

TEST(MessageRefusals, MagicVersionAndReservedByte)
{
    const ByteVector good = *numberMessage(MessageType::shown, 1);
    EXPECT_NO_THROW(parseMessage(good, Sender::viewer));
    for (const std::size_t at : {0, 1, 3})
        for (const int wrong : {0, 1, 2, 0xAF, 255}) {
            ByteVector bad = good;
            if (bad[at] == wrong) continue;
            bad[at] = std::uint8_t(wrong);
            EXPECT_THROW(parseMessage(bad, Sender::viewer), ProtocolError) << "byte " << at << " is " << wrong;
        }
}

TEST(MessageRefusals, EveryTruncationAndAnyByteTooMany)
{
    const ByteVector good = *jsonMessage(MessageType::view, R"({"view":1})");
    for (std::size_t length = 0; length < good.size(); ++length)
        EXPECT_THROW(parseMessage(ByteView(good).first(length), Sender::viewer), ProtocolError) << length;
    EXPECT_THROW(parseMessage(with(good, "}"), Sender::viewer), ProtocolError);
}

TEST(MessageRefusals, AFrameOfAnImpossibleSizeOrUnknownFlags)
{
    const auto payload = [](std::uint32_t width, std::uint32_t height, std::uint32_t asked, std::uint32_t flags) {
        ByteVector out;
        for (const std::uint32_t number : {1u, 2u, 3u, width, height, asked, flags}) putU32(out, number);
        return out;
    };
    EXPECT_NO_THROW(parseFrame(payload(32768, 32768, 32768, 0)));
    EXPECT_THROW(parseFrame(payload(0, 5, 5, 0)), ProtocolError);
    EXPECT_THROW(parseFrame(payload(5, 0, 5, 0)), ProtocolError);
    EXPECT_THROW(parseFrame(payload(32769, 5, 32769, 0)), ProtocolError);
    EXPECT_THROW(parseFrame(payload(5, 32769, 5, 0)), ProtocolError);
    EXPECT_THROW(parseFrame(payload(5, 5, 4, 0)), ProtocolError) << "larger than asked for";
    EXPECT_THROW(parseFrame(payload(5, 5, 0xFFFFFFFF, 0)), ProtocolError);
    EXPECT_THROW(parseFrame(payload(5, 5, 5, 2)), ProtocolError);
    EXPECT_THROW(parseFrame(ByteView(payload(5, 5, 5, 0)).first(27)), ProtocolError);
    EXPECT_THROW(parseFrame(with(payload(5, 5, 5, 0), "x")), ProtocolError);
}

TEST(MessageRefusals, ATileOfAnImpossibleSize)
{
    const auto parses = [](TileHeader tile) {
        ByteVector out;
        putTileHeader(out, tile);
        ByteView encoded;
        return parseTile(out, encoded);
    };
    const TileHeader good{1, 0, 32768, 32768, 0, 0, 3, 0};
    EXPECT_NO_THROW(parses(good));
    const auto refused = [&](auto change) {
        TileHeader bad = good;
        change(bad);
        EXPECT_THROW(parses(bad), ProtocolError);
    };
    refused([](TileHeader& tile) { tile.rows = 0; });
    refused([](TileHeader& tile) { tile.rows = 32769; });
    refused([](TileHeader& tile) { tile.width = 0; });
    refused([](TileHeader& tile) { tile.width = 32769; });
    refused([](TileHeader& tile) { tile.firstRow = 32768; });
    refused([](TileHeader& tile) { tile.firstRow = 0xFFFFFFFF; });
    for (const int channels : {0, 1, 2, 5, 255})
        refused([&](TileHeader& tile) { tile.channels = std::uint8_t(channels); });
    ByteVector shortOne;
    putTileHeader(shortOne, good);
    shortOne.pop_back();
    ByteView encoded;
    EXPECT_THROW(parseTile(shortOne, encoded), ProtocolError);
}

}  // namespace
}  // namespace aeolic::stream
