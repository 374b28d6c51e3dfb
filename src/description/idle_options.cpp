#include "description/idle_options.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "description/overlays.h"
#include "description/scene_surfaces.h"

namespace aeolic {
namespace {

bool hasColors(const SceneDescription& scene)
{
    const std::vector<SurfaceItem> items = surfacesOf(scene);
    return std::any_of(items.begin(), items.end(),
                       [&](const SurfaceItem& item) { return !colorByOf(item, scene).empty(); });
}

}  // namespace

std::vector<std::string> idleOptions(const SceneDescription& scene, const std::map<std::string, std::string>& given,
                                     bool moves)
{
    std::vector<std::string> found;
    const auto add = [&](std::initializer_list<const char*> names, const char* why) {
        for (const char* const name : names)
            if (given.contains(name)) found.push_back(std::string(name) + " has no effect " + why);
    };
    // A switch is told of only where it was switched on: off, it has nothing to do.
    const auto addSwitch = [&](const char* name, bool isOn, const char* why) {
        if (isOn) add({name}, why);
    };
    if (scene.field.spec.empty()) add({"--offset", "--resample-spacing", "--field-precision"}, "without --field");
    if (!moves) {
        add({"--time", "--time-range"}, "on data that do not change in time");
        addSwitch("--time-stamp", scene.shading.timeStamp, "on data that do not change in time");
    }
    if (scene.lic.method == LicMethod::hierarchical) add({"--integrator"}, "without --lic direct");
    if (scene.lic.method == LicMethod::none) {
        add({"--style", "--kernel", "--streaks", "--phase", "--magnitude", "--noise-scale"}, "with --lic none");
        addSwitch("--flow", scene.lic.flow == FlowMotion::loop, "with --lic none");
    } else if (scene.lic.flow == FlowMotion::loop) {
        add({"--kernel"}, "with --flow loop");
    } else if (scene.lic.style == Style::oriented) {
        add({"--kernel", "--phase"}, "with --style oriented");
    } else if (scene.lic.kernel != Kernel::hann) {
        add({"--phase"}, "without --kernel hann");
    }
    if (scene.lic.magnitude == Magnitude::length) add({"--normalize"}, "with --magnitude length");
    const bool hasBar = hasColors(scene) || scene.lic.magnitude != Magnitude::none;
    if (!hasBar) addSwitch("--scalar-bar", scene.shading.scalarBar, "without --color-by");
    if (!hasColors(scene)) {
        add({"--colormap", "--color-range", "--color-scale", "--nan-color", "--below-color", "--above-color",
             "--legend"},
            "without --color-by");
    }
    if (!scene.shading.lighting) addSwitch("--occlusion", scene.shading.occlusion, "with --lighting off");
    const Overlays overlays = overlaysOf(scene.shading.overlay);
    if (!overlays.topology && !overlays.separation) add({"--persistence"}, "without --overlay topology or separation");
    if (scene.output.frames == 1) {
        add({"--fps", "--orbit"}, "without --frames");
        if (moves && given.contains("--time-range"))
            found.emplace_back("--time-range shows its first moment alone without --frames");
    }
    return found;
}

}  // namespace aeolic
