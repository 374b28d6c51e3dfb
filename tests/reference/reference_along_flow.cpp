#include "render/lic/along_flow.h"

#include <cmath>
#include <cstdlib>

#include "reference/reference.h"

namespace aeolic::reference {

std::vector<double> smooth(const PixelImage& image, const std::vector<double>& values, const LicOptions& lic)
{
    std::vector<double> out = values;
    const auto valueAt = [&](int x, int y) {
        return values[std::size_t(y) * std::size_t(image.width) + std::size_t(x)];
    };
    double most = 0;
    for (int k = 1; k <= limits::kAlongRows; ++k) most += 2 * double(along_flow::kWeights[k]);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Pixel& own = image.at(x, y);
            const double longer = std::max(std::abs(own.vx), std::abs(own.vy));
            if (!own.hasFlow || longer == 0) continue;
            double sum = double(along_flow::kWeights[0]) * valueAt(x, y), weight = 0;
            for (const int side : {1, -1}) {
                int atX = x, atY = y;
                for (int k = 1; k <= limits::kAlongRows; ++k) {
                    // The pixel nearest to the line; in the middle between two, the one farther from the axis.
                    const auto place = [&](double v) {
                        return int(std::copysign(std::floor(std::abs(v) / longer * k + 0.5), v));
                    };
                    const int toX = x + side * place(own.vx), toY = y + side * place(own.vy);
                    if (!image.at(atX, atY).linked[std::size_t((toY - atY + 1) * 3 + toX - atX + 1)]) break;
                    atX = toX;
                    atY = toY;
                    sum += double(along_flow::kWeights[k]) * valueAt(atX, atY);
                    weight += double(along_flow::kWeights[k]);
                }
            }
            const double raised = 1 + (double(along_flow::gain(lic)) - 1) * weight / most;
            out[std::size_t(y) * std::size_t(image.width) + std::size_t(x)] =
                sum / (weight + double(along_flow::kWeights[0])) * raised;
        }
    return out;
}

}  // namespace aeolic::reference
