/// What a server sends to a client: frames, tiles of every codec, ends. Checksums are put right, so that what is behind
/// them is reached.
#include "records.h"
#include "stream/client/frame_assembler.h"
#include "stream/codec/codec.h"

namespace aeolic::stream::fuzz {
namespace {

/// The message as it would be sent, with the length and, of a tile, the checksum put right.
ByteVector finished(MessageType type, ByteView payload)
{
    ByteVector message = beginMessage(type);
    message.insert(message.end(), payload.begin(), payload.end());
    if (type == MessageType::tile && payload.size() >= kTileHeaderBytes) {
        const std::uint32_t crc = crc32(payload.subspan(kTileHeaderBytes));
        for (std::size_t i = 0; i < 4; ++i)
            message[kHeaderBytes + kTileHeaderBytes - 4 + i] = std::uint8_t(crc >> (8 * i));
    }
    return *endMessage(std::move(message));
}

/// Frame 1 with one tile as a rank packs it, of which the record damages bytes: what a mutation would hardly reach, as
/// it does not know how pictures are packed. Codec, width, rows, channels; then where and how each byte is changed.
void takeDamaged(FrameAssembler& assembler, ByteView record)
{
    if (record.size() < 4) return;
    constexpr Codec codecs[] = {Codec::raw, Codec::jpeg, Codec::png, Codec::lz4};
    const Codec codec = codecs[record[0] % 4];
    const int width = 1 + record[1] % 64, rows = 1 + record[2] % 64;
    const int channels = codec == Codec::jpeg ? 3 : 3 + record[3] % 2;
    ByteVector pixels(std::size_t(width) * std::size_t(rows) * std::size_t(channels));
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = std::uint8_t(i * 7 + i / 50);
    ByteVector payload;
    putTileHeader(payload,
                  {1, 0, std::uint32_t(rows), std::uint32_t(width), 0, std::uint8_t(codec), std::uint8_t(channels), 0});
    encode(codec, {pixels.data(), width, rows, channels}, 1 + record[3] % 100, payload);
    record = record.subspan(4);
    const bool whole = record.size() < 3;
    for (; record.size() >= 3; record = record.subspan(3))
        payload[kTileHeaderBytes + std::size_t(record[0] | record[1] << 8) % (payload.size() - kTileHeaderBytes)] ^=
            record[2];
    const auto take = [&](const ByteVector& message) { return assembler.take(parseMessage(message, Sender::gateway)); };
    take(*frameMessage({1, 1, 1, std::uint32_t(width), std::uint32_t(rows), std::uint32_t(width), true}));
    take(finished(MessageType::tile, payload));
    const auto frame = take(*frameEndMessage(1, "{}"));
    require(frame.has_value());
    if (whole && codec != Codec::jpeg) require(frame->picture.pixels == pixels);
}

ByteVector messageOf(const Record& record)
{
    constexpr MessageType types[] = {MessageType::frame, MessageType::tile, MessageType::frameEnd};
    if (record.what % 5 == 0) return ByteVector(record.bytes.begin(), record.bytes.end());
    return finished(types[record.what % 5 - 1], record.bytes);
}

}  // namespace
}  // namespace aeolic::stream::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace aeolic::stream;
    using namespace aeolic::stream::fuzz;
    ByteView input(data, size);
    FrameAssembler assembler;
    assembler.asked(1024, 1024);
    Record record;
    for (int count = 0; count < 64 && takeRecord(input, record); ++count) {
        try {
            if (record.what % 5 == 4) {
                takeDamaged(assembler, record.bytes);
                continue;
            }
            const ByteVector bytes = messageOf(record);
            const MessageView message = parseMessage(bytes, Sender::gateway);
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
