#include <turbojpeg.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "stream/codec/codec_kinds.h"
#include "stream/codec/codec_scratch.h"
#include "stream/codec/jpeg_header.h"
#include "stream/protocol_error.h"

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
