#include <algorithm>

#include "reference/reference.h"
#include "render/flatten.h"

namespace aeolic::reference {

std::vector<double> flatten(const PixelImage& image, const std::vector<double>& values, int reachPx)
{
    std::vector<double> out = values;
    const auto at = [&](int x, int y) { return std::size_t(y) * std::size_t(image.width) + std::size_t(x); };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            if (!image.at(x, y).hasFlow) continue;
            double sum = 0;
            int count = 0;
            for (int v = std::max(y - reachPx, 0); v <= std::min(y + reachPx, image.height - 1); ++v)
                for (int u = std::max(x - reachPx, 0); u <= std::min(x + reachPx, image.width - 1); ++u) {
                    if (!image.at(u, v).hasFlow) continue;
                    sum += values[at(u, v)];
                    ++count;
                }
            out[at(x, y)] = (out[at(x, y)] - sum / count) * double(aeolic::flatten::kGain);
        }
    return out;
}

}  // namespace aeolic::reference
