#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reader/parts/part_source.h"

namespace aeolic {

/// The element blocks and side sets of an Exodus II file at one of its times; none: the first. Throws InputError.
std::unique_ptr<PartSource> openExodusFile(const std::string& path, std::optional<double> time);

}  // namespace aeolic
