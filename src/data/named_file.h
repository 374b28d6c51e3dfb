#pragma once

#include <cstdint>
#include <string>

#include "description/file_kinds.h"

namespace aeolic {

/// The kind of file that `path` names by its ending; null where there is none. Folders, those of all processors of a
/// case (CASE/processor*) included, are of one kind, whatever their names end in.
const FileKind* namedKind(const std::string& path);

/// Whether it has a kind of which that is true.
bool namedKindHas(const std::string& path, FileFact fact);

/// Throws InputError unless `path` is a file that can be opened and is not empty. Returns its size in bytes.
std::uint64_t checkReadableFile(const std::string& path);

}  // namespace aeolic
