#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"
#include "data/scene.h"
#include "engine/started_frames.h"

namespace aeolic {

/// Where vectors point against the flow that made them; else empty.
std::string againstFlowWarning(const Scene& scene);

/// What the options of a frame ask for that these data, or a picture of this size, do not give: one line each. `times`:
/// the moments of the scene's steps.
std::vector<std::string> pictureWarnings(const StartedFrame& frame, const Scene& scene,
                                         const std::vector<double>& times, int width, int height);

/// What is said where a moment that is asked for is outside of the data; else empty. `span`: the first and the last
/// moment that there are; nothing where any can be shown.
std::string momentWarning(const SceneDescription& description, const std::optional<std::array<double, 2>>& span);

/// The warning of a still of a moment at which nothing flows, where something does later; else empty. `shown`: the
/// moment. `times`: all steps of the scene.
std::string restWarning(const SceneDescription& description, const Scene& scene, double shown,
                        const std::vector<double>& times);

}  // namespace aeolic
