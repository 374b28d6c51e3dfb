#include <algorithm>
#include <cmath>

#include "reference/reference.h"
#include "render/shading_model.h"

namespace aeolic::reference {
namespace {

std::size_t entryOf(const Palette& palette, double scalar)
{
    const double lo = double(palette.scalarLo), hi = double(palette.scalarHi), last = double(palette.lastEntry);
    if (std::isnan(scalar)) return Palette::kMasked;
    if (scalar < double(palette.lowest)) return Palette::kBelow;
    if (scalar > double(palette.highest)) return Palette::kAbove;
    if (!palette.searched) return std::size_t(std::clamp((scalar - lo) * double(palette.entriesPerScalar), 0.0, last));
    return std::size_t(std::clamp(std::floor(256 * std::log(scalar / lo) / std::log(hi / lo)), 0.0, last));
}

}  // namespace

std::vector<std::array<double, 4>> shade(const PixelImage& image, const std::vector<double>& lic,
                                         const Palette& palette)
{
    std::vector<std::array<double, 4>> out(image.pixels.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Pixel& p = image.pixels[i];
        if (p.invDepth <= 0) {
            for (std::size_t c = 0; c < 4; ++c) out[i][c] = palette.background[c];
            continue;
        }
        double m = std::erf(double(palette.contrast) * lic[i] / std::sqrt(2.0)), blend = double(palette.blend);
        std::array<double, 3> base, dark, bright;
        double knee = 0;
        if (palette.useScalar) {
            const std::size_t entry = entryOf(palette, p.scalar);
            const auto unpack = [](std::uint32_t word, std::array<double, 3>& color) {
                for (std::size_t c = 0; c < 3; ++c) color[c] = (word >> (8 * c) & 255) / 255.0;
            };
            unpack(palette.base[entry], base);
            unpack(palette.dark[entry], dark);
            unpack(palette.bright[entry], bright);
            knee = (palette.base[entry] >> 24) / double(shading::kKneeZero) - 1;
        } else {
            base.fill(1 - 0.5 * blend * blend * blend);
            dark.fill(1 - blend * blend);
            bright.fill(1 - 0.25 * blend * (1 - blend));
        }
        if (p.light < 0) m = knee;  // Masked.
        for (std::size_t c = 0; c < 3; ++c) {
            const double shown = m < knee ? base[c] + (dark[c] - base[c]) * (knee - m) / (1 + knee)
                                          : base[c] + (bright[c] - base[c]) * (m - knee) / (1 - knee);
            out[i][c] = std::clamp(255 * shown * (palette.lighting ? std::abs(p.light) : 1.0), 0.0, 255.0);
        }
        out[i][3] = 255;
    }
    return out;
}

}  // namespace aeolic::reference
