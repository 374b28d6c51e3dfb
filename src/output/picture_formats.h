#pragma once

#include <string>

#include "aeolic/picture.h"

namespace aeolic {

/// What a file of pictures is, by the end of its name.
enum class PictureFormat { png, jpeg, webp, apng, mp4, html };

/// The format of that name, and where its ending begins. Throws InputError naming `option` for another ending, or where
/// nothing stands before it. `animation`: it may also be one that holds many frames and nothing else. `more`: other
/// endings that the message names.
struct NamedFormat {
    PictureFormat format;
    std::size_t ending;  ///< Where ".png" begins in the name.
};
NamedFormat pictureFormatOf(const std::string& option, const std::string& path, bool animation, const char* more = "");

/// Throws InputError naming `option` where a picture of that size, transparent or not, is nothing for the format.
void checkFits(const std::string& option, PictureFormat format, int width, int height, bool transparent);

/// The bytes of a file. `path` stands in front of messages. Throws std::runtime_error where it cannot be encoded.
std::string pngOf(const Picture& picture, const std::string& path);
std::string jpegOf(const Picture& picture, const std::string& path);
std::string webpOf(const Picture& picture, const std::string& path);
/// A lossy WebP file, for a frame of an animation. LIC pictures are noise, so lossless frames would be many times as
/// large. `path` and errors are as above.
std::string lossyWebpOf(const Picture& picture, const std::string& path);

/// Throws std::runtime_error where size and pixels do not agree.
void requireSound(const Picture& picture, const std::string& path);

}  // namespace aeolic
