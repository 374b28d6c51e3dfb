#include "stream/message.h"

namespace aeolic::stream {
namespace {

constexpr std::size_t kKiB = 1024, kMiB = 1024 * kKiB;

constexpr unsigned bit(Sender sender)
{
    return 1u << unsigned(sender);
}

struct TypeRule {
    MessageType type;
    unsigned senders;
    std::size_t limit;
};

constexpr TypeRule kRules[] = {
    {MessageType::hello, bit(Sender::viewer), 4 * kKiB},
    {MessageType::view, bit(Sender::viewer), 16 * kKiB},
    {MessageType::shown, bit(Sender::viewer), 4},
    {MessageType::change, bit(Sender::viewer), 16 * kKiB},
    {MessageType::follow, bit(Sender::viewer), 4},
    {MessageType::start, bit(Sender::viewer), 0},
    {MessageType::pick, bit(Sender::viewer), 16 * kKiB},
    {MessageType::welcome, bit(Sender::gateway), kMiB},
    {MessageType::state, bit(Sender::gateway), 64 * kKiB},
    {MessageType::scene, bit(Sender::gateway) | bit(Sender::rank), 4 * kMiB},
    {MessageType::frame, bit(Sender::gateway), 28},
    {MessageType::tile, bit(Sender::gateway) | bit(Sender::rank), 64 * kMiB},
    {MessageType::frameEnd, bit(Sender::gateway) | bit(Sender::rank), kMiB},
    {MessageType::notice, bit(Sender::gateway) | bit(Sender::rank), 64 * kKiB},
    {MessageType::offer, bit(Sender::gateway), kMiB},
    {MessageType::changed, bit(Sender::gateway), 4},
    {MessageType::picked, bit(Sender::gateway) | bit(Sender::rank), 64 * kKiB},
    {MessageType::join, bit(Sender::rank), 4 * kKiB},
    {MessageType::load, bit(Sender::gatewayToRank), kMiB},
    {MessageType::draw, bit(Sender::gatewayToRank), 64 * kKiB},
    {MessageType::progress, bit(Sender::rank), 4 * kKiB},
    {MessageType::quit, bit(Sender::gatewayToRank), 0},
    {MessageType::invite, bit(Sender::gatewayToRank), 4 * kKiB},
    {MessageType::ping, bit(Sender::gatewayToRank), 0},
    {MessageType::pong, bit(Sender::rank), 0},
    {MessageType::knock, bit(Sender::rank), kKiB},
    {MessageType::challenge, bit(Sender::gatewayToRank), kKiB},
    {MessageType::renewed, bit(Sender::rank), 0},
    {MessageType::probe, bit(Sender::gatewayToRank), 64 * kKiB},
};

constexpr std::uint32_t kLargestSide = 32768;

}  // namespace

std::size_t payloadLimit(std::uint8_t type, Sender sender)
{
    for (const TypeRule& rule : kRules)
        if (std::uint8_t(rule.type) == type && (rule.senders & bit(sender))) return rule.limit;
    throw ProtocolError("unknown message type");
}

ByteVector beginMessage(MessageType type, std::size_t expectedPayload)
{
    ByteVector bytes;
    bytes.reserve(kHeaderBytes + expectedPayload);
    bytes = {kMagic, kProtocolVersion, std::uint8_t(type), 0, 0, 0, 0, 0};
    return bytes;
}

WireMessage endMessage(ByteVector&& bytes)
{
    const std::size_t payload = bytes.size() - kHeaderBytes;
    for (std::size_t i = 0; i < 4; ++i) bytes[4 + i] = std::uint8_t(payload >> (8 * i));
    return std::make_shared<const ByteVector>(std::move(bytes));
}

WireMessage jsonMessage(MessageType type, std::string_view json)
{
    ByteVector bytes = beginMessage(type, json.size());
    putText(bytes, json);
    return endMessage(std::move(bytes));
}

WireMessage numberMessage(MessageType type, std::uint32_t number)
{
    ByteVector bytes = beginMessage(type, 4);
    putU32(bytes, number);
    return endMessage(std::move(bytes));
}

WireMessage emptyMessage(MessageType type)
{
    return endMessage(beginMessage(type));
}

MessageHeader parseHeader(ByteView header, Sender sender)
{
    WireReader reader(header);
    if (reader.u8() != kMagic) throw ProtocolError("not an Aeolic message");
    if (reader.u8() != kProtocolVersion) throw ProtocolError("another version of the protocol");
    const std::uint8_t type = reader.u8();
    if (reader.u8() != 0) throw ProtocolError("a reserved byte is not 0");
    const std::uint32_t length = reader.u32();
    if (length > payloadLimit(type, sender)) throw ProtocolError("a message over its limit");
    return {MessageType(type), length};
}

MessageView parseMessage(ByteView bytes, Sender sender)
{
    const MessageHeader header = parseHeader(bytes, sender);
    const ByteView payload = bytes.subspan(kHeaderBytes);
    if (payload.size() != header.payloadBytes) throw ProtocolError("a message's length is not its payload's");
    return {header.type, payload};
}

std::optional<std::uint32_t> frameOf(ByteView message)
{
    const auto type = MessageType(message[2]);
    if (type != MessageType::frame && type != MessageType::tile && type != MessageType::frameEnd) return std::nullopt;
    return WireReader(message.subspan(kHeaderBytes)).u32();
}

WireMessage frameMessage(const FrameHeader& header)
{
    ByteVector bytes = beginMessage(MessageType::frame, 28);
    for (const std::uint32_t number :
         {header.frame, header.viewer, header.view, header.width, header.height, header.askedWidth})
        putU32(bytes, number);
    putU32(bytes, header.lossless ? 1 : 0);
    return endMessage(std::move(bytes));
}

FrameHeader parseFrame(ByteView payload)
{
    WireReader reader(payload);
    FrameHeader header;
    for (std::uint32_t* number :
         {&header.frame, &header.viewer, &header.view, &header.width, &header.height, &header.askedWidth})
        *number = reader.u32();
    const std::uint32_t flags = reader.u32();
    reader.expectEnd();
    if (flags > 1) throw ProtocolError("unknown flags");
    header.lossless = flags == 1;
    if (header.width == 0 || header.height == 0 || header.width > kLargestSide || header.height > kLargestSide ||
        header.askedWidth < header.width || header.askedWidth > kLargestSide)
        throw ProtocolError("a frame of an impossible size");
    return header;
}

void putTileHeader(ByteVector& out, const TileHeader& header)
{
    for (const std::uint32_t number : {header.frame, header.firstRow, header.rows, header.width}) putU32(out, number);
    putU16(out, header.rank);
    out.push_back(header.codec);
    out.push_back(header.channels);
    putU32(out, header.crc);
}

TileHeader parseTile(ByteView payload, ByteView& encoded)
{
    WireReader reader(payload);
    TileHeader header;
    for (std::uint32_t* number : {&header.frame, &header.firstRow, &header.rows, &header.width}) *number = reader.u32();
    header.rank = reader.u16();
    header.codec = reader.u8();
    header.channels = reader.u8();
    header.crc = reader.u32();
    encoded = reader.rest();
    const bool sizes = header.rows > 0 && header.rows <= kLargestSide && header.width > 0 &&
                       header.width <= kLargestSide && header.firstRow < kLargestSide;
    if (!sizes || (header.channels != 3 && header.channels != 4)) throw ProtocolError("a tile of an impossible size");
    return header;
}

WireMessage frameEndMessage(std::uint32_t frame, std::string_view json)
{
    ByteVector bytes = beginMessage(MessageType::frameEnd, 4 + json.size());
    putU32(bytes, frame);
    putText(bytes, json);
    return endMessage(std::move(bytes));
}

}  // namespace aeolic::stream
