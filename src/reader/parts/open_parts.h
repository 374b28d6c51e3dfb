#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reader/parts/part_source.h"

namespace aeolic {

/// Opens a file of several parts by the reader for its extension; null where there is none. Reads what the file says of
/// itself, but no values. `time`: one of its times; none: the first. Throws InputError.
std::unique_ptr<PartSource> openPartSource(const std::string& path, const std::string& extension,
                                           std::optional<double> time);

}  // namespace aeolic
