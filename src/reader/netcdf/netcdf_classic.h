#pragma once

#include <cstdint>
#include <string>

namespace aeolic {

/// How many records a file in a classic form has. One that was never closed does not say it: then those that fit.
/// Throws InputError where the file is shorter than it should be, because the library gives zeros for what is missing.
/// `id`: the open file's. Whoever calls it holds a Hdf5Lock.
std::uint64_t classicNetcdfRecords(const std::string& path, int id, std::uint64_t fileBytes);

}  // namespace aeolic
