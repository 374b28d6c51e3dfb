#pragma once

#include <functional>
#include <string>

namespace aeolic {

/// How this process was started, as far as the environment tells.
struct Launch {
    std::string variable;  ///< By this one an MPI launcher was noticed; empty: there is none.
    int ranks = 0;         ///< How many processes were started together; 0: unknown.
};

/// Local. Knows OpenMPI, MPICH and its relatives, PMIx, and Slurm. `environment` looks a variable up, null where unset.
Launch detectLaunch(const std::function<const char*(const char*)>& environment);

}  // namespace aeolic
