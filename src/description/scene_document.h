#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "aeolic/scene_description.h"

namespace aeolic {

/// The document that sceneToJson() writes as text, to be put into another document. Throws InputError where validate()
/// does. Texts that are not UTF-8 stay as they are.
nlohmann::ordered_json sceneDocument(const SceneDescription& scene);

/// Reads a document as sceneFromJson() reads a text. Whoever parsed the document has refused repeated keys and deep
/// nesting.
SceneDescription sceneFromDocument(const nlohmann::ordered_json& document, const std::string& source);

/// The options of these groups, for the page: {"lic": {"steps": {"kind": "whole", "least": 1, "most": 65536, "usual":
/// [1, 1024], "default": 128}, …}, …}. docs/protocol.md describes the members.
nlohmann::ordered_json optionsDocument(std::initializer_list<std::string_view> groups);

}  // namespace aeolic
