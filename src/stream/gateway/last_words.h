#pragma once

#include <string>
#include <string_view>

namespace aeolic::stream {

/// What somebody should hear of what a launcher or a job wrote before it ended, as one printable line; empty if it
/// wrote nothing. That is the beginning of a message between two rulers, as launchers write them, or else the last
/// lines.
std::string lastWords(std::string_view written);

}  // namespace aeolic::stream
