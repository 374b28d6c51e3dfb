#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reader/parts/part_source.h"

namespace aeolic {

/// The zones of a Fluent mesh (.msh) or case (.cas), with the values of the data file (.dat) of the same name beside
/// it, if there is one. Throws InputError.
std::unique_ptr<PartSource> openFluentFile(const std::string& path, std::optional<double> time);

}  // namespace aeolic
