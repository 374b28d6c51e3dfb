#pragma once

#include <string>
#include <string_view>

#include "description/option_table.h"

namespace aeolic {

/// The one rule by which an option's name on the command line gives all its others.
///
/// The key in the JSON, which is the name of the struct's member, too: "noiseScale" of "--noise-scale". An option that
/// is called like its group has the group's own key: "method" of "--lic". The group's name is not repeated: "precision"
/// of "--field-precision". An item of a compound option is called like the item: "zoom" of "--camera zoom".
std::string keyOfName(const Option& option);

/// "noise_scale" of "--noise-scale", "camera zoom" of "--camera zoom".
std::string pythonName(std::string_view name);

/// A message for Python's users: options of a scene are called there as pythonName() says, and keys of the list of
/// surfaces like the options: "surface[1]: color_by" of "surfaces[1].colorBy". A word behind an apostrophe or a slash
/// is the user's own, and so is a key behind the name of a scene file.
std::string inPythonsWords(std::string_view message);

}  // namespace aeolic
