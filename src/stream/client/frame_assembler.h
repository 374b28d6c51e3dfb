#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "aeolic/stream_client.h"
#include "stream/message.h"

namespace aeolic::stream {

/// Puts a frame's tiles together. It trusts nothing: it checks sizes, overlaps and checksums, and takes memory only for
/// pictures that were asked for.
class FrameAssembler {
public:
    /// The largest picture, whatever was asked for: 1 GiB of RGBA.
    static constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;

    /// From now on a picture of this size, or a smaller one, may come.
    void asked(int width, int height);
    /// Takes a Frame, Tile or FrameEnd. Returns the frame once it is whole. Ignores tiles of frames it does not know.
    /// Throws ProtocolError.
    std::optional<StreamFrame> take(const MessageView& message);

private:
    void begin(const FrameHeader& header);
    void addTile(ByteView payload);

    std::uint32_t mostColumns_ = 0, mostRows_ = 0;  ///< The most columns and rows that were asked for.
    std::optional<FrameHeader> header_;
    StreamFrame frame_;
    std::vector<bool> rowsHere_;
    std::uint32_t rowsMissing_ = 0;
    std::vector<std::uint8_t> decoded_;
};

}  // namespace aeolic::stream
