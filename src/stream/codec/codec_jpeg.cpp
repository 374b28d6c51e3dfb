#include <turbojpeg.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "stream/codec/codec_kinds.h"
#include "stream/codec/codec_scratch.h"
#include "stream/wire.h"

// TurboJPEG rather than libjpeg's own interface: its errors are return values, and no longjmp crosses our frames.
namespace aeolic::stream {
namespace {

struct CloseJpeg {
    void operator()(void* handle) const { tjDestroy(handle); }
};
using JpegHandle = std::unique_ptr<void, CloseJpeg>;

JpegHandle opened(tjhandle handle)
{
    if (!handle) throw std::bad_alloc();
    return JpegHandle(handle);
}

int layout(int channels)
{
    return channels == 4 ? TJPF_RGBA : TJPF_RGB;
}

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

/// Reads a JPEG file's segments up to its pixels. Throws ProtocolError unless it is one that a tile may be: baseline,
/// 8 bits, three components in one scan, of that size, ended by its end marker. What else JPEG knows (progressive and
/// arithmetic coding, a scan for each component, heights told later) takes decoders many times the picture's memory or
/// minutes, from a few bytes.
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

}  // namespace

void encodeJpeg(const Pixels& pixels, int quality, std::vector<std::uint8_t>& out)
{
    // Streaks are in the brightness; colour changes slowly but at silhouettes.
    const int sampling = quality < kFullColorQuality ? TJSAMP_420 : TJSAMP_444;
    const JpegHandle jpeg = opened(tjInitCompress());
    unsigned long size = tjBufSize(pixels.width, pixels.rows, sampling);
    const Scratch file(size);
    std::uint8_t* start = file.data();
    if (tjCompress2(jpeg.get(), pixels.data, pixels.width, 0, pixels.rows, layout(pixels.channels), &start, &size,
                    sampling, quality, TJFLAG_NOREALLOC) != 0)
        throw std::runtime_error(std::string("JPEG could not encode a tile: ") + tjGetErrorStr2(jpeg.get()));
    out.insert(out.end(), start, start + size);
}

void decodeJpeg(std::span<const std::uint8_t> encoded, const PixelRoom& out)
{
    requireJpegTile(encoded, out.width, out.rows);
    const JpegHandle jpeg = opened(tjInitDecompress());
    // The flag makes damage an error that libjpeg would paint over.
    if (tjDecompress2(jpeg.get(), encoded.data(), encoded.size(), out.data, out.width, 0, out.rows,
                      layout(out.channels), TJFLAG_STOPONWARNING) != 0)
        throw ProtocolError(std::string("tile: ") + tjGetErrorStr2(jpeg.get()));
}

}  // namespace aeolic::stream
