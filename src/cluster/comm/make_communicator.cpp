#include <cstdlib>

#include "aeolic/error.h"
#include "cluster/comm/communicator.h"
#include "cluster/comm/launcher.h"
#include "cluster/comm/mpi_communicator.h"
#include "cluster/comm/serial_communicator.h"

namespace aeolic {

std::unique_ptr<Communicator> makeCommunicator()
{
    const Launch launch = detectLaunch([](const char* variable) -> const char* { return std::getenv(variable); });
    if (launch.variable.empty() || launch.ranks == 1) return makeSerialCommunicator();
    std::unique_ptr<Communicator> communicator = makeMpiCommunicator();
    if (launch.ranks > 1 && communicator->size() != launch.ranks)
        throw InputError("launcher",
                         launch.variable + " says " + std::to_string(launch.ranks) + " ranks, MPI says " +
                             std::to_string(communicator->size()),
                         "the launcher of the MPI this program was built with");
    return communicator;
}

}  // namespace aeolic
