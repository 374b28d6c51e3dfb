#include "stream/codec/row_filter.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <vector>

namespace aeolic::stream {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Sums run along a row, so vectors wider than 16 bytes would only add steps. Every target has vectors of 16 bytes.
using Bytes16 = hn::FixedTag<std::uint8_t, 16>;
constexpr Bytes16 kBytes16;
using Vec16 = hn::Vec<Bytes16>;
constexpr std::size_t kLanes = 16;

/// A pixel's bytes in the order of the planes: green, red and blue less green, alpha.
using Planes = std::array<std::uint8_t, 4>;

template <int kChannels>
Planes planesOf(const std::uint8_t* pixel)
{
    const std::uint8_t green = pixel[1];
    return {green, std::uint8_t(pixel[0] - green), std::uint8_t(pixel[2] - green),
            kChannels == 4 ? pixel[kChannels - 1] : std::uint8_t(0)};
}

template <int kChannels>
void putPixel(const Planes& planes, std::uint8_t* pixel)
{
    pixel[0] = std::uint8_t(planes[1] + planes[0]);
    pixel[1] = planes[0];
    pixel[2] = std::uint8_t(planes[2] + planes[0]);
    if (kChannels == 4) pixel[kChannels - 1] = planes[3];
}

/// planesOf() of 16 pixels.
template <int kChannels>
std::array<Vec16, 4> loadPlanes(const std::uint8_t* pixels)
{
    Vec16 red, green, blue, alpha = hn::Zero(kBytes16);
    if constexpr (kChannels == 4)
        hn::LoadInterleaved4(kBytes16, pixels, red, green, blue, alpha);
    else
        hn::LoadInterleaved3(kBytes16, pixels, red, green, blue);
    return {green, hn::Sub(red, green), hn::Sub(blue, green), alpha};
}

template <int kChannels>
void storePlanes(const std::array<Vec16, 4>& planes, std::uint8_t* pixels)
{
    const Vec16 red = hn::Add(planes[1], planes[0]), blue = hn::Add(planes[2], planes[0]);
    if constexpr (kChannels == 4)
        hn::StoreInterleaved4(red, planes[0], blue, planes[3], kBytes16, pixels);
    else
        hn::StoreInterleaved3(red, planes[0], blue, kBytes16, pixels);
}

template <int kChannels>
void filterRow(const std::uint8_t* pixels, std::size_t width, std::uint8_t* filtered)
{
    const auto filterPixel = [&](std::size_t x, const Planes& left) {
        const Planes here = planesOf<kChannels>(pixels + x * kChannels);
        for (std::size_t c = 0; c < kChannels; ++c) filtered[c * width + x] = std::uint8_t(here[c] - left[c]);
        return here;
    };
    Planes left = filterPixel(0, {});
    std::size_t x = 1;
    for (; x + kLanes <= width; x += kLanes) {
        const auto here = loadPlanes<kChannels>(pixels + x * kChannels),
                   before = loadPlanes<kChannels>(pixels + (x - 1) * kChannels);
        for (std::size_t c = 0; c < kChannels; ++c)
            hn::StoreU(hn::Sub(here[c], before[c]), kBytes16, filtered + c * width + x);
    }
    if (x > 1) left = planesOf<kChannels>(pixels + (x - 1) * kChannels);
    for (; x < width; ++x) left = filterPixel(x, left);
}

/// Adds to each lane all lanes before it.
Vec16 runningSums(Vec16 v)
{
    v = hn::Add(v, hn::ShiftLeftBytes<1>(kBytes16, v));
    v = hn::Add(v, hn::ShiftLeftBytes<2>(kBytes16, v));
    v = hn::Add(v, hn::ShiftLeftBytes<4>(kBytes16, v));
    return hn::Add(v, hn::ShiftLeftBytes<8>(kBytes16, v));
}

template <int kChannels>
void unfilterRow(const std::uint8_t* filtered, std::size_t width, std::uint8_t* pixels)
{
    const auto lastLane = hn::Set(kBytes16, std::uint8_t(kLanes - 1));
    std::array<Vec16, 4> sums;
    sums.fill(hn::Zero(kBytes16));
    std::size_t x = 0;
    for (; x + kLanes <= width; x += kLanes) {
        for (std::size_t c = 0; c < kChannels; ++c)
            sums[c] = hn::Add(runningSums(hn::LoadU(kBytes16, filtered + c * width + x)),
                              hn::TableLookupBytes(sums[c], lastLane));
        storePlanes<kChannels>(sums, pixels + x * kChannels);
    }
    Planes sum{};
    if (x > 0) sum = planesOf<kChannels>(pixels + (x - 1) * kChannels);
    for (; x < width; ++x) {
        for (std::size_t c = 0; c < kChannels; ++c) sum[c] = std::uint8_t(sum[c] + filtered[c * width + x]);
        putPixel<kChannels>(sum, pixels + x * kChannels);
    }
}

}  // namespace

void filterRows(const std::uint8_t* pixels, int width, int rows, int channels, std::uint8_t* filtered)
{
    const std::size_t rowBytes = std::size_t(width) * std::size_t(channels);
    const auto filter = channels == 4 ? filterRow<4> : filterRow<3>;
    for (int y = 0; y < rows; ++y, pixels += rowBytes, filtered += rowBytes)
        filter(pixels, std::size_t(width), filtered);
}

void unfilterRows(std::uint8_t* pixels, int width, int rows, int channels)
{
    const std::size_t rowBytes = std::size_t(width) * std::size_t(channels);
    const auto unfilter = channels == 4 ? unfilterRow<4> : unfilterRow<3>;
    std::vector<std::uint8_t> row(rowBytes);
    for (int y = 0; y < rows; ++y, pixels += rowBytes) {
        std::copy(pixels, pixels + rowBytes, row.begin());
        unfilter(row.data(), std::size_t(width), pixels);
    }
}

}  // namespace aeolic::stream
