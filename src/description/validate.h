#pragma once

#include <functional>
#include <string>

#include "aeolic/scene_description.h"
#include "description/scene_fields.h"

namespace aeolic {

/// How a message calls a field: as the user wrote it.
using FieldNaming = std::function<std::string(const FieldName&)>;

std::string jsonName(const FieldName& field);    ///< "lic.steps"
std::string optionName(const FieldName& field);  ///< "--steps"

/// The one place that judges a scene: every range, every name, and the fields that must fit each other. It reads no
/// files: whether arrays exist or a surface has vectors is found when loading. Throws InputError with one line, the
/// first fault in the order of the structs, e.g. "--steps: found -5; expected a whole number from 1 to 65536".
void validate(const SceneDescription& scene, const FieldNaming& naming = jsonName);

}  // namespace aeolic
