#include "cluster/comm/launcher.h"

#include <cstdlib>

namespace aeolic {
namespace {

int countIn(const char* text)
{
    return text ? std::atoi(text) : 0;
}

}  // namespace

Launch detectLaunch(const std::function<const char*(const char*)>& environment)
{
    // Set by mpirun of OpenMPI, by MPICH's Hydra and Slurm's PMI-2, by MVAPICH.
    for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE"})
        if (const int ranks = countIn(environment(variable)); ranks > 0) return {variable, ranks};

    // A Slurm step of one task may be the shell of an allocation, so only PMI or several tasks mean a parallel job.
    // Several tasks without PMI (srun --mpi=none) count too: otherwise each would write the same file.
    const int tasks = environment("SLURM_PROCID") ? countIn(environment("SLURM_STEP_NUM_TASKS")) : 0;
    for (const char* variable : {"PMIX_RANK", "PMI_RANK"})
        if (environment(variable)) return {variable, tasks};
    if (tasks > 1) return {"SLURM_STEP_NUM_TASKS", tasks};
    return {};
}

}  // namespace aeolic
