#include "output/webp.h"

#include <new>
#include <stdexcept>
#include <string>

#include "output/picture_formats.h"

namespace aeolic {
namespace {

struct MemoryWriter : WebPMemoryWriter {
    MemoryWriter() { WebPMemoryWriterInit(this); }
    ~MemoryWriter() { WebPMemoryWriterClear(this); }
};

}  // namespace

WebpPicture::WebpPicture(const Picture& picture, const std::string& path)
{
    requireSound(picture, path);
    if (!WebPPictureInit(&picture_)) throw std::runtime_error("libwebp is of another version than its header");
    picture_.use_argb = 1;
    picture_.width = picture.width;
    picture_.height = picture.height;
    const int stride = picture.width * picture.channels;
    if (!(picture.channels == 4 ? WebPPictureImportRGBA(&picture_, picture.pixels.data(), stride)
                                : WebPPictureImportRGB(&picture_, picture.pixels.data(), stride)))
        throw std::bad_alloc();
}

WebPConfig losslessWebp()
{
    WebPConfig config;
    WebPConfigInit(&config);
    WebPConfigLosslessPreset(&config, 2);  // Higher levels take many times as long for a few percent.
    config.exact = 1;
    config.thread_level = 1;
    return config;
}

WebPConfig lossyWebp()
{
    WebPConfig config;
    WebPConfigInit(&config);
    config.quality = 90;
    config.method = 2;
    config.use_sharp_yuv = 1;  // Text on a plain ground, and streaks, keep their edges.
    config.thread_level = 1;
    return config;
}

namespace {

std::string encodedWebp(const Picture& picture, const WebPConfig& config, const std::string& path)
{
    WebpPicture source(picture, path);
    MemoryWriter writer;
    source.get()->writer = WebPMemoryWrite;
    source.get()->custom_ptr = &writer;
    if (!WebPEncode(&config, source.get()))
        throw std::runtime_error(path + ": cannot be encoded as WebP (error " +
                                 std::to_string(source.get()->error_code) + ")");
    return {reinterpret_cast<const char*>(writer.mem), writer.size};
}

}  // namespace

std::string webpOf(const Picture& picture, const std::string& path)
{
    return encodedWebp(picture, losslessWebp(), path);
}

std::string lossyWebpOf(const Picture& picture, const std::string& path)
{
    return encodedWebp(picture, lossyWebp(), path);
}

}  // namespace aeolic
