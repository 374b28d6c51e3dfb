#pragma once

#include <optional>
#include <vector>

#include "aeolic/stream_client.h"
#include "stream/message.h"

namespace aeolic::stream {

/// Puts a frame's tiles together. Trusts nothing: sizes, overlaps and checksums are looked at, and memory is taken only
/// for pictures of sizes a viewer may ask for.
class FrameAssembler {
public:
    /// Takes Frame, Tile or FrameEnd; the frame, once it is whole. Tiles of frames it does not know are left aside.
    /// Throws ProtocolError.
    std::optional<StreamFrame> take(const MessageView& message);

private:
    void begin(const FrameHeader& header);
    void addTile(ByteView payload);

    std::optional<FrameHeader> header_;
    StreamFrame frame_;
    std::vector<bool> rowsHere_;
    std::uint32_t rowsMissing_ = 0;
    std::vector<std::uint8_t> decoded_;
};

}  // namespace aeolic::stream
