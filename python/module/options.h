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

/// Every option of a scene in the order of the table, compound ones once: a list of dicts of "name" ("--color-by"),
/// "group" ("shading"), "type" (as in type stubs), "default" (as typed, may be empty) and "help".
pybind11::list optionTable();

/// What is more than one surface.
struct Surfaces {
    std::string items;  ///< JSON, as "surfaces" of a scene file. Empty: one surface, which the options name.
    std::vector<std::string> contexts;
};

/// What holds without any option: that of a scene file, or of none. Throws InputError.
SceneInFile startOf(const std::optional<std::string>& sceneFile);

/// The scene that the command line would make of these options; `memory` stands in the place of files. Where no scene
/// file says a size (`isFile`), that of `start` becomes the one that a plane's picture has. Throws InputError.
SceneDescription sceneOf(SceneInFile& start, bool isFile, const Texts& given, const Surfaces& surfaces,
                         const Data& memory);

/// `scene` with the options in `given` changed. Those in `withdrawn` get the values that they have in `start`.
SceneDescription changed(SceneDescription scene, const Texts& given);
SceneDescription changed(SceneDescription scene, const Texts& given, const SceneDescription& start,
                         const std::vector<std::string>& withdrawn);

}  // namespace aeolic::python
