#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "aeolic/scene_description.h"

namespace aeolic {

/// Sets what one option of the command line says, by its name in option_table.h ("--steps", "--camera azimuth",
/// "--size", "--camera"). A text is a number, on|off, a name, or a list as "1,2,3". Throws InputError naming the option
/// if the text is no such value. Whether the value is in range, and fits the other fields, is for validate() to say.
///
/// "--size" takes WxH. "--camera" takes items name=value separated by ',' or ';': "azimuth=30,zoom=2" or
/// "position=1,2,3;up=0,0,1". A value goes on to the next ';' or ',name='. Angles and zoom turn an absolute view of a
/// scene file back into a relative one; with a position they are refused. "--surface" is then the only surface,
/// "--context" one more.
void setOption(SceneDescription& scene, std::string_view name, const std::string& text);

/// Gives `scene` the value that `from` has of an option, or of all fields of a compound one ("--size").
void takeOption(SceneDescription& scene, const SceneDescription& from, std::string_view name);

/// Sets the surfaces that `--surface` and `--context` name, each of which may have been given several times. Without
/// any `surfaces` those of the scene stay.
void setSurfaces(SceneDescription& scene, const std::vector<std::string>& surfaces,
                 const std::vector<std::string>& contexts);

/// The value of one field as one would type it, by the option's name; empty if the field has no value.
std::string optionText(const SceneDescription& scene, std::string_view name);

/// The options of one group ("lic"), also ones that validate() refuses: a line for each, "lic.steps = 128". It is the
/// same only where all values are.
std::string groupText(const SceneDescription& scene, std::string_view group);

}  // namespace aeolic
