#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reader/tecplot/tecplot_text.h"

namespace aeolic {

/// What the records of a file say.
struct TecplotHeads {
    std::vector<std::string> variables;
    std::vector<TecplotZone> zones;
};

/// Reads them in a file's text. Numbers are passed over. Throws InputError, which begins with `path`.
TecplotHeads readTecplotHeads(std::string_view text, const std::string& path);

}  // namespace aeolic
