// What the tests run under mpirun on two ranks: joinRanks() at the wrong time, and with communicators that are of no
// use.
#define OMPI_SKIP_MPICXX 1  // It would need a library of its own.
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "aeolic/aeolic.h"

namespace {

int faults = 0;

void expect(const std::string& expected, const std::function<void()>& call)
{
    std::string told = "nothing";
    try {
        call();
    } catch (const aeolic::InputError& error) {
        told = error.what();
    }
    if (told == expected) return;
    std::fprintf(stderr, "found '%s'; expected '%s'\n", told.c_str(), expected.c_str());
    ++faults;
}

/// An intercommunicator between two groups of one rank each.
MPI_Comm between(int rank)
{
    MPI_Comm own = MPI_COMM_NULL, both = MPI_COMM_NULL;
    MPI_Comm_split(MPI_COMM_WORLD, rank, 0, &own);
    MPI_Intercomm_create(own, 0, MPI_COMM_WORLD, 1 - rank, 1, &both);
    MPI_Comm_free(&own);
    return both;
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Comm world = MPI_COMM_WORLD;
    expect("MPI: found a communicator, and MPI not started; expected MPI_Init_thread before",
           [&] { aeolic::joinRanks(&world); });
    int provided = 0, rank = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    expect("joinRanks: found a null pointer; expected the address of an MPI_Comm", [] { aeolic::joinRanks(nullptr); });
    expect("joinRanks: found MPI_COMM_NULL; expected a communicator that this process belongs to", [] {
        const MPI_Comm none = MPI_COMM_NULL;
        aeolic::joinRanks(&none);
    });
    MPI_Comm two = between(rank);
    expect("joinRanks: found an intercommunicator; expected ranks of one group, as MPI_Intercomm_merge makes of two",
           [&] { aeolic::joinRanks(&two); });
    MPI_Comm_free(&two);
    {
        std::shared_ptr<aeolic::Communicator> kept;
        expect("nothing", [&] { kept = aeolic::joinRanks(&world); });
        MPI_Finalize();
    }  // What is left goes after MPI.
    expect("joinRanks: found MPI at its end; expected a call before MPI_Finalize", [&] { aeolic::joinRanks(&world); });
    expect("joinRanks: found MPI at its end; expected a call before MPI_Finalize", [] { aeolic::joinRanks(); });
    return faults == 0 ? 0 : 1;
}
