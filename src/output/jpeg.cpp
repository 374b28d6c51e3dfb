#include <turbojpeg.h>

#include <memory>
#include <new>
#include <stdexcept>

#include "output/picture_formats.h"

namespace aeolic {
namespace {

// Streaks are as fine as pixels, and colours are read against a legend: neither may blur.
constexpr int jpegQuality = 95, jpegSampling = TJSAMP_444;

struct CloseJpeg {
    void operator()(void* handle) const { tjDestroy(handle); }
};

}  // namespace

std::string jpegOf(const Picture& picture, const std::string& path)
{
    requireSound(picture, path);
    const std::unique_ptr<void, CloseJpeg> jpeg(tjInitCompress());
    if (!jpeg) throw std::bad_alloc();
    unsigned long size = tjBufSize(picture.width, picture.height, jpegSampling);
    std::string file(size, '\0');
    auto* start = reinterpret_cast<unsigned char*>(file.data());
    if (tjCompress2(jpeg.get(), picture.pixels.data(), picture.width, 0, picture.height,
                    picture.channels == 4 ? TJPF_RGBA : TJPF_RGB, &start, &size, jpegSampling, jpegQuality,
                    TJFLAG_NOREALLOC | TJFLAG_ACCURATEDCT) != 0)
        throw std::runtime_error(path + ": cannot be encoded as JPEG: " + tjGetErrorStr2(jpeg.get()));
    file.resize(size);
    return file;
}

}  // namespace aeolic
