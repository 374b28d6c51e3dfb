/// What a server sends to a client: frames, tiles of every codec, ends. Checksums are put right, so that what is behind
/// them is reached.
#include "records.h"
#include "stream/client/frame_assembler.h"
#include "stream/codec.h"

namespace aeolic::stream::fuzz {
namespace {

// A client grants memory for pictures that it asked for; this one asked for none that is larger.
constexpr std::size_t kMostPixels = std::size_t{1} << 20;

bool isTooLarge(ByteView payload)
{
    try {
        const FrameHeader frame = parseFrame(payload);
        return std::size_t(frame.width) * frame.height > kMostPixels;
    } catch (const ProtocolError&) {
        return false;
    }
}

ByteVector messageOf(const Record& record)
{
    if (record.what % 4 == 0) return ByteVector(record.bytes.begin(), record.bytes.end());
    constexpr MessageType types[] = {MessageType::frame, MessageType::tile, MessageType::frameEnd};
    const MessageType type = types[record.what % 4 - 1];
    ByteVector message = beginMessage(type);
    message.insert(message.end(), record.bytes.begin(), record.bytes.end());
    if (type == MessageType::tile && record.bytes.size() >= kTileHeaderBytes) {
        const std::uint32_t crc = crc32(record.bytes.subspan(kTileHeaderBytes));
        for (std::size_t i = 0; i < 4; ++i)
            message[kHeaderBytes + kTileHeaderBytes - 4 + i] = std::uint8_t(crc >> (8 * i));
    }
    return *endMessage(std::move(message));
}

}  // namespace
}  // namespace aeolic::stream::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace aeolic::stream;
    using namespace aeolic::stream::fuzz;
    ByteView input(data, size);
    FrameAssembler assembler;
    Record record;
    for (int count = 0; count < 64 && takeRecord(input, record); ++count) {
        const ByteVector bytes = messageOf(record);
        try {
            const MessageView message = parseMessage(bytes, Sender::gateway);
            if (message.type == MessageType::frame && isTooLarge(message.payload)) continue;
            if (const auto frame = assembler.take(message)) {
                const aeolic::Picture& picture = frame->picture;
                require(picture.pixels.size() ==
                        std::size_t(picture.width) * std::size_t(picture.height) * std::size_t(picture.channels));
            }
        } catch (const ProtocolError&) {
            return 0;  // The client hangs up.
        }
    }
    return 0;
}
