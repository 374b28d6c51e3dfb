#include "stream/codec/jpeg_header.h"

#include <cstddef>
#include <string>

#include "stream/protocol_error.h"

namespace aeolic::stream {
namespace {

// Markers: the byte after 0xFF (ITU-T T.81, table B.1).
constexpr int kStartOfImage = 0xD8, kEndOfImage = 0xD9, kBaseline = 0xC0, kHuffmanTables = 0xC4, kStartOfScan = 0xDA,
              kQuantization = 0xDB, kRestartInterval = 0xDD, kFirstApplication = 0xE0, kLastApplication = 0xEF;
constexpr std::size_t kFrameBytes = 17, kScanBytes = 12;  // Segments for three components, with their length fields.

[[noreturn]] void refuse(const char* why)
{
    throw ProtocolError(std::string("tile: a JPEG file ") + why);
}

int bigEndian(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return bytes[at] << 8 | bytes[at + 1];
}

void requireFrame(std::span<const std::uint8_t> segment, int width, int rows)
{
    if (segment.size() != kFrameBytes || segment[2] != 8 || segment[7] != 3) refuse("of another kind of pixels");
    if (bigEndian(segment, 3) != rows || bigEndian(segment, 5) != width) refuse("of another size");
}

bool mayPrecedeScan(int marker)
{
    return marker == kHuffmanTables || marker == kQuantization || marker == kRestartInterval ||
           (marker >= kFirstApplication && marker <= kLastApplication);
}

}  // namespace

void requireJpegTile(std::span<const std::uint8_t> file, int width, int rows)
{
    if (file.size() < 4 || bigEndian(file, 0) != (0xFF00 | kStartOfImage)) refuse("without a beginning");
    if (bigEndian(file, file.size() - 2) != (0xFF00 | kEndOfImage)) refuse("without an end");
    bool frame = false;
    for (std::size_t at = 2; file.size() - at >= 4;) {
        if (file[at] != 0xFF) refuse("with damaged segments");
        const int marker = file[at + 1], length = bigEndian(file, at + 2);
        if (length < 2 || std::size_t(length) > file.size() - at - 2) refuse("with damaged segments");
        const auto segment = file.subspan(at + 2, std::size_t(length));
        if (marker == kBaseline && !frame) {
            requireFrame(segment, width, rows);
            frame = true;
        } else if (marker == kStartOfScan) {
            if (!frame || segment.size() != kScanBytes || segment[2] != 3) refuse("with several scans");
            return;
        } else if (!mayPrecedeScan(marker)) {
            refuse("that is not baseline");
        }
        at += 2 + segment.size();
    }
    refuse("without pixels");
}

}  // namespace aeolic::stream
