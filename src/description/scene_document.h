#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "aeolic/scene_description.h"

namespace aeolic {

/// sceneToJson() before it is text, for where it goes into another document. Throws InputError where validate() does;
/// texts that are not UTF-8 are in it as they are.
nlohmann::ordered_json sceneDocument(const SceneDescription& scene);

/// sceneFromJson() of a document that is read already: its reader has refused what it does not want of nesting and
/// repeated keys.
SceneDescription sceneFromDocument(const nlohmann::ordered_json& document, const std::string& source);

}  // namespace aeolic
