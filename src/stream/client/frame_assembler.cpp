#include "stream/client/frame_assembler.h"

#include <algorithm>

#include "stream/codec/codec.h"

namespace aeolic::stream {

std::optional<StreamFrame> FrameAssembler::take(const MessageView& message)
{
    if (message.type == MessageType::frame) {
        begin(parseFrame(message.payload));
    } else if (message.type == MessageType::tile) {
        addTile(message.payload);
    } else if (message.type == MessageType::frameEnd) {
        WireReader reader(message.payload);
        if (!header_ || reader.u32() != header_->frame) return std::nullopt;
        if (rowsMissing_ > 0) throw ProtocolError("a frame ended before its tiles were here");
        frame_.stats = reader.text();
        header_.reset();
        return std::move(frame_);
    }
    return std::nullopt;
}

void FrameAssembler::asked(int width, int height)
{
    mostColumns_ = std::max(mostColumns_, std::uint32_t(std::max(0, width)));
    mostRows_ = std::max(mostRows_, std::uint32_t(std::max(0, height)));
}

void FrameAssembler::begin(const FrameHeader& header)
{
    if (header.width > mostColumns_ || header.height > mostRows_ ||
        std::uint64_t(header.width) * header.height > kMostPixels)
        throw ProtocolError("a frame larger than was asked for");
    header_ = header;
    frame_ = {};
    frame_.frame = header.frame;
    frame_.view = header.view;
    frame_.viewer = header.viewer;
    frame_.askedWidth = int(header.askedWidth);
    frame_.lossless = header.lossless;
    frame_.picture.width = int(header.width);
    frame_.picture.height = int(header.height);
    rowsHere_.assign(header.height, false);
    rowsMissing_ = header.height;
}

void FrameAssembler::addTile(ByteView payload)
{
    ByteView encoded;
    const TileHeader tile = parseTile(payload, encoded);
    if (!header_ || tile.frame != header_->frame) return;
    Picture& picture = frame_.picture;
    if (tile.width != header_->width || tile.firstRow + tile.rows > header_->height)
        throw ProtocolError("a tile beyond its frame");
    if (crc32(encoded) != tile.crc) throw ProtocolError("a tile with a wrong checksum");
    if (picture.pixels.empty()) {
        picture.channels = tile.channels;
        picture.pixels.resize(std::size_t(picture.width) * std::size_t(picture.height) * tile.channels);
    }
    if (tile.channels != picture.channels) throw ProtocolError("tiles of different kinds in one frame");
    for (std::uint32_t row = tile.firstRow; row < tile.firstRow + tile.rows; ++row) {
        if (rowsHere_[row]) throw ProtocolError("tiles that overlap");
        rowsHere_[row] = true;
    }
    decode(Codec(tile.codec), encoded, int(tile.width), int(tile.rows), tile.channels, decoded_);
    const std::size_t rowBytes = std::size_t(tile.width) * tile.channels;
    std::copy(decoded_.begin(), decoded_.end(), picture.pixels.begin() + std::ptrdiff_t(tile.firstRow * rowBytes));
    rowsMissing_ -= tile.rows;
    frame_.bytes += payload.size();
}

}  // namespace aeolic::stream
