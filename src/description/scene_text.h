#pragma once

#include <string>
#include <string_view>

#include "aeolic/scene_description.h"

namespace aeolic {

/// Sets what one option of the command line says, by its name in option_table.h ("--steps", "--camera azimuth",
/// "--size", "--camera"). A text is a number, on|off, a name, or a list as "1,2,3". Throws InputError naming the option
/// if the text is no such value. Whether the value is in range, and fits the other fields, is for validate() to say.
///
/// "--size" takes WxH. "--camera" takes items name=value separated by ',' or ';': "azimuth=30,zoom=2" or
/// "position=1,2,3;up=0,0,1". A value goes on to the next ';' or ',name='. Angles turn an absolute view of a scene file
/// back into a relative one; angles and a position together are refused.
void setOption(SceneDescription& scene, std::string_view name, const std::string& text);

/// The value of one field as one would type it, by the option's name; empty if the field has no value.
std::string optionText(const SceneDescription& scene, std::string_view name);

}  // namespace aeolic
