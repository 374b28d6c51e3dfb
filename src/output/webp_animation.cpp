#include <webp/mux.h>

#include <cmath>
#include <stdexcept>

#include "output/animation.h"
#include "output/output_check.h"
#include "output/webp.h"

namespace aeolic {
namespace {

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
        if (!WebPAnimEncoderAdd(encoder_, frame.get(), timeMs(), &config)) fail(WebPAnimEncoderGetError(encoder_));
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

std::unique_ptr<Animation> makeWebpAnimation(const AnimationPlan& plan)
{
    return std::make_unique<WebpAnimation>(plan);
}

}  // namespace aeolic
