#pragma once

#include <memory>
#include <optional>
#include <string>

#include "reader/parts/part_source.h"

/// Files of several parts, opened at one of their times; none: the first. All throw InputError.
namespace aeolic {

/// The zones of a CGNS file, their boundaries and their sections of faces.
std::unique_ptr<PartSource> openCgnsFile(const std::string& path, std::optional<double> time);

/// The parts of an EnSight Gold case. Reads the case file alone.
std::unique_ptr<PartSource> openEnSightCase(const std::string& path, std::optional<double> time);

/// The element blocks and side sets of an Exodus II file.
std::unique_ptr<PartSource> openExodusFile(const std::string& path, std::optional<double> time);

/// The zones of a Fluent mesh (.msh) or case (.cas), with the values of the data file (.dat) of the same name beside
/// it, if there is one.
std::unique_ptr<PartSource> openFluentFile(const std::string& path, std::optional<double> time);

/// The zones of a Tecplot file in text.
std::unique_ptr<PartSource> openTecplotFile(const std::string& path, std::optional<double> time);

}  // namespace aeolic
