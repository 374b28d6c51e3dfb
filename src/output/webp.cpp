#include <webp/encode.h>
#include <webp/mux.h>

#include <cmath>
#include <new>
#include <stdexcept>
#include <string>

#include "output/animation.h"
#include "output/output_check.h"

namespace aeolic {
namespace {

/// A picture as libwebp wants it. Throws std::runtime_error, with `path` in front, where it cannot be.
struct WebpPicture : WebPPicture {
    WebpPicture(const Picture& picture, const std::string& path)
    {
        requireSound(picture, path);
        if (!WebPPictureInit(this)) throw std::runtime_error("libwebp is of another version than its header");
        use_argb = 1;
        width = picture.width;
        height = picture.height;
        const int stride = picture.width * picture.channels;
        if (!(picture.channels == 4 ? WebPPictureImportRGBA(this, picture.pixels.data(), stride)
                                    : WebPPictureImportRGB(this, picture.pixels.data(), stride)))
            throw std::bad_alloc();
    }
    ~WebpPicture() { WebPPictureFree(this); }
    WebpPicture(const WebpPicture&) = delete;
    WebpPicture& operator=(const WebpPicture&) = delete;
};

struct MemoryWriter : WebPMemoryWriter {
    MemoryWriter() { WebPMemoryWriterInit(this); }
    ~MemoryWriter() { WebPMemoryWriterClear(this); }
};

/// Options for files whose pixels are exactly the picture's, also where they are transparent.
WebPConfig losslessWebp()
{
    WebPConfig config;
    WebPConfigInit(&config);
    WebPConfigLosslessPreset(&config, 2);  // Higher levels take many times as long for a few percent.
    config.exact = 1;
    config.thread_level = 1;
    return config;
}

/// Options for frames: LIC pictures are noise, of which lossless files would be many times as large.
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

std::string encodedWebp(const Picture& picture, const WebPConfig& config, const std::string& path)
{
    WebpPicture source(picture, path);
    MemoryWriter writer;
    source.writer = WebPMemoryWrite;
    source.custom_ptr = &writer;
    if (!WebPEncode(&config, &source))
        throw std::runtime_error(path + ": cannot be encoded as WebP (error " + std::to_string(source.error_code) +
                                 ")");
    return {reinterpret_cast<const char*>(writer.mem), writer.size};
}

class WebpAnimation : public Animation {
public:
    explicit WebpAnimation(const AnimationPlan& plan) : plan_(plan) {}
    ~WebpAnimation() override { WebPAnimEncoderDelete(encoder_); }

    void add(const Picture& picture) override
    {
        if (!encoder_) {
            WebPAnimEncoderOptions options;
            if (!WebPAnimEncoderOptionsInit(&options))
                throw std::runtime_error("libwebp is of another version than its header");
            options.anim_params.loop_count = 0;  // For ever.
            encoder_ = WebPAnimEncoderNew(picture.width, picture.height, &options);
            if (!encoder_) fail("not enough memory");
        }
        WebpPicture frame(picture, plan_.path);
        const WebPConfig config = lossyWebp();
        if (!WebPAnimEncoderAdd(encoder_, &frame, timeMs(), &config)) fail(WebPAnimEncoderGetError(encoder_));
        ++added_;
    }

    void complete() override
    {
        WebPData file;
        WebPDataInit(&file);
        const bool made = WebPAnimEncoderAdd(encoder_, nullptr, timeMs(), nullptr) != 0 &&
                          WebPAnimEncoderAssemble(encoder_, &file) != 0;
        const std::string bytes(reinterpret_cast<const char*>(file.bytes), file.size);
        WebPDataClear(&file);
        if (!made) fail(WebPAnimEncoderGetError(encoder_));
        writeTextFile(plan_.path, bytes);
    }

private:
    /// When the next frame begins. Rounded for each, so that they do not drift.
    int timeMs() const { return int(std::lround(1000 * added_ / plan_.framesPerSecond)); }

    [[noreturn]] void fail(const std::string& why) const
    {
        throw std::runtime_error(plan_.path + ": cannot be encoded as WebP (" + why + ")");
    }

    AnimationPlan plan_;
    WebPAnimEncoder* encoder_ = nullptr;
    int added_ = 0;
};

}  // namespace

std::string webpOf(const Picture& picture, const std::string& path)
{
    return encodedWebp(picture, losslessWebp(), path);
}

std::string lossyWebpOf(const Picture& picture, const std::string& path)
{
    return encodedWebp(picture, lossyWebp(), path);
}

std::unique_ptr<Animation> makeWebpAnimation(const AnimationPlan& plan)
{
    return std::make_unique<WebpAnimation>(plan);
}

}  // namespace aeolic
