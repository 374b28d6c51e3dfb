#pragma once

#include <mutex>

namespace aeolic {

/// Whoever calls the library of HDF5, or that of netCDF, which calls the former, holds this: Debian builds both for one
/// thread at a time. A thread may hold it several times over. Work that needs no library is done without it.
class Hdf5Lock {
public:
    Hdf5Lock();

private:
    std::lock_guard<std::recursive_mutex> held_;
};

}  // namespace aeolic
