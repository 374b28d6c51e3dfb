// Compiled instead of mpi_communicator.cpp in a build without MPI.
#include "aeolic/error.h"
#include "cluster/comm/mpi_communicator.h"

namespace aeolic {

std::unique_ptr<Communicator> makeMpiCommunicator(std::int64_t, const void*)
{
    throw InputError("launcher", "started as one of several ranks, but this build has no MPI",
                     "a build with AEOLIC_MPI=ON, or a start without mpirun or srun");
}

}  // namespace aeolic
