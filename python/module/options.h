#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/data.h"
#include "aeolic/scene_description.h"
#include "description/scene_json.h"

namespace aeolic::python {

using Texts = std::map<std::string, std::string>;  ///< Options as they are typed: "--steps" -> "40".

/// Every option of a scene in the order of the table, compound ones once: a list of dicts of "name" ("color_by"),
/// "option" ("--color-by"), "key" ("shading.colorBy", empty where a scene file has no such key), "group" ("shading"),
/// "type" (as in type stubs), "default" (as typed, may be empty) and "help".
pybind11::list optionTable();

/// What is more than one surface.
struct Surfaces {
    std::string items;  ///< JSON, as "surfaces" of a scene file. Empty: one surface, which the options name.
    std::vector<std::string> contexts;
};

/// The scene that options change: nothing, the name of a scene file, or what one holds.
struct GivenScene {
    std::optional<std::string> file, text;
};

/// What holds without any option. Throws InputError.
SceneInFile startOf(const GivenScene& given);

/// The scene that the command line would make of these options; `memory` stands in the place of files. Where no scene
/// was given (`isGiven`), the size of `start` becomes the one that a plane's picture has. Throws InputError.
SceneDescription sceneOf(SceneInFile& start, bool isGiven, const Texts& given, const Surfaces& surfaces,
                         const Data& memory);

/// `scene` with the options in `given` changed. Those in `withdrawn` get the values that they have in `start`.
SceneDescription changed(SceneDescription scene, const Texts& given);
SceneDescription changed(SceneDescription scene, const Texts& given, const SceneDescription& start,
                         const std::vector<std::string>& withdrawn);

}  // namespace aeolic::python
