#include <new>
#include <stdexcept>

#include "aeolic/picture.h"
#include "output/output_check.h"
#include "output/picture_formats.h"
#include "output/png_writer.h"

namespace aeolic {
namespace {

/// A higher level would cost more time than the smaller file saves: LIC pictures are noise, and noise does not
/// compress.
constexpr PngEffort kEffort{3};

}  // namespace

std::string pngOf(const Picture& picture, const std::string& path)
{
    requireSound(picture, path);
    std::string bytes;
    const auto fail = [&](const char* why) { throw std::runtime_error(path + ": cannot be encoded as PNG: " + why); };
    try {
        writePngTo({picture.pixels.data(), picture.width, picture.height, picture.channels}, kEffort,
                   [&](const std::uint8_t* piece, std::size_t count) { bytes.append(piece, piece + count); });
    } catch (const std::bad_alloc&) {
        fail("there is not enough memory");
    } catch (const std::runtime_error& error) {
        fail(error.what());
    }
    return bytes;
}

std::string pngOf(const Picture& picture)
{
    return pngOf(picture, "PNG");
}

void writePng(const Picture& picture, const std::string& path)
{
    writeTextFile(path, pngOf(picture, path));
}

}  // namespace aeolic
