#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reader/parts/part_source.h"

namespace aeolic {

/// The zones of a Tecplot file in text at one of its times; none: the first. Throws InputError.
std::unique_ptr<PartSource> openTecplotFile(const std::string& path, std::optional<double> time);

}  // namespace aeolic
