#pragma once

#include <string>

namespace aeolic::test {

/// Writes small sound files of every format that a surface, a field or a colour map can be read from into `folder`, in
/// every encoding that readers treat differently, and series of them.
void writeFileSeeds(const std::string& folder);

}  // namespace aeolic::test
