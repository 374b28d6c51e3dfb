#include <cstdio>
#include <cstdlib>

#include "aeolic/error.h"
#include "cluster/comm/communicator.h"
#include "cluster/comm/launcher.h"
#include "cluster/comm/mpi_communicator.h"

namespace aeolic {
namespace {

class SerialCommunicator final : public Communicator {
public:
    std::string name() const override { return "serial"; }
    int rank() const override { return 0; }
    int size() const override { return 1; }

    [[noreturn]] void abortJob(const std::string& message, int exitCode) override
    {
        std::fprintf(stderr, "aeolic: %s\n", message.c_str());
        std::fflush(nullptr);
        std::_Exit(exitCode);
    }

private:
    void doBarrier() override {}
    void doBroadcast(Bytes&, int) override {}
    void doGather(std::vector<Bytes>& all, ByteSpan mine, int) override { all[0].assign(mine.begin(), mine.end()); }
    std::vector<Bytes> doAllGather(ByteSpan mine) override { return {Bytes(mine.begin(), mine.end())}; }
    std::vector<std::int64_t> doAllToAll(const std::vector<std::int64_t>& toRank) override { return toRank; }
    void doExchange(const std::vector<OutgoingBytes>&, const std::vector<IncomingBytes>&) override {}
};

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

std::unique_ptr<Communicator> makeSerialCommunicator()
{
    return std::make_unique<SerialCommunicator>();
}

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
