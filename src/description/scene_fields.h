#pragma once

/// The one table of a scene's fields: what each is called in the scene JSON and on the command line, and what it may
/// be. Reading, writing, checking and the command line all walk this table, so they cannot disagree.

#include <limits>
#include <string_view>

#include "aeolic/scene_description.h"
#include "description/field_rules.h"

namespace aeolic {

struct FieldName {
    const char* group;   ///< In the JSON: the object it stands in …
    const char* key;     ///< … and its key there, both as in SceneDescription.
    const char* option;  ///< On the command line.
};

namespace fields {

inline constexpr std::string_view licMethodNames[] = {"none", "direct", "hierarchical"};
inline constexpr std::string_view integratorNames[] = {"euler", "rk2", "rk4"};
inline constexpr std::string_view kernelNames[] = {"box", "hann"};

inline constexpr double largest = std::numeric_limits<double>::max();
inline constexpr NumberRule finite{-largest, largest};
inline constexpr NumberRule angle{-1e6, 1e6};         // Beyond, a double's turns are no longer exact to a pixel.
inline constexpr NumberRule coordinate{-1e30, 1e30};  // Squares must stay finite in float.

bool isBackground(std::string_view text);
bool isColorMap(std::string_view text);
bool isPrecision(std::string_view text);
bool isBackend(std::string_view text);
bool isBalance(std::string_view text);
bool isBricks(std::string_view text);
bool isGuard(std::string_view text);
bool isGuardRows(std::string_view text);
inline bool isAnything(std::string_view)
{
    return true;
}
inline bool isSomething(std::string_view text)
{
    return !text.empty();
}

const char* expectedColorMap();

}  // namespace fields

/// Calls visit(FieldName, value&, rule) for every field of a SceneDescription (const or not), in the order of the
/// structs.
template <class Scene, class Visit>
void forEachField(Scene& scene, Visit&& visit)
{
    using namespace fields;
    const TextRule anyName{"a name", isAnything};
    const EnumRule methods{licMethodNames}, integrators{integratorNames}, kernels{kernelNames};

    auto& surface = scene.surface;
    visit(FieldName{"surface", "spec", "--surface"}, surface.spec,
          TextRule{"a file or a built-in surface", isSomething});
    visit(FieldName{"surface", "featureAngleDeg", "--feature-angle"}, surface.featureAngleDeg, NumberRule{0, 180});

    auto& field = scene.field;
    visit(FieldName{"field", "spec", "--field"}, field.spec, anyName);
    visit(FieldName{"field", "precision", "--field-precision"}, field.precision,
          TextRule{"float or half", isPrecision});
    visit(FieldName{"field", "vectors", "--vectors"}, field.vectors, anyName);
    visit(FieldName{"field", "resampleSpacing", "--resample-spacing"}, field.resampleSpacing,
          NumberRule{0, largest, true});

    auto& time = scene.time;
    visit(FieldName{"time", "moment", "--time"}, time.moment, coordinate);
    visit(FieldName{"time", "range", "--times"}, time.range, coordinate);

    auto& lic = scene.lic;
    visit(FieldName{"lic", "method", "--lic"}, lic.method, methods);
    visit(FieldName{"lic", "integrator", "--integrator"}, lic.integrator, integrators);
    visit(FieldName{"lic", "steps", "--steps"}, lic.steps, NumberRule{1, 65536});
    visit(FieldName{"lic", "stepPx", "--step"}, lic.stepPx, NumberRule{0, 8, true});
    visit(FieldName{"lic", "kernel", "--kernel"}, lic.kernel, kernels);
    visit(FieldName{"lic", "phaseRad", "--phase"}, lic.phaseRad, angle);
    visit(FieldName{"lic", "normalize", "--normalize"}, lic.normalize, SwitchRule{});
    visit(FieldName{"lic", "noiseScale", "--noise-scale"}, lic.noiseScale, NumberRule{0.01, 16});
    visit(FieldName{"lic", "seed", "--seed"}, lic.seed, NumberRule{0, 4294967295.0});

    auto& shading = scene.shading;
    visit(FieldName{"shading", "colorBy", "--color-by"}, shading.colorBy, anyName);
    visit(FieldName{"shading", "colorMap", "--colormap"}, shading.colorMap, TextRule{expectedColorMap(), isColorMap});
    visit(FieldName{"shading", "colorRange", "--color-range"}, shading.colorRange, finite);
    visit(FieldName{"shading", "scalarBar", "--scalar-bar"}, shading.scalarBar, SwitchRule{});
    visit(FieldName{"shading", "contrast", "--contrast"}, shading.contrast, NumberRule{0, 10});
    visit(FieldName{"shading", "blend", "--blend"}, shading.blend, NumberRule{0, 1});
    visit(FieldName{"shading", "background", "--background"}, shading.background,
          TextRule{"six hexadecimal digits RRGGBB or transparent", isBackground});
    visit(FieldName{"shading", "lighting", "--lighting"}, shading.lighting, SwitchRule{});

    auto& camera = scene.camera;
    visit(FieldName{"camera", "azimuthDeg", "--camera azimuth"}, camera.azimuthDeg, angle);
    visit(FieldName{"camera", "elevationDeg", "--camera elevation"}, camera.elevationDeg, angle);
    visit(FieldName{"camera", "rollDeg", "--camera roll"}, camera.rollDeg, angle);
    visit(FieldName{"camera", "zoom", "--camera zoom"}, camera.zoom, NumberRule{0, 1e6, true});
    visit(FieldName{"camera", "fovDeg", "--camera fov"}, camera.fovDeg, NumberRule{1, 170});
    visit(FieldName{"camera", "position", "--camera position"}, camera.position, coordinate);
    visit(FieldName{"camera", "focal", "--camera focal"}, camera.focal, coordinate);
    visit(FieldName{"camera", "up", "--camera up"}, camera.up, coordinate);

    auto& output = scene.output;
    visit(FieldName{"output", "width", "--size width"}, output.width, NumberRule{1, 32768});
    visit(FieldName{"output", "height", "--size height"}, output.height, NumberRule{1, 32768});
    visit(FieldName{"output", "frames", "--frames"}, output.frames, NumberRule{1, 100000});
    visit(FieldName{"output", "orbitDeg", "--orbit"}, output.orbitDeg, angle);

    auto& run = scene.run;
    visit(FieldName{"run", "backend", "--backend"}, run.backend, TextRule{"one of auto, cpu, gl", isBackend});
    visit(FieldName{"run", "threads", "--threads"}, run.threads, NumberRule{0, 4096});
    visit(FieldName{"run", "device", "--device"}, run.device, NumberRule{-1, 255});
    visit(FieldName{"run", "balance", "--balance"}, run.balance,
          TextRule{"one of static, timing, pixels, hybrid", isBalance});
    visit(FieldName{"run", "bricks", "--bricks"}, run.bricks, TextRule{"one of on, off, auto", isBricks});
    visit(FieldName{"run", "guard", "--guard"}, run.guard, TextRule{"bound or estimate", isGuard});
    visit(FieldName{"run", "guardRows", "--guard-rows"}, run.guardRows,
          TextRule{"one of project, receive, auto", isGuardRows});
}

}  // namespace aeolic
