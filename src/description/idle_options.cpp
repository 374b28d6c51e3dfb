#include "description/idle_options.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "description/overlays.h"
#include "description/surface_spec.h"

namespace aeolic {
namespace {

bool hasColors(const SceneDescription& scene)
{
    const std::vector<SurfaceItem> items = surfacesOf(scene);
    return std::any_of(items.begin(), items.end(),
                       [&](const SurfaceItem& item) { return !colorByOf(item, scene).empty(); });
}

/// Finds those of the options that were given, and says why each has no effect.
struct Finder {
    const std::map<std::string, std::string>& given;
    std::vector<std::string> found;

    void add(std::initializer_list<std::string_view> names, std::string_view why)
    {
        for (const std::string_view name : names)
            if (given.contains(std::string(name)))
                found.push_back(std::string(name) + " has no effect " + std::string(why));
    }
    /// For a switch, only where it was switched on.
    void addSwitch(std::string_view name, bool isOn, std::string_view why)
    {
        if (isOn) add({name}, why);
    }
};

}  // namespace

std::vector<std::string> idleOptions(const SceneDescription& scene, const std::map<std::string, std::string>& given,
                                     bool moves)
{
    Finder finder{given, {}};
    if (scene.field.spec.empty())
        finder.add({"--offset", "--resample-spacing", "--field-precision"}, "without --field");
    if (!moves) {
        finder.add({"--time", "--time-range"}, "on data that do not change in time");
        finder.addSwitch("--time-stamp", scene.shading.timeStamp, "on data that do not change in time");
    }
    if (scene.lic.method == LicMethod::hierarchical) finder.add({"--integrator"}, "without --lic direct");
    if (scene.lic.method == LicMethod::none) {
        finder.add({"--style", "--kernel", "--streaks", "--phase", "--magnitude", "--noise-scale"}, "with --lic none");
        finder.addSwitch("--flow", scene.lic.flow == FlowMotion::loop, "with --lic none");
    } else if (scene.lic.flow == FlowMotion::loop) {
        finder.add({"--kernel"}, "with --flow loop");
    } else if (scene.lic.style == Style::oriented) {
        finder.add({"--kernel", "--phase"}, "with --style oriented");
    } else if (scene.lic.kernel != Kernel::hann) {
        finder.add({"--phase"}, "without --kernel hann");
    }
    if (scene.lic.magnitude == Magnitude::length) finder.add({"--normalize"}, "with --magnitude length");
    const bool hasBar = hasColors(scene) || scene.lic.magnitude != Magnitude::none;
    if (!hasBar) finder.addSwitch("--scalar-bar", scene.shading.scalarBar, "without --color-by");
    if (!hasColors(scene)) {
        finder.add({"--colormap", "--color-range", "--color-scale", "--nan-color", "--below-color", "--above-color"},
                   "without --color-by");
        finder.add({"--legend"}, "without --color-by");
    }
    if (!scene.shading.lighting) finder.addSwitch("--occlusion", scene.shading.occlusion, "with --lighting off");
    const Overlays overlays = overlaysOf(scene.shading.overlay);
    if (!overlays.topology && !overlays.separation)
        finder.add({"--persistence"}, "without --overlay topology or separation");
    if (scene.output.frames == 1) {
        finder.add({"--fps", "--orbit"}, "without --frames");
        if (moves && given.contains("--time-range"))
            finder.found.emplace_back("--time-range shows its first moment alone without --frames");
    }
    return finder.found;
}

}  // namespace aeolic
