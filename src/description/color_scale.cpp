#include "description/color_scale.h"

#include "base/text.h"

namespace aeolic {
namespace {

constexpr std::string_view bandsPrefix = "bands:";
constexpr int mostBands = 256;           // As many colours as a map has.
constexpr double smallestShare = 0.001;  // Three decades are about what colours can tell apart.

int bandsIn(std::string_view text)
{
    if (!text.starts_with(bandsPrefix)) return 0;
    text.remove_prefix(bandsPrefix.size());
    const int bands = text.starts_with('0') ? 0 : wholeTextAs<int>(text).value_or(0);
    return bands >= 2 && bands <= mostBands ? bands : 0;
}

}  // namespace

bool isBands(std::string_view text)
{
    return bandsIn(text) > 0;
}

ColorScale colorScaleOf(std::string_view text)
{
    if (text == "log") return {ColorScale::Kind::log, 0};
    const int bands = bandsIn(text);
    return bands > 0 ? ColorScale{ColorScale::Kind::bands, bands} : ColorScale{};
}

bool lacksLogarithm(const ShadingOptions& shading, const std::array<double, 2>& dataRange)
{
    return colorScaleOf(shading.colorScale).kind == ColorScale::Kind::log && !shading.colorRange && !(dataRange[1] > 0);
}

ColorScale shownScale(const ShadingOptions& shading, const std::array<double, 2>& dataRange)
{
    return lacksLogarithm(shading, dataRange) ? ColorScale{} : colorScaleOf(shading.colorScale);
}

std::array<double, 2> shownRange(const ShadingOptions& shading, const std::array<double, 2>& dataRange)
{
    if (shading.colorRange) return *shading.colorRange;
    if (shownScale(shading, dataRange).kind != ColorScale::Kind::log || dataRange[0] > 0) return dataRange;
    return {smallestShare * dataRange[1], dataRange[1]};
}

}  // namespace aeolic
