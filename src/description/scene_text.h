#pragma once

#include <string>
#include <string_view>

#include "aeolic/scene_description.h"

namespace aeolic {

/// Sets one field from the text of a command line option, by its name in scene_fields.h ("--steps", "--camera
/// azimuth"). Numbers, on|off, names, and lists as "1,2,3". Throws InputError naming the option if the text is no such
/// value; whether it is in range, and fits the other fields, is for validate() to say.
void setField(SceneDescription& scene, std::string_view option, const std::string& text);

/// The field's value as one would type it; empty if it has none.
std::string fieldText(const SceneDescription& scene, std::string_view option);

/// "--size WxH".
void setSize(SceneDescription& scene, const std::string& text);

/// "--camera": items name=value separated by ',' or ';', e.g. "azimuth=30,zoom=2" or "position=1,2,3;up=0,0,1". A value
/// goes on to the next ';' or ',name='. Angles turn an absolute view of a scene file back into a relative one; given
/// together with a position they are refused.
void setCamera(SceneDescription& scene, const std::string& text);

}  // namespace aeolic
