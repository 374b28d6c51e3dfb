#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "aeolic/error.h"
#include "aeolic/plane.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "description/option_table.h"
#include "description/validate.h"
#include "render/cpu/lic/lic_stage.h"
#include "render/noise.h"
#include "render/view.h"

namespace aeolic {
namespace {

constexpr std::size_t grain = 16;  // Rows.

/// A number from -1 to 1 for each pixel, with the variance that the contrast is made for.
float whiteNoise(std::uint32_t pixel, std::uint32_t seed)
{
    std::uint32_t x = pixel * 0x9e3779b9u ^ (seed + 0x7f4a7c15u) * 0x85ebca6bu;  // Two rounds of a finaliser mix it.
    for (int round = 0; round < 2; ++round) {
        x ^= x >> 16;
        x *= 0x7feb352du;
        x ^= x >> 15;
        x *= 0x846ca68bu;
        x ^= x >> 16;
    }
    const double uniform = 2.0 * double(x) / double(std::numeric_limits<std::uint32_t>::max()) - 1;
    return float(std::sqrt(3.0) * kNoiseSigma * uniform);
}

/// What values of a texture are as noise.
struct TextureScale {
    float middle = 0, perUnit = 0;

    explicit TextureScale(std::span<const float> texture)
    {
        float lo = std::numeric_limits<float>::max(), hi = std::numeric_limits<float>::lowest();
        for (const float value : texture) {
            if (!std::isfinite(value)) continue;
            lo = std::min(lo, value);
            hi = std::max(hi, value);
        }
        if (!(lo < hi)) return;
        middle = 0.5F * lo + 0.5F * hi;
        perUnit = 1 / (0.5F * hi - 0.5F * lo);
        if (!std::isfinite(perUnit)) perUnit = 0;
    }
    float operator()(float value) const { return std::isfinite(value) ? (value - middle) * perUnit : 0; }
};

/// The plane as the LIC stage reads a picture; where it is periodic with a border of what lies at the other end.
class PlaneBuffer {
public:
    PlaneBuffer(const PlaneFlow& flow, const LicOptions& lic)
        : flow_(flow), lic_(lic), border_(flow.periodic ? int(std::ceil(lic.steps * lic.stepPx)) + 8 : 0)
    {
        const std::int64_t width = flow.width + 2 * std::int64_t(border_),
                           height = flow.height + 2 * std::int64_t(border_);
        constexpr std::int64_t bytesPerPixel = 120;  // G-buffer, cells, and the hierarchy's levels.
        requireMemory("lic2d", fmt::format("a plane of {} x {} pixels", width, height),
                      std::uint64_t(width * height * bytesPerPixel));
        buffer_.resize({0, 0, int(width), int(height)}, false);
        const double powerOfTwo = std::exp2(std::ceil(std::log2(std::max(lic.stepPx, 1e-3))));
        buffer_.flowUnitPx = float(powerOfTwo / (flow_texel::kDisplacementMax + 1));
        fill();
        link();
    }
    GBuffer& buffer() { return buffer_; }
    int border() const { return border_; }

private:
    /// The pixel of the plane that is shown at column or row `at` of the buffer.
    int source(int at, int size) const { return ((at - border_) % size + size) % size; }

    void fill()
    {
        const std::size_t pixels = std::size_t(flow_.width) * std::size_t(flow_.height);
        double longest = 0;
        for (std::size_t i = 0; i < pixels; ++i) {
            const double length = std::hypot(double(flow_.u[i]), double(flow_.v[i]));
            if (std::isfinite(length)) longest = std::max(longest, length);
        }
        const TextureScale scale(flow_.texture ? std::span(flow_.texture, pixels) : std::span<const float>());
        parallelRanges(std::size_t(buffer_.valid().height()), grain, [&](std::size_t begin, std::size_t end) {
            for (int y = int(begin); y < int(end); ++y)
                for (int x = 0; x < buffer_.valid().x1; ++x) {
                    const std::size_t i = std::size_t(source(y, flow_.height)) * std::size_t(flow_.width) +
                                          std::size_t(source(x, flow_.width));
                    const float noise =
                        flow_.texture ? scale(flow_.texture[i]) : whiteNoise(std::uint32_t(i), lic_.seed);
                    buffer_.flow.at(x, y) = texel(i, longest, noise);
                    buffer_.invDepth.at(x, y) = buffer_.flow.at(x, y) == 0 ? 0.0F : 1.0F;
                    buffer_.gradX.at(x, y) = buffer_.gradY.at(x, y) = 0;
                    buffer_.light.at(x, y) = 1;
                }
        });
    }

    std::uint32_t texel(std::size_t i, double longest, float noise) const
    {
        const double u = double(flow_.u[i]), v = double(flow_.v[i]), length = std::hypot(u, v);
        if (!std::isfinite(length)) return 0;
        // The direction of a vector shorter than a millionth of the longest is the data's rounding noise.
        const double reference = lic_.normalize ? (length > 1e-6 * longest ? length : 0) : longest;
        const double units = reference > 0 ? lic_.stepPx / double(buffer_.flowUnitPx) / reference : 0;
        const auto rounded = [](double value) {
            return int(std::clamp(std::round(value), -double(flow_texel::kDisplacementMax),
                                  double(flow_texel::kDisplacementMax)));
        };
        const int byte =
            flow_texel::kNoiseZero + int(std::round(std::clamp(noise, -1.0F, 1.0F) * float(flow_texel::kNoiseMost)));
        return flow_texel::pack(rounded(u * units), rounded(v * units), byte);
    }

    /// To each of the eight neighbours where there is flow, too.
    void link()
    {
        const Extent& valid = buffer_.valid();
        parallelRanges(std::size_t(valid.height()), grain, [&](std::size_t begin, std::size_t end) {
            for (int y = int(begin); y < int(end); ++y)
                for (int x = 0; x < valid.x1; ++x) {
                    int bits = 0;
                    for (int sy = -1; sy <= 1; ++sy)
                        for (int sx = -1; sx <= 1; ++sx) {
                            const int nx = x + sx, ny = y + sy;
                            const bool inside = nx >= 0 && ny >= 0 && nx < valid.x1 && ny < valid.y1;
                            if ((sx != 0 || sy != 0) && inside && buffer_.flow.at(nx, ny) != 0)
                                bits |= 1 << linkBit(sx, sy);
                        }
                    buffer_.links.at(x, y) = std::uint8_t(buffer_.flow.at(x, y) == 0 ? 0 : bits);
                }
        });
    }

    const PlaneFlow& flow_;
    const LicOptions& lic_;
    const int border_;
    GBuffer buffer_;
};

/// Traces go no farther than kLongestStepPx at once: a longer step is walked in parts.
LicOptions inShortSteps(LicOptions lic)
{
    const int parts = int(std::ceil(lic.stepPx / double(kLongestStepPx)));
    lic.steps *= parts;
    lic.stepPx /= parts;
    lic.noiseScale = 1;
    return lic;
}

void check(const PlaneFlow& flow, const LicOptions& lic)
{
    SceneDescription scene;
    scene.lic = lic;
    validate(scene, commandLineName);
    for (const int side : {flow.width, flow.height})
        if (!options::side.accepts(side))
            throw InputError(
                "lic2d", fmt::format("a plane of {} x {} pixels", flow.width, flow.height),
                fmt::format("from {:.0f} to {:.0f} in each direction", options::side.lo, options::side.hi));
}

}  // namespace

std::vector<float> licOfPlane(const PlaneFlow& flow, const LicOptions& lic)
{
    check(flow, lic);
    const LicOptions inParts = inShortSteps(lic);
    PlaneBuffer plane(flow, inParts);
    cpu::LicStage stage;
    stage.run(plane.buffer(), inParts, plane.buffer().valid(), nullptr);
    stage.smooth(plane.buffer(), inParts, plane.buffer().valid(), nullptr);
    std::vector<float> values(std::size_t(flow.width) * std::size_t(flow.height));
    parallelRanges(std::size_t(flow.height), grain, [&](std::size_t begin, std::size_t end) {
        for (int y = int(begin); y < int(end); ++y)
            for (int x = 0; x < flow.width; ++x) {
                const int bx = x + plane.border(), by = y + plane.border();
                values[std::size_t(y) * std::size_t(flow.width) + std::size_t(x)] =
                    plane.buffer().flow.at(bx, by) == 0 ? std::numeric_limits<float>::quiet_NaN()
                                                        : stage.values().at(bx, by);
            }
    });
    return values;
}

}  // namespace aeolic
