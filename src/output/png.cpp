#include <png.h>

#include <csetjmp>
#include <cstring>
#include <stdexcept>

#include "aeolic/picture.h"
#include "output/output_check.h"
#include "output/picture_formats.h"

// libpng reports errors by longjmp. The functions that call setjmp here, and those that libpng calls, have no objects
// with destructors and let no exception out.
namespace aeolic {

namespace {

/// A higher level would cost more time than the smaller file saves: LIC pictures are noise, and noise does not
/// compress.
constexpr int compressionLevel = 3;

struct PngFile {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string bytes;
    char error[120] = "there is not enough memory";

    ~PngFile() { png_destroy_write_struct(&png, &info); }
};

[[noreturn]] void onError(png_structp png, png_const_charp message)
{
    PngFile& file = *static_cast<PngFile*>(png_get_error_ptr(png));
    std::strncpy(file.error, message, sizeof(file.error) - 1);
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep bytes, png_size_t count)
{
    bool isDone = false;
    try {
        static_cast<PngFile*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<const char*>(bytes), count);
        isDone = true;
    } catch (...) {
    }
    if (!isDone) png_error(png, "there is not enough memory");
}

bool write(PngFile& file, const Picture& picture)
{
    if (setjmp(png_jmpbuf(file.png))) return false;
    png_set_write_fn(file.png, &file, append, nullptr);
    png_set_compression_level(file.png, compressionLevel);
    png_set_IHDR(file.png, file.info, png_uint_32(picture.width), png_uint_32(picture.height), 8,
                 picture.channels == 4 ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(file.png, file.info);
    const std::size_t rowBytes = std::size_t(picture.width) * std::size_t(picture.channels);
    for (int y = 0; y < picture.height; ++y) png_write_row(file.png, picture.pixels.data() + std::size_t(y) * rowBytes);
    png_write_end(file.png, nullptr);
    return true;
}

}  // namespace

std::string pngOf(const Picture& picture, const std::string& path)
{
    requireSound(picture, path);
    PngFile file;
    file.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &file, onError, onWarning);
    if (file.png) file.info = png_create_info_struct(file.png);
    if (!file.info || !write(file, picture))
        throw std::runtime_error(path + ": cannot be encoded as PNG: " + file.error);
    return std::move(file.bytes);
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
