#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "stream/wire.h"

namespace aeolic::stream {

/// The types of the first table in docs/protocol.md, which describes the whole protocol.
enum class MessageType : std::uint8_t {
    hello = 0x01,
    view = 0x02,
    shown = 0x03,
    change = 0x04,
    follow = 0x05,
    start = 0x06,
    pick = 0x07,
    welcome = 0x41,
    state = 0x42,
    scene = 0x43,
    frame = 0x44,
    tile = 0x45,
    frameEnd = 0x46,
    notice = 0x47,
    offer = 0x48,
    changed = 0x49,
    picked = 0x4A,
    join = 0x81,
    load = 0x82,
    draw = 0x83,
    progress = 0x84,
    quit = 0x85,
    invite = 0x86,
    ping = 0x87,
    pong = 0x88,
    knock = 0x89,
    challenge = 0x8A,
    renewed = 0x8B,
    probe = 0x8C,
};

/// Who may send what.
enum class Sender { viewer, gateway, rank, gatewayToRank };

inline constexpr std::uint8_t kMagic = 0xAE, kProtocolVersion = 1;
inline constexpr std::size_t kHeaderBytes = 8;

/// Largest payload of a type; 0 for Start, Quit, Ping, Pong and Renewed. Throws ProtocolError for a type that `sender`
/// does not send.
std::size_t payloadLimit(std::uint8_t type, Sender sender);

/// A message as it goes over the wire, shared among all it is sent to.
using WireMessage = std::shared_ptr<const ByteVector>;

/// One message taken apart; the payload stays where it is.
struct MessageView {
    MessageType type;
    ByteView payload;
};

/// Starts a message; endMessage() fills in the length. Between them the payload is appended.
ByteVector beginMessage(MessageType type, std::size_t expectedPayload = 0);
WireMessage endMessage(ByteVector&& bytes);

WireMessage jsonMessage(MessageType type, std::string_view json);
WireMessage numberMessage(MessageType type, std::uint32_t number);
WireMessage emptyMessage(MessageType type);

/// A whole WebSocket message. Throws ProtocolError for anything but one message that `sender` may send.
MessageView parseMessage(ByteView bytes, Sender sender);

/// The frame that one of this process's own messages belongs to. The message is a Frame, Tile or FrameEnd.
std::optional<std::uint32_t> frameOf(ByteView message);

/// What a header on a link announces: a type, and payload bytes within the limit. Throws ProtocolError.
struct MessageHeader {
    MessageType type;
    std::size_t payloadBytes;
};
MessageHeader parseHeader(ByteView header, Sender sender);

/// The payload of a message of this type whose header was checked.
struct FrameHeader {
    std::uint32_t frame = 0, viewer = 0, view = 0;
    std::uint32_t width = 0, height = 0, askedWidth = 0;
    bool lossless = false;  ///< The picture at rest: lossless, and of full size.
    bool operator==(const FrameHeader&) const = default;
};
WireMessage frameMessage(const FrameHeader& header);
FrameHeader parseFrame(ByteView payload);

struct TileHeader {
    std::uint32_t frame = 0, firstRow = 0, rows = 0, width = 0;
    std::uint16_t rank = 0;
    std::uint8_t codec = 0, channels = 3;
    std::uint32_t crc = 0;
    bool operator==(const TileHeader&) const = default;
};
inline constexpr std::size_t kTileHeaderBytes = 24;
void putTileHeader(ByteVector& out, const TileHeader& header);
/// Reads a tile's header, and where its encoded bytes are. Checks channels and sizes, but not the checksum.
TileHeader parseTile(ByteView payload, ByteView& encoded);

WireMessage frameEndMessage(std::uint32_t frame, std::string_view json);

/// The codes of RFC 6455 that a server closes a WebSocket with.
struct Goodbye {
    static constexpr std::uint16_t goingAway = 1001, protocolError = 1002, policyError = 1008, tooBig = 1009,
                                   internalError = 1011, tryAgainLater = 1013;
};

}  // namespace aeolic::stream
