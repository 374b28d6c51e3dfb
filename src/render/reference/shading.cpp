#include <algorithm>
#include <cmath>

#include "render/reference/reference.h"
#include "render/shading_model.h"

namespace aeolic::reference {

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
        const double m = std::erf(double(palette.contrast) * lic[i] / std::sqrt(2.0)), blend = double(palette.blend);
        std::array<double, 3> base, dark, bright;
        double knee = 0;
        if (palette.useScalar) {
            std::size_t entry = Palette::kMasked;
            if (!std::isnan(p.scalar))
                entry = std::size_t(
                    std::clamp((p.scalar - double(palette.scalarLo)) * double(palette.entriesPerScalar), 0.0, 255.0));
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
        for (std::size_t c = 0; c < 3; ++c) {
            const double shown = m < knee ? base[c] + (dark[c] - base[c]) * (knee - m) / (1 + knee)
                                          : base[c] + (bright[c] - base[c]) * (m - knee) / (1 - knee);
            out[i][c] = std::clamp(255 * shown * (palette.lighting ? p.light : 1.0), 0.0, 255.0);
        }
        out[i][3] = 255;
    }
    return out;
}

}  // namespace aeolic::reference
