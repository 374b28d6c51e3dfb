#include "engine/picture_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "description/color_scale.h"
#include "description/option_rules.h"
#include "description/overlays.h"
#include "description/scene_text.h"
#include "engine/scene_figure.h"
#include "render/overlay/drawn_text.h"
#include "render/palette.h"

namespace aeolic {
namespace {

/// What is said of the values of an array and their colours. `range`: what the map spans, unless the options say
/// otherwise; `all` and `robust`: of all values, and of 96 % of the area.
void addScale(const ShadingOptions& shading, const std::string& surface, const std::string& array,
              const std::array<double, 2>& range, const std::array<double, 2>& all, const std::array<double, 2>& robust,
              std::vector<std::string>& warnings)
{
    if (lacksLogarithm(shading, range))
        warnings.push_back(
            fmt::format("{}: '{}' is nowhere above 0, as --color-scale log needs it: its colours are on a linear scale",
                        surface, array));
    // After a run that diverged, a few wild values leave one colour for nearly all of the surface.
    constexpr double kWild = 200;  // Times the range of 96 % of the area: the others share one colour.
    const double width = robust[1] - robust[0];
    const bool isWild = width > 0 && all[1] - all[0] > kWild * width;
    if (!isWild || shading.colorRange || shading.colorRangeOf != RangeOf::data ||
        colorScaleOf(shading.colorScale).kind == ColorScale::Kind::log)
        return;
    warnings.push_back(
        fmt::format("{}: '{}' is from {:.3g} to {:.3g}, but on 96 % of the area from {:.3g} to {:.3g}, which have one "
                    "colour; try --color-range {:.4g},{:.4g}, or robust",
                    surface, array, all[0], all[1], robust[0], robust[1], robust[0], robust[1]));
}

void addScales(const ShadingOptions& shading, const Scene& scene, std::vector<std::string>& warnings)
{
    const std::string& surface = scene.surface.name;
    if (scene.surfaces.empty()) {
        if (scene.hasScalar && scene.scalarRangeKnown)
            addScale(shading, surface, scene.scalarName, scene.rangeFor(shading), scene.scalarRange, scene.robustRange,
                     warnings);
        return;
    }
    for (const SceneColors& colors : scene.colors) {
        const ShadingOptions own = shadingOf(shading, colors);
        if (colors.rangeKnown)
            addScale(own, surface, colors.name, colors.rangeFor(own), colors.range, colors.robustRange, warnings);
    }
}

/// Texts of the figure whose characters the font does not have: they become boxes.
void addUnknownCharacters(const Figure& figure, std::vector<std::string>& warnings)
{
    constexpr double anySize = 10;
    const auto add = [&](const char* what, const std::string& text) {
        const bool isPlain = std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
        const std::string unknown = isPlain ? "" : TextPainter(anySize).unknownIn(text);
        if (!unknown.empty())
            warnings.push_back(fmt::format("{}: the font has no picture of '{}': boxes stand for that", what, unknown));
    };
    add("the title", figure.title);
    for (const ScalarBar& bar : figure.bars) add("the legend", bar.title);
}

/// The picture tells which way the flow goes.
bool showsDirection(const LicOptions& lic, const ShadingOptions& shading)
{
    const Overlays overlays = overlaysOf(shading.overlay);
    const bool movesOrPoints = lic.style == Style::oriented || lic.flow != FlowMotion::off;
    return (movesOrPoints && lic.method != LicMethod::none) || overlays.topology || overlays.separation ||
           overlays.streamlinesPx > 0 || overlays.through;
}

}  // namespace

std::string againstFlowWarning(const Scene& scene)
{
    if (!scene.againstFlow) return "";
    const auto& [surface, array] = *scene.againstFlow;
    return fmt::format("{}: OpenFOAM's '{}' points against the flow; {} turns it round", surface, array,
                       scene.surfaces.empty() ? fmt::format("--vectors 'reversed({})'", array)
                                              : fmt::format("\"vectors\": \"reversed({})\" of this surface", array));
}

std::vector<std::string> pictureWarnings(const StartedFrame& frame, const Scene& scene,
                                         const std::vector<double>& times, int width, int height)
{
    const LicOptions& lic = frame.request.lic;
    std::vector<std::string> warnings;
    addScales(frame.request.shading, scene, warnings);
    // The longest vector is that of the first moment; others may have longer ones.
    if (times.empty() && scene.maxVector > 0 && lic.maskBelow > scene.maxVector && lic.method != LicMethod::none)
        warnings.push_back(fmt::format("{}: no streaks show: the longest vector is {:.3g}, and --mask-below {}",
                                       scene.surface.name, scene.maxVector, numberText(lic.maskBelow)));
    if (scene.againstFlow && showsDirection(lic, frame.request.shading)) warnings.push_back(againstFlowWarning(scene));
    const Figure figure = figureOf(frame, scene, times);
    addUnknownCharacters(figure, warnings);
    const std::string leftOut = FigureLayout(figure, width, height).leftOut(figure);
    if (!leftOut.empty())
        warnings.push_back("the picture has no room for " + leftOut +
                           ": a larger --size or a smaller --text-scale may give it");
    return warnings;
}

std::string restWarning(const SceneDescription& description, const Scene& scene, double shown,
                        const std::vector<double>& times)
{
    const bool animated = description.time.range && description.output.frames > 1;
    if (!scene.restsAt || shown != *scene.restsAt || animated || description.lic.method == LicMethod::none) return "";
    return fmt::format("{}: at the moment {} all vectors are zero; try --time {}", scene.surface.name,
                       numberText(shown), numberText(times.back()));
}

std::string momentWarning(const SceneDescription& description, const std::optional<std::array<double, 2>>& span)
{
    const TimeOptions& time = description.time;
    const bool animated = time.range && description.output.frames > 1;
    if (!span || (!time.moment && !time.range)) return "";
    const std::vector<double> asked = time.moment ? std::vector{*time.moment}
                                      : animated  ? std::vector{(*time.range)[0], (*time.range)[1]}
                                                  : std::vector{(*time.range)[0]};
    // `aeolic info` and people write moments with six digits.
    const double rounding = 1e-5 * std::max(std::abs((*span)[0]), std::abs((*span)[1]));
    const auto isOutside = [&](double moment) {
        return moment < (*span)[0] - rounding || moment > (*span)[1] + rounding;
    };
    if (std::none_of(asked.begin(), asked.end(), isOutside)) return "";
    return fmt::format("{} {}: the data have moments from {:.6g} to {:.6g}; outside of them the nearest one is shown",
                       time.moment ? "--time" : "--time-range",
                       optionText(description, time.moment ? "--time" : "--time-range"), (*span)[0], (*span)[1]);
}

}  // namespace aeolic
