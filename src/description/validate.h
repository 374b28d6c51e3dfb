#pragma once

#include <functional>
#include <string>

#include "aeolic/scene_description.h"
#include "description/option_table.h"

namespace aeolic {

/// How a message calls an option: as the user wrote it.
using OptionNaming = std::function<std::string(const Option&)>;

std::string jsonName(const Option& option);         ///< "lic.steps"
std::string commandLineName(const Option& option);  ///< "--steps"; a JSON key where it has none
std::string surfaceKey(std::size_t index);          ///< "surfaces[1]"

/// The one place that judges a scene: every range, every name, and the fields that must fit each other. It reads no
/// files: whether arrays exist or a surface has vectors is found when loading. Throws InputError with one line, the
/// first fault in the order of the structs, e.g. "--steps: found -5; expected a whole number from 1 to 65536".
void validate(const SceneDescription& scene, const OptionNaming& naming = jsonName);

}  // namespace aeolic
