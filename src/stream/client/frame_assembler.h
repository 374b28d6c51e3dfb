#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "aeolic/stream_client.h"
#include "stream/message.h"

namespace aeolic::stream {

/// Puts a frame's tiles together. Trusts nothing: sizes, overlaps and checksums are looked at, and memory is taken only
/// for pictures that were asked for.
class FrameAssembler {
public:
    /// Of a picture, whatever was asked for: 1 GiB of RGBA.
    static constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;

    /// A picture of this size, or a smaller one, may come.
    void asked(int width, int height);
    /// Takes Frame, Tile or FrameEnd; the frame, once it is whole. Tiles of frames it does not know are left aside.
    /// Throws ProtocolError.
    std::optional<StreamFrame> take(const MessageView& message);

private:
    void begin(const FrameHeader& header);
    void addTile(ByteView payload);

    std::uint32_t mostColumns_ = 0, mostRows_ = 0;  ///< Of all that were asked for.
    std::optional<FrameHeader> header_;
    StreamFrame frame_;
    std::vector<bool> rowsHere_;
    std::uint32_t rowsMissing_ = 0;
    std::vector<std::uint8_t> decoded_;
};

}  // namespace aeolic::stream
