#include "stream/job/stripe_sender.h"

#include <atomic>

#include "base/parallel.h"
#include "stream/message.h"

namespace aeolic::stream {
namespace {

// Rows of a band: whole MCUs of any JPEG, enough bands for all cores, and few enough that each compresses well.
constexpr int kBandRows = 64;

// A tile has a limit of bytes; a picture has none.
int bandRows(const Picture& rows)
{
    const std::size_t rowBytes = std::size_t(rows.width) * std::size_t(rows.channels);
    return int(std::clamp<std::size_t>((std::size_t{32} << 20) / rowBytes, 1, kBandRows));
}

WireMessage tileMessage(const DrawnFrame& picture, const DrawRequest& draw, int rank, int begin, int end)
{
    const std::size_t rowBytes = std::size_t(picture.width) * std::size_t(picture.channels);
    ByteVector bytes = beginMessage(MessageType::tile, kTileHeaderBytes + std::size_t(end - begin) * rowBytes / 4);
    TileHeader header{draw.frame,
                      std::uint32_t(picture.firstRow + begin),
                      std::uint32_t(end - begin),
                      std::uint32_t(picture.width),
                      std::uint16_t(rank),
                      std::uint8_t(draw.codec),
                      std::uint8_t(picture.channels),
                      0};
    putTileHeader(bytes, header);
    encode(draw.codec,
           {picture.pixels.data() + std::size_t(begin) * rowBytes, picture.width, end - begin, picture.channels},
           draw.quality, bytes);
    const std::uint32_t crc = crc32(ByteView(bytes).subspan(kHeaderBytes + kTileHeaderBytes));
    for (std::size_t i = 0; i < 4; ++i) bytes[kHeaderBytes + kTileHeaderBytes - 4 + i] = std::uint8_t(crc >> (8 * i));
    return endMessage(std::move(bytes));
}

}  // namespace

std::size_t sendStripe(const DrawnFrame& stripe, const DrawRequest& draw, int rank,
                       const std::function<void(WireMessage)>& send)
{
    const int rows = stripe.height;
    if (rows == 0) return 0;
    const int band = bandRows(stripe);
    std::atomic<std::size_t> bytes{0};
    parallelFor(std::size_t((rows + band - 1) / band), [&](std::size_t i) {
        const int begin = int(i) * band;
        WireMessage message = tileMessage(stripe, draw, rank, begin, std::min(begin + band, rows));
        bytes += message->size();
        send(std::move(message));
    });
    return bytes;
}

}  // namespace aeolic::stream
