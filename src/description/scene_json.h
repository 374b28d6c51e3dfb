#pragma once

#include <functional>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "aeolic/scene_description.h"

namespace aeolic {

/// A scene as JSON: {"version": 1, "surface": {"spec": …}, "field": {…}, "lic": {…}, …}, the structs of
/// SceneDescription with their field names as keys; enums are their names, switches are true or
/// false, and fields without a value are left out. Files and the wire have the same form. Throws InputError if a text
/// is not UTF-8.
std::string sceneToJson(const SceneDescription& scene);

/// The document that sceneToJson() writes as text, to be put into another document. Throws InputError where validate()
/// does. Texts that are not UTF-8 stay as they are.
nlohmann::ordered_json sceneDocument(const SceneDescription& scene);

/// Reads a scene's JSON. What is left out keeps its default; the result has passed validate(). Throws InputError with
/// one line for anything else: unknown or repeated keys, wrong types, numbers out of range, nesting, text after the
/// end. `source` stands in front of messages: "scene.json: lic.steps: found -3; expected a whole number from 1 to
/// 65536".
SceneDescription sceneFromJson(std::string_view text, const std::string& source);

/// Reads a document as sceneFromJson() reads a text. Whoever parsed the document has refused repeated keys and deep
/// nesting.
SceneDescription sceneFromDocument(const nlohmann::ordered_json& document, const std::string& source);

/// A scene out of a file, and whether it names what surfaces it has: else it has the default one.
struct SceneInFile {
    SceneDescription scene;
    bool namesSurface = false;
};

/// Reads what a scene file holds. File names in it are relative to the folder that the process is in.
SceneInFile readSceneText(std::string_view text, const std::string& source);

/// Reads a scene file of at most 1 MiB. File names in it are relative to the folder it is in.
SceneInFile readSceneFile(const std::string& path);

/// Gives all files of a scene other names: surfaces, field and colour maps.
void renameFiles(SceneDescription& scene, const std::function<std::string(const std::string&)>& named);

/// The default surface is there for built-in fields. Throws InputError where no surface was `named` and the scene has a
/// field of the user's, or surfaces beside the default one.
void requireSurface(const SceneDescription& scene, bool named);

/// A built-in surface has no vectors of its own: where neither a field nor vectors are named, it shows the field "abc".
void chooseDefaultField(SceneDescription& scene);

/// The options of these groups, for the page: {"lic": {"steps": {"kind": "whole", "least": 1, "most": 65536, "usual":
/// [1, 1024], "default": 128}, …}, …}. docs/protocol.md describes the members.
nlohmann::ordered_json optionsDocument(std::initializer_list<std::string_view> groups);

}  // namespace aeolic
