#include "cluster/composite/pixel_messages.h"

#include <cstring>
#include <stdexcept>

namespace aeolic {

void appendRuns(Bytes& bytes, const std::vector<PixelRun>& runs)
{
    const auto count = std::uint16_t(runs.size());
    appendBytes(bytes, &count, 1);
    appendBytes(bytes, runs.data(), runs.size());
}

void PixelReader::fail(const std::string& what) const
{
    throw std::runtime_error("pixels from rank " + std::to_string(sender_) + " " + what);
}

const std::byte* PixelReader::skip(std::size_t bytes)
{
    if (bytes > bytes_.size() - at_) fail("end too early");
    const std::byte* begin = bytes_.data() + at_;
    at_ += bytes;
    return begin;
}

void PixelReader::read(void* to, std::size_t bytes)
{
    const std::byte* from = skip(bytes);
    if (bytes > 0) std::memcpy(to, from, bytes);
}

MessageRows PixelReader::rows(const Extent& rows)
{
    MessageRows range{};
    read(&range, sizeof range);
    if (range.y0 < rows.y0 || range.y1 > rows.y1 || range.y0 > range.y1) fail("are of other rows");
    return range;
}

void PixelReader::runs(const Extent& rows, std::vector<PixelRun>& runs)
{
    std::uint16_t count = 0;
    read(&count, sizeof count);
    runs.resize(count);
    read(runs.data(), count * sizeof(PixelRun));
    int end = rows.x0;
    for (const PixelRun& run : runs) {
        if (run.x0 < end || run.x1 <= run.x0 || run.x1 > rows.x1) fail("are of other columns");
        end = run.x1;
    }
}

void PixelReader::requireEnd() const
{
    if (at_ != bytes_.size()) fail("go on too long");
}

}  // namespace aeolic
