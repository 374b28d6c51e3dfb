#pragma once

#include <cstdint>
#include <string>

namespace aeolic {

/// How many records a file in a classic form has. A file that was never closed does not say it: then as many as fit.
/// Throws InputError where the file is shorter than it should be, because the library gives zeros for missing values.
/// `id`: the open file's. The caller holds a Hdf5Lock.
std::uint64_t classicNetcdfRecords(const std::string& path, int id, std::uint64_t fileBytes);

}  // namespace aeolic
