#include "stream/row_filter.h"

#include <hwy/highway.h>

namespace aeolic::stream {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Sums run along a row, so wider vectors than 16 bytes would only add steps; every target has these.
using Bytes16 = hn::FixedTag<std::uint8_t, 16>;
constexpr Bytes16 kBytes16;

void filterRow(const std::uint8_t* HWY_RESTRICT pixels, std::size_t count, std::size_t channels,
               std::uint8_t* HWY_RESTRICT filtered)
{
    for (std::size_t i = 0; i < channels; ++i) filtered[i] = pixels[i];
    for (std::size_t i = channels; i < count; ++i) filtered[i] = std::uint8_t(pixels[i] - pixels[i - channels]);
}

/// The first `kChannels` … bytes of a row by vectors of whole pixels; returns how many bytes are done.
template <int kChannels>
std::size_t sumByVectors(std::uint8_t* row, std::size_t count)
{
    constexpr int kUsed = 16 / kChannels * kChannels;  // Bytes of whole pixels in a vector: 15 or 16.
    if (count < 16 + kUsed) return 0;
    alignas(16) std::uint8_t lastPixel[16];
    for (int i = 0; i < 16; ++i) lastPixel[i] = std::uint8_t(kUsed - kChannels + i % kChannels);
    const auto toLastPixel = hn::Load(kBytes16, lastPixel);
    const auto used = hn::FirstN(kBytes16, kUsed);
    auto carry = hn::Zero(kBytes16);
    auto next = hn::LoadU(kBytes16, row);
    std::size_t at = 0;
    for (; at + kUsed + 16 <= count; at += kUsed) {
        const auto differences = next;
        // Before the store: it writes a byte beyond kUsed again, and a load across two stores would wait for both.
        next = hn::LoadU(kBytes16, row + at + kUsed);
        auto sums = hn::Add(differences, hn::ShiftLeftBytes<kChannels>(kBytes16, differences));
        sums = hn::Add(sums, hn::ShiftLeftBytes<2 * kChannels>(kBytes16, sums));
        if constexpr (4 * kChannels < kUsed) sums = hn::Add(sums, hn::ShiftLeftBytes<4 * kChannels>(kBytes16, sums));
        sums = hn::Add(sums, carry);
        carry = hn::TableLookupBytes(sums, toLastPixel);
        hn::StoreU(hn::IfThenElse(used, sums, differences), kBytes16, row + at);
    }
    return at;
}

template <int kChannels>
void unfilterRow(std::uint8_t* row, std::size_t count)
{
    std::size_t at = sumByVectors<kChannels>(row, count);
    if (at == 0) at = kChannels;
    for (; at < count; ++at) row[at] = std::uint8_t(row[at] + row[at - kChannels]);
}

}  // namespace

void filterRows(const std::uint8_t* pixels, int width, int rows, int channels, std::uint8_t* filtered)
{
    const std::size_t count = std::size_t(width) * std::size_t(channels);
    for (int y = 0; y < rows; ++y)
        filterRow(pixels + std::size_t(y) * count, count, std::size_t(channels), filtered + std::size_t(y) * count);
}

void unfilterRows(std::uint8_t* pixels, int width, int rows, int channels)
{
    const std::size_t count = std::size_t(width) * std::size_t(channels);
    for (int y = 0; y < rows; ++y) {
        std::uint8_t* row = pixels + std::size_t(y) * count;
        if (channels == 4)
            unfilterRow<4>(row, count);
        else
            unfilterRow<3>(row, count);
    }
}

}  // namespace aeolic::stream
