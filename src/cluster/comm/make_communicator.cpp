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

}  // namespace

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
