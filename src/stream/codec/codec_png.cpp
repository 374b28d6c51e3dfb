#include <png.h>
#include <zlib.h>

#include <csetjmp>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "output/png_writer.h"
#include "stream/codec/codec_kinds.h"
#include "stream/wire.h"

// libpng reports errors by longjmp. The functions that call setjmp here, and those that libpng calls, have no objects
// with destructors and let no exception out; what they find goes through PngJob to the functions that may throw.
namespace aeolic::stream {
namespace {

// For pictures of streaks, level 3 takes twice the time and saves some percent; level 6 takes five times as long
// (docs/codecs.md). libpng's own strategy for filtered rows finds fewer repeats here.
constexpr PngEffort kEffort{1, PNG_FILTER_SUB, Z_DEFAULT_STRATEGY, 128 * 1024};

struct PngJob {
    png_structp png = nullptr;
    png_infop info = nullptr;
    char error[120] = "";
    std::span<const std::uint8_t> encodedIn;  ///< The bytes that are not read yet.
};

[[noreturn]] void onError(png_structp png, png_const_charp message)
{
    PngJob& job = *static_cast<PngJob*>(png_get_error_ptr(png));
    std::strncpy(job.error, message, sizeof(job.error) - 1);
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void take(png_structp png, png_bytep bytes, png_size_t count)
{
    PngJob& job = *static_cast<PngJob*>(png_get_io_ptr(png));
    if (count > job.encodedIn.size()) png_error(png, "it ends too soon");
    std::memcpy(bytes, job.encodedIn.data(), count);
    job.encodedIn = job.encodedIn.subspan(count);
}

int colorType(int channels)
{
    return channels == 4 ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB;
}

/// Keeps colours as they are in the file: skips chunks about gamma, text and whatever else a picture can do without.
bool readFile(PngJob& job, const PixelRoom& out)
{
    if (setjmp(png_jmpbuf(job.png))) return false;
    png_set_read_fn(job.png, &job, take);
    png_set_user_limits(job.png, png_uint_32(out.width), png_uint_32(out.rows));
    png_set_keep_unknown_chunks(job.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_set_crc_action(job.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_set_benign_errors(job.png, 0);
    png_read_info(job.png, job.info);
    if (png_get_image_width(job.png, job.info) != png_uint_32(out.width) ||
        png_get_image_height(job.png, job.info) != png_uint_32(out.rows))
        png_error(job.png, "another size");
    if (png_get_bit_depth(job.png, job.info) != 8 || png_get_color_type(job.png, job.info) != colorType(out.channels) ||
        png_get_interlace_type(job.png, job.info) != PNG_INTERLACE_NONE)
        png_error(job.png, "another kind of pixels");
    const std::size_t rowBytes = out.bytes() / std::size_t(out.rows);
    for (int y = 0; y < out.rows; ++y) png_read_row(job.png, out.data + std::size_t(y) * rowBytes, nullptr);
    png_read_end(job.png, nullptr);
    if (!job.encodedIn.empty()) png_error(job.png, "bytes after its end");
    return true;
}

}  // namespace

void encodePng(const Pixels& pixels, int, std::vector<std::uint8_t>& out)
{
    try {
        writePngTo({pixels.data, pixels.width, pixels.rows, pixels.channels}, kEffort,
                   [&](const std::uint8_t* piece, std::size_t count) { out.insert(out.end(), piece, piece + count); });
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(std::string("PNG could not encode a tile: ") + error.what());
    }
}

void decodePng(std::span<const std::uint8_t> encoded, const PixelRoom& out)
{
    PngJob job;
    job.encodedIn = encoded;
    job.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, onError, onWarning);
    if (job.png) job.info = png_create_info_struct(job.png);
    const bool done = job.info && readFile(job, out), outOfMemory = !job.info;
    png_destroy_read_struct(&job.png, &job.info, nullptr);
    if (outOfMemory) throw std::bad_alloc();
    if (!done) throw ProtocolError(std::string("tile: a PNG file: ") + job.error);
}

}  // namespace aeolic::stream
