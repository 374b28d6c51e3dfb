#include "engine/scene_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "description/color_scale.h"
#include "render/palette.h"

namespace aeolic {
namespace {

ScalarBar scalarBarOf(const ShadingOptions& shading, const ColorMap& map, const std::array<double, 2>& dataRange,
                      const std::string& name)
{
    const auto range = shownRange(shading, dataRange);
    const auto beyond = [](const std::string& own, const std::optional<Color>& ofFile) {
        return own.empty() ? ofFile : std::optional<Color>(colorOf(own));
    };
    return {shownColors(shading, map),
            range[0],
            range[1],
            shownScale(shading, dataRange),
            shading.legend.empty() ? name : shading.legend,
            beyond(shading.belowColor, map.below),
            beyond(shading.aboveColor, map.above)};
}

/// One bar, or, of several surfaces, one for each kind of colours that is shown.
std::vector<ScalarBar> barsOf(const StartedFrame& frame, const Scene& scene)
{
    const ShadingOptions& shading = frame.request.shading;
    if (scene.surfaces.empty())
        return {scalarBarOf(shading, *frame.request.colorMap, scene.rangeFor(shading), scene.scalarName)};
    std::vector<ScalarBar> bars;
    for (std::size_t i = 0; i < scene.colors.size(); ++i) {
        const SceneColors& colors = scene.colors[i];
        const auto has = [&](const SceneSurface& surface) { return surface.shown && surface.colors == int(i); };
        if (std::any_of(scene.surfaces.begin(), scene.surfaces.end(), has))
            bars.push_back(scalarBarOf(shadingOf(shading, colors), *frame.request.colorMaps[i],
                                       colors.rangeFor(shading), colors.name));
    }
    return bars;
}

/// How long vectors are where streaks show in full, or have their length.
std::optional<ScalarBar> streaksBar(const StartedFrame& frame, const Scene& scene)
{
    const LicOptions& lic = frame.request.lic;
    if (lic.magnitude == Magnitude::none || lic.method == LicMethod::none || !(scene.maxVector > 0)) return {};
    ScalarBar bar;
    bar.colors = {Color{170, 170, 170}};
    const bool fades = lic.magnitude == Magnitude::contrast;
    bar.hi = fades ? scene.fullStreaks() : scene.maxVector;
    const std::string name = scene.vectorsName.empty() ? "vectors" : scene.vectorsName;
    bar.title = "streaks: " + name + " along the surface";
    bar.fill = fades ? BarFill::fadingStreaks : BarFill::shorterStreaks;
    return bar;
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
    const ShadingOptions& shading = frame.request.shading;
    Figure figure;
    figure.inks = inksFor(shading.background);
    figure.textScale = shading.textScale;
    figure.title = shading.title;
    if (scene.hasScalar && shading.scalarBar) figure.bars = barsOf(frame, scene);
    if (shading.scalarBar)
        if (auto bar = streaksBar(frame, scene)) figure.bars.push_back(std::move(*bar));
    if (shading.axes)
        figure.axes = Orientation{frame.request.camera.right, frame.request.camera.up, frame.request.camera.forward};
    if (shading.timeStamp && !times.empty()) {
        figure.stamp = timeStampOf(frame.time, times);
        // Digits are as wide as each other, so one of the ends has the widest.
        for (const double end : frame.timeRange.value_or(std::array{times.front(), times.back()}))
            figure.otherStamps.push_back(timeStampOf(end, times));
    }
    return figure;
}

}  // namespace aeolic
