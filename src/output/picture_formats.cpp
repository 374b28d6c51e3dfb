#include "output/picture_formats.h"

#include <fmt/format.h>
#include <webp/encode.h>

#include <algorithm>
#include <stdexcept>

#include "aeolic/error.h"
#include "base/text.h"
#include "description/option_rules.h"
#include "output/output_check.h"

namespace aeolic {
namespace {

struct Ending {
    const char* text;
    PictureFormat format;
    bool still;
};
constexpr Ending endings[] = {{".png", PictureFormat::png, true},    {".jpg", PictureFormat::jpeg, true},
                              {".jpeg", PictureFormat::jpeg, true},  {".webp", PictureFormat::webp, true},
                              {".apng", PictureFormat::apng, false}, {".mp4", PictureFormat::mp4, false},
                              {".html", PictureFormat::html, false}};

}  // namespace

NamedFormat pictureFormatOf(const std::string& option, const std::string& path, bool animation, const char* more)
{
    const std::string lower = lowerCase(path);
    for (const Ending& ending : endings) {
        const std::string_view text = ending.text;
        if (!lower.ends_with(text) || (!ending.still && !animation)) continue;
        const std::size_t at = path.size() - text.size();
        if (at > 0 && path[at - 1] != '/') return {ending.format, at};
    }
    throw InputError(option, "found " + inQuotes(path),
                     std::string(animation ? "a name ending in .png, .jpg, .webp, .apng, .mp4 or .html"
                                           : "a name ending in .png, .jpg or .webp") +
                         more);
}

void checkFits(const std::string& option, PictureFormat format, int width, int height, bool transparent)
{
    if (transparent && format == PictureFormat::jpeg)
        throw InputError(option, "found a JPEG file of a picture that is transparent",
                         ".png or .webp, or another background");
    if (transparent && format == PictureFormat::mp4)
        throw InputError(option, "found a video of pictures that are transparent",
                         ".apng or .webp, or another background");
    const bool isWebp = format == PictureFormat::webp || format == PictureFormat::html;
    if (isWebp && std::max(width, height) > WEBP_MAX_DIMENSION)
        throw InputError(option,
                         fmt::format("found {} of {}x{} pixels",
                                     format == PictureFormat::html ? "WebP pictures" : "a WebP file", width, height),
                         fmt::format("at most {} a side, or another format", WEBP_MAX_DIMENSION));
}

void requireSound(const Picture& picture, const std::string& path)
{
    if (picture.width <= 0 || picture.height <= 0 || (picture.channels != 3 && picture.channels != 4) ||
        picture.pixels.size() !=
            std::size_t(picture.width) * std::size_t(picture.channels) * std::size_t(picture.height))
        throw std::runtime_error(path + ": not a picture: its size and its pixels do not agree");
}

void writePicture(const Picture& picture, const std::string& path)
{
    checkFileName(path);
    const PictureFormat format = pictureFormatOf(path, path, false).format;
    checkFits(path, format, picture.width, picture.height, picture.channels == 4);
    writeTextFile(path, format == PictureFormat::jpeg   ? jpegOf(picture, path)
                        : format == PictureFormat::webp ? webpOf(picture, path)
                                                        : pngOf(picture, path));
}

}  // namespace aeolic
