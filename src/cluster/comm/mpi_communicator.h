#pragma once

#include <cstdint>
#include <memory>

#include "cluster/comm/communicator.h"

namespace aeolic {

/// MPI counts are ints: longer messages travel in chunks. 1 GiB leaves room for the library's own arithmetic.
inline constexpr std::int64_t kMpiChunkBytes = std::int64_t(1) << 30;

/// Collective. All processes of the MPI job, or those of `callers`, the address of an MPI_Comm, of which this is a
/// duplicate. Starts MPI if nobody has, and then ends it on destruction. `chunkBytes`: no message or collective is
/// handed to MPI with more bytes at once; tests make it tiny. Throws InputError where this build has no MPI and where
/// MPI was started for fewer threads than MPI_THREAD_SERIALIZED, std::runtime_error where MPI does not start.
std::unique_ptr<Communicator> makeMpiCommunicator(std::int64_t chunkBytes = kMpiChunkBytes,
                                                  const void* callers = nullptr);

}  // namespace aeolic
