#include "output/png_writer.h"

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <new>
#include <stdexcept>

// libpng reports errors by longjmp. The functions that call setjmp here, and those that libpng calls, have no objects
// with destructors and let no exception out; what they find goes through PngJob to the function that may throw.
namespace aeolic {
namespace {

struct PngJob {
    png_structp png = nullptr;
    png_infop info = nullptr;
    char error[120] = "";
    bool outOfMemory = false;
    const std::function<void(const std::uint8_t*, std::size_t)>& sink;
};

[[noreturn]] void onError(png_structp png, png_const_charp message)
{
    PngJob& job = *static_cast<PngJob*>(png_get_error_ptr(png));
    std::strncpy(job.error, message, sizeof(job.error) - 1);
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep bytes, png_size_t count)
{
    PngJob& job = *static_cast<PngJob*>(png_get_io_ptr(png));
    try {
        job.sink(bytes, count);
    } catch (...) {
        job.outOfMemory = true;
    }
    if (job.outOfMemory) png_error(png, "out of memory");
}

bool write(PngJob& job, const PngPixels& pixels, const PngEffort& effort)
{
    if (setjmp(png_jmpbuf(job.png))) return false;
    png_set_write_fn(job.png, &job, append, nullptr);
    if (effort.filters) png_set_filter(job.png, PNG_FILTER_TYPE_BASE, *effort.filters);
    png_set_compression_level(job.png, effort.level);
    if (effort.strategy) png_set_compression_strategy(job.png, *effort.strategy);
    if (effort.chunkBytes) png_set_compression_buffer_size(job.png, *effort.chunkBytes);
    png_set_IHDR(job.png, job.info, png_uint_32(pixels.width), png_uint_32(pixels.rows), 8,
                 pixels.channels == 4 ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(job.png, job.info);
    const std::size_t rowBytes = std::size_t(pixels.width) * std::size_t(pixels.channels);
    for (int y = 0; y < pixels.rows; ++y) png_write_row(job.png, pixels.data + std::size_t(y) * rowBytes);
    png_write_end(job.png, nullptr);
    return true;
}

}  // namespace

void writePngTo(const PngPixels& pixels, const PngEffort& effort,
                const std::function<void(const std::uint8_t* bytes, std::size_t count)>& sink)
{
    PngJob job{.sink = sink};
    job.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, onError, onWarning);
    if (job.png) job.info = png_create_info_struct(job.png);
    const bool done = job.info && write(job, pixels, effort);
    const bool outOfMemory = job.outOfMemory || !job.info;
    png_destroy_write_struct(&job.png, &job.info);
    if (outOfMemory) throw std::bad_alloc();
    if (!done) throw std::runtime_error(job.error);
}

}  // namespace aeolic
