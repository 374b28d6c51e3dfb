#include "engine/picture_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "description/color_scale.h"
#include "description/option_rules.h"
#include "description/scene_text.h"
#include "engine/scene_figure.h"
#include "render/overlay/drawn_text.h"
#include "render/palette.h"

namespace aeolic {
namespace {

void addScale(const ShadingOptions& shading, const std::string& surface, const std::string& array,
              const std::array<double, 2>& range, std::vector<std::string>& warnings)
{
    if (!lacksLogarithm(shading, range)) return;
    warnings.push_back(
        fmt::format("{}: '{}' is nowhere above 0, as --color-scale log needs it: its colours are on a linear scale",
                    surface, array));
}

void addScales(const ShadingOptions& shading, const Scene& scene, std::vector<std::string>& warnings)
{
    if (scene.surfaces.empty()) {
        if (scene.hasScalar && scene.scalarRangeKnown)
            addScale(shading, scene.surface.name, scene.scalarName, scene.scalarRange, warnings);
        return;
    }
    for (const SceneColors& colors : scene.colors)
        if (colors.rangeKnown)
            addScale(shadingOf(shading, colors), scene.surface.name, colors.name, colors.range, warnings);
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

}  // namespace

std::vector<std::string> pictureWarnings(const StartedFrame& frame, const LicOptions& lic, const Scene& scene,
                                         const std::vector<double>& times, int width, int height)
{
    std::vector<std::string> warnings;
    addScales(frame.shading, scene, warnings);
    // The longest vector is that of the first moment; others may have longer ones.
    if (times.empty() && scene.maxVector > 0 && lic.maskBelow > scene.maxVector && lic.method != LicMethod::none)
        warnings.push_back(fmt::format("{}: no streaks show: the longest vector is {:.3g}, and --mask-below {}",
                                       scene.surface.name, scene.maxVector, numberText(lic.maskBelow)));
    const Figure figure = figureOf(frame, scene, times);
    addUnknownCharacters(figure, warnings);
    const std::string leftOut = FigureLayout(figure, width, height).leftOut(figure);
    if (!leftOut.empty())
        warnings.push_back("the picture has no room for " + leftOut +
                           ": a larger --size or a smaller --text-scale may give it");
    return warnings;
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
