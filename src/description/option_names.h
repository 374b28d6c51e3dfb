#pragma once

#include <string>
#include <string_view>

namespace aeolic {

/// "noise_scale" of "--noise-scale", "camera zoom" of "--camera zoom".
std::string pythonName(std::string_view name);

/// A message for Python's users: options of a scene are called there as pythonName() says, and keys of the list of
/// surfaces like the options: "surface[1]: color_by" of "surfaces[1].colorBy". A word behind an apostrophe or a slash
/// is the user's own, and so is a key behind the name of a scene file.
std::string inPythonsWords(std::string_view message);

}  // namespace aeolic
