#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <string>
#include <vector>

#include "aeolic/data.h"
#include "aeolic/scene_description.h"

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

/// The scene that the command line would make of these options; `memory` stands in the place of files. `sceneFile`: a
/// scene file that the options override, or empty. Throws InputError.
SceneDescription sceneOf(const std::string& sceneFile, const Texts& given, const Surfaces& surfaces,
                         const Data& memory);

/// The same scene with some options changed.
SceneDescription changed(SceneDescription scene, const Texts& given);

}  // namespace aeolic::python
