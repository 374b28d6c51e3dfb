#include "engine/plane_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "render/lic/noise.h"
#include "render/limits.h"

namespace aeolic {
namespace {

constexpr std::size_t grain = 16;  // Rows.
constexpr int together = 64;  // Pixels that go through each step at once, so that the compiler takes vectors of them.

/// Noise of each pixel, from -1 to 1: white, with the variance that the contrast is made for.
void whiteNoise(std::uint32_t pixel, std::uint32_t seed, int count, float* noise)
{
    const std::uint32_t start = (seed + 0x7f4a7c15u) * 0x85ebca6bu;
    const float amplitude = float(std::sqrt(3.0) * kNoiseSigma);
    for (int i = 0; i < count; ++i) {
        std::uint32_t x = (pixel + std::uint32_t(i)) * 0x9e3779b9u ^ start;  // Two rounds of a finaliser mix it.
        for (int round = 0; round < 2; ++round) {
            x ^= x >> 16;
            x *= 0x7feb352du;
            x ^= x >> 15;
            x *= 0x846ca68bu;
            x ^= x >> 16;
        }
        const float uniform = float(std::int32_t(x >> 8)) * 0x1p-23F - 1;
        noise[i] = uniform * amplitude;
    }
}

/// Whether all of `row` and its neighbours in the eight directions flow is a bit each.
void linkRow(const std::uint32_t* above, const std::uint32_t* row, const std::uint32_t* below, int width,
             std::uint8_t* links)
{
    const auto bit = [](std::uint32_t texel, int which) { return texel != 0 ? 1u << which : 0u; };
    for (int x = 0; x < width; ++x) {
        const std::uint32_t bits = bit(above[x - 1], linkBit(-1, -1)) | bit(above[x], linkBit(0, -1)) |
                                   bit(above[x + 1], linkBit(1, -1)) | bit(row[x - 1], linkBit(-1, 0)) |
                                   bit(row[x + 1], linkBit(1, 0)) | bit(below[x - 1], linkBit(-1, 1)) |
                                   bit(below[x], linkBit(0, 1)) | bit(below[x + 1], linkBit(1, 1));
        links[x] = std::uint8_t(row[x] != 0 ? bits : 0u);
    }
}

double lengthOf(float u, float v)
{
    return std::sqrt(double(u) * double(u) + double(v) * double(v));  // No float's square is too large for a double.
}

}  // namespace

PlaneRows::PlaneRows(const PlaneFlow& flow, const LicOptions& lic, int reach) : flow_(flow), lic_(lic), reach_(reach)
{
    flowUnitPx_ = std::exp2(std::ceil(std::log2(std::max(lic.stepPx, 1e-3)))) / (flow_texel::kDisplacementMax + 1);
    unitsPerStep_ = lic.stepPx / flowUnitPx_;
    findScales();
}

void PlaneRows::findScales()
{
    struct Scales {
        double longest = 0;
        float lo = std::numeric_limits<float>::max(), hi = std::numeric_limits<float>::lowest();
    };
    std::vector<Scales> ofRow(std::size_t(flow_.height));
    parallelRanges(ofRow.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
            Scales found;
            for (std::size_t i = y * std::size_t(flow_.width); i < (y + 1) * std::size_t(flow_.width); ++i) {
                const double length = lengthOf(flow_.u[i], flow_.v[i]);
                if (std::isfinite(length)) found.longest = std::max(found.longest, length);
                if (!flow_.texture || !std::isfinite(flow_.texture[i])) continue;
                found.lo = std::min(found.lo, flow_.texture[i]);
                found.hi = std::max(found.hi, flow_.texture[i]);
            }
            ofRow[y] = found;
        }
    });
    Scales all;
    for (const Scales& row : ofRow)
        all = {std::max(all.longest, row.longest), std::min(all.lo, row.lo), std::max(all.hi, row.hi)};
    longest_ = all.longest;
    if (!(all.lo < all.hi)) return;
    middle_ = 0.5F * all.lo + 0.5F * all.hi;
    perUnit_ = 1 / (0.5F * all.hi - 0.5F * all.lo);
    if (!std::isfinite(perUnit_)) perUnit_ = 0;
}

Extent PlaneRows::extentFor(int y0, int y1) const
{
    if (flow_.periodic) return {-reach_, y0 - reach_, flow_.width + reach_, y1 + reach_};
    return {0, std::max(y0 - reach_, 0), flow_.width, std::min(y1 + reach_, flow_.height)};
}

void PlaneRows::noiseOf(std::size_t first, int count, float* noise) const
{
    if (!flow_.texture) return whiteNoise(std::uint32_t(first), lic_.seed, count, noise);
    for (int i = 0; i < count; ++i) {
        const float value = (flow_.texture[first + std::size_t(i)] - middle_) * perUnit_;
        noise[i] = std::isfinite(value) ? std::clamp(value, -1.0F, 1.0F) : 0.0F;
    }
}

void PlaneRows::fillRow(int y, std::uint32_t* row, std::uint32_t* fineVectors, std::uint16_t* fineNoise) const
{
    using cpu::FineFlow;
    const std::size_t first = std::size_t(y) * std::size_t(flow_.width);
    // The direction of a vector shorter than a millionth of the longest is the data's rounding noise.
    const double least = lic_.normalize ? 1e-6 * longest_ : 0, most = flow_texel::kDisplacementMax;
    const auto whole = [](auto value) { return std::int32_t(std::floor(value + decltype(value)(0.5))); };
    for (int x0 = 0; x0 < flow_.width; x0 += together) {
        const int count = std::min(together, flow_.width - x0);
        const float *u = flow_.u + first + x0, *v = flow_.v + first + x0;
        float noise[together];
        double dx[together], dy[together];
        std::uint32_t flows[together];
        noiseOf(first + std::size_t(x0), count, noise);
        for (int i = 0; i < count; ++i) {
            const double length = lengthOf(u[i], v[i]), reference = lic_.normalize ? length : longest_;
            const bool finite = length <= std::numeric_limits<double>::max();
            const double units = finite && length > least ? unitsPerStep_ / reference : 0;
            dx[i] = std::clamp(finite ? double(u[i]) * units : 0, -most, most);
            dy[i] = std::clamp(finite ? double(v[i]) * units : 0, -most, most);
            flows[i] = finite ? ~0u : 0u;
        }
        for (int i = 0; i < count; ++i)
            row[x0 + i] = flow_texel::pack(whole(dx[i]), whole(dy[i]),
                                           flow_texel::kNoiseZero + whole(noise[i] * float(flow_texel::kNoiseMost))) &
                          flows[i];
        if (!fineVectors) continue;
        for (int i = 0; i < count; ++i) {
            // The number x is read with that of y below it.
            const std::uint32_t low = std::uint32_t(whole(dy[i] * FineFlow::kPerUnit)) & 0xFFFFu;
            const std::int32_t high = whole(dx[i] * FineFlow::kPerUnit - double(low) * 0x1p-16);
            fineVectors[x0 + i] = (std::uint32_t(high) << 16 | low) & flows[i];
            fineNoise[x0 + i] = std::uint16_t(
                FineFlow::kNoiseZero + whole(noise[i] * float(flow_texel::kNoiseMost * FineFlow::kNoisePerByte)));
        }
    }
}

/// Repeats a row beside itself, from x0 to x1.
template <class T>
void repeatRow(T* row, int width, int x0, int x1)
{
    for (int x = -1; x >= x0; --x) row[x] = row[x + width];
    for (int x = width; x < x1; ++x) row[x] = row[x - width];
}

void PlaneRows::fill(const Extent& extent, int fresh, GBuffer& buffer, cpu::FineFlow* fine) const
{
    buffer.rollFlow(extent);
    if (fine) fine->roll(extent);
    buffer.flowUnitPx = float(flowUnitPx_);
    const int width = flow_.width, height = flow_.height;
    const auto rowsFrom = [&](int first, const auto& body) {
        parallelRanges(std::size_t(extent.y1 - first), grain, [&](std::size_t begin, std::size_t end) {
            for (int y = first + int(begin); y < first + int(end); ++y) body(y);
        });
    };
    rowsFrom(std::max(fresh, extent.y0), [&](int y) {
        std::uint32_t* row = buffer.flow.row(y);
        std::uint32_t* vectors = fine ? fine->vectors.row(y) : nullptr;
        std::uint16_t* noise = fine ? fine->noise.row(y) : nullptr;
        fillRow((y % height + height) % height, row, vectors, noise);
        repeatRow(row, width, extent.x0, extent.x1);
        if (!fine) return;
        repeatRow(vectors, width, extent.x0, extent.x1);
        repeatRow(noise, width, extent.x0, extent.x1);
    });
    rowsFrom(std::max(fresh - limits::kLinkRows, extent.y0), [&](int y) {
        linkRow(buffer.flow.row(y - 1) + extent.x0, buffer.flow.row(y) + extent.x0, buffer.flow.row(y + 1) + extent.x0,
                extent.width(), buffer.links.row(y) + extent.x0);
    });
}

}  // namespace aeolic
