#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reader/parts/part_source.h"

namespace aeolic {

/// The parts of an EnSight Gold case at one of its times; none: the first. Reads the case file alone. Throws
/// InputError.
std::unique_ptr<PartSource> openEnSightCase(const std::string& path, std::optional<double> time);

}  // namespace aeolic
