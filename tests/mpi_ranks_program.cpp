// What the tests run under mpirun. Arguments:
//   everything RANKS   all operations, in a group of RANKS
//   abort RANK         that rank ends the job while the others wait for it
//   unwind RANK        that rank leaves by an exception nobody catches in time
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "cluster/comm/mpi_communicator.h"
#include "communicator_testing.h"

namespace {

using namespace aeolic;

/// Collective. Prints the faults of all ranks. True: there are none.
bool reportFaults(Communicator& communicator, const std::vector<std::string>& faults)
{
    for (const std::string& fault : faults) std::fprintf(stderr, "%s\n", fault.c_str());
    return communicator.allReduce(std::int64_t(faults.size()), Reduction::sum) == 0;
}

int checkEverything(int ranks)
{
    const std::unique_ptr<Communicator> communicator = makeCommunicator();
    std::vector<std::string> faults = testkit::communicatorFaults(*communicator);
    if (communicator->size() != ranks) faults.push_back("a group of " + std::to_string(communicator->size()));
    if (!reportFaults(*communicator, faults)) return EXIT_FAILURE;
    if (communicator->name() != "mpi") return EXIT_SUCCESS;

    // Again with a limit so low that every message is cut to pieces, as those over a gigabyte are.
    const std::unique_ptr<Communicator> pieces = makeMpiCommunicator(977);
    return reportFaults(*pieces, testkit::communicatorFaults(*pieces)) ? EXIT_SUCCESS : EXIT_FAILURE;
}

int abortOn(int rank)
{
    const std::unique_ptr<Communicator> communicator = makeCommunicator();
    if (communicator->rank() == rank) communicator->abortJob("the piece wing.vti is missing", 2);
    communicator->barrier();
    return EXIT_SUCCESS;
}

int unwindOn(int rank)
{
    try {
        const std::unique_ptr<Communicator> communicator = makeCommunicator();
        if (communicator->rank() == rank) throw std::runtime_error("out of luck");
        communicator->barrier();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "aeolic: %s\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string what = argc == 3 ? argv[1] : "";
    const int number = argc == 3 ? std::atoi(argv[2]) : 0;
    if (what == "everything") return checkEverything(number);
    if (what == "abort") return abortOn(number);
    if (what == "unwind") return unwindOn(number);
    return EXIT_FAILURE;
}
