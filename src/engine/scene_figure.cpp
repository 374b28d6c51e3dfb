#include "engine/scene_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "description/color_scale.h"
#include "render/palette.h"

namespace aeolic {
namespace {

ScalarBar scalarBarOf(const ShadingOptions& shading, const ColorMap& map, const Scene& scene)
{
    const auto range = shownRange(shading, scene.scalarRange);
    const auto beyond = [](const std::string& own, const std::optional<Color>& ofFile) {
        return own.empty() ? ofFile : std::optional<Color>(colorOf(own));
    };
    return {shownColors(shading, map),
            range[0],
            range[1],
            colorScaleOf(shading.colorScale),
            shading.legend.empty() ? scene.scalarName : shading.legend,
            beyond(shading.belowColor, map.below),
            beyond(shading.aboveColor, map.above)};
}

}  // namespace

std::string timeStampOf(double time, const std::vector<double>& times)
{
    const double span = times.empty() ? 0 : times.back() - times.front();
    const double largest = times.empty() ? 0 : std::max(std::abs(times.front()), std::abs(times.back()));
    if (!(span > 0) || largest >= 1e7 || span < 1e-6) return fmt::format("t = {:.6g}", time);
    return fmt::format("t = {:.{}f}", time, std::clamp(3 - int(std::ceil(std::log10(span))), 0, 9));
}

Figure figureOf(const StartedFrame& frame, const Scene& scene, const std::vector<double>& times)
{
    const ShadingOptions& shading = frame.shading;
    Figure figure;
    figure.inks = inksFor(shading.background);
    figure.title = shading.title;
    if (scene.hasScalar && shading.scalarBar && frame.colorMap)
        figure.bar = scalarBarOf(shading, *frame.colorMap, scene);
    if (shading.axes) figure.axes = Orientation{frame.camera.right, frame.camera.up, frame.camera.forward};
    if (shading.timeStamp && !times.empty()) figure.stamp = timeStampOf(frame.time, times);
    return figure;
}

}  // namespace aeolic
