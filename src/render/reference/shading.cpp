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
        const double m = double(palette.blend) * std::erf(double(palette.contrast) * lic[i] / std::sqrt(2.0));
        std::array<double, 3> base;
        base.fill(1 - 0.5 * double(palette.blend));
        double highlight = 1, shadow = 1;
        if (palette.useScalar) {
            highlight = double(shading::kColorHighlight);
            shadow = double(shading::kColorShadow);
            if (std::isnan(p.scalar)) {
                base.fill(double(shading::kMaskedBase));
            } else {
                const double entry =
                    std::clamp((p.scalar - double(palette.scalarLo)) * double(palette.entriesPerScalar), 0.0, 255.0);
                const std::uint32_t color = palette.table[std::size_t(entry)];
                for (std::size_t c = 0; c < 3; ++c) base[c] = (color >> (8 * c) & 255) / 255.0;
            }
        }
        for (std::size_t c = 0; c < 3; ++c) {
            const double shown = m < 0 ? base[c] * (1 + shadow * m) : base[c] + (1 - base[c]) * highlight * m;
            out[i][c] = std::clamp(255 * shown * (palette.lighting ? p.light : 1.0), 0.0, 255.0);
        }
        out[i][3] = 255;
    }
    return out;
}

}  // namespace aeolic::reference
