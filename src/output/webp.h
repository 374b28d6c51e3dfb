#pragma once

#include <webp/encode.h>

#include <string>

#include "aeolic/picture.h"

namespace aeolic {

/// A picture as libwebp wants it. Throws std::runtime_error, with `path` in front, where it cannot be.
class WebpPicture {
public:
    WebpPicture(const Picture& picture, const std::string& path);
    ~WebpPicture() { WebPPictureFree(&picture_); }
    WebpPicture(const WebpPicture&) = delete;
    WebpPicture& operator=(const WebpPicture&) = delete;

    WebPPicture* get() { return &picture_; }

private:
    WebPPicture picture_{};
};

/// Options for files whose pixels are exactly the picture's, also where they are transparent.
WebPConfig losslessWebp();
/// Options for frames: LIC pictures are noise, of which lossless files would be many times as large.
WebPConfig lossyWebp();

/// The bytes of a file of such a frame. Throws as webpOf() does.
std::string lossyWebpOf(const Picture& picture, const std::string& path);

}  // namespace aeolic
