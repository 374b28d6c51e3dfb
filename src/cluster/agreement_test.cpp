#include "cluster/agreement.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "aeolic/error.h"
#include "cluster/serial_communicator.h"
#include "cluster/thread_communicator.h"

namespace aeolic {
namespace {

/// What every rank catches when all call `collective`: its text, with "input: " before an InputError; by rank.
std::vector<std::string> caughtBy(int ranks, const std::function<void(Communicator&)>& collective)
{
    std::vector<std::string> caught(std::size_t(ranks), "nothing");
    runRanks(ranks, [&](Communicator& communicator) {
        std::string& text = caught[std::size_t(communicator.rank())];
        try {
            collective(communicator);
        } catch (const InputError& error) {
            text = std::string("input: ") + error.what();
        } catch (const std::exception& error) {
            text = error.what();
        }
        communicator.barrier();  // The group is still usable.
    });
    return caught;
}

TEST(RunTogether, NothingHappensWhereAllSucceed)
{
    EXPECT_EQ(caughtBy(3, [](Communicator& c) { runTogether(c, [] {}); }), std::vector<std::string>(3, "nothing"));
}

TEST(RunTogether, OneRanksErrorIsThrownOnAllAndNamesIt)
{
    const auto fail = [](Communicator& c) {
        runTogether(c, [&] {
            if (c.rank() >= 2) throw InputError("wing.vti", "no such file", "a piece");
        });
    };
    EXPECT_EQ(caughtBy(4, fail),
              std::vector<std::string>(4, "input: rank 2: wing.vti: no such file; expected a piece"));
}

TEST(RunTogether, WhatAllSayIsSaidOnceWithoutARank)
{
    const auto fail = [](Communicator& c) { runTogether(c, [] { throw InputError("bad --size"); }); };
    EXPECT_EQ(caughtBy(2, fail), std::vector<std::string>(2, "input: bad --size"));
}

TEST(RunTogether, NoMemoryAndThingsThatAreNoExceptionsAreNamed)
{
    const auto noMemory = [](Communicator& c) {
        runTogether(c, [&] {
            if (c.rank() == 1) throw std::bad_alloc();
        });
    };
    EXPECT_EQ(caughtBy(2, noMemory), std::vector<std::string>(2, "rank 1: out of memory"));
    const auto number = [](Communicator& c) {
        runTogether(c, [&] {
            if (c.isRoot()) throw 7;
        });
    };
    EXPECT_EQ(caughtBy(2, number), std::vector<std::string>(2, "rank 0: an unknown error"));
}

TEST(RunTogether, AloneAnErrorPassesAsItIs)
{
    const auto alone = makeSerialCommunicator();
    EXPECT_THROW(runTogether(*alone, [] { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST(RequireSame, NamesTheFirstRankThatDiffers)
{
    EXPECT_EQ(caughtBy(3, [](Communicator& c) { requireSame(c, "version", "0.1.0"); }),
              std::vector<std::string>(3, "nothing"));
    EXPECT_EQ(caughtBy(3, [](Communicator& c) { requireSame(c, "version", c.rank() == 2 ? "0.2.0" : "0.1.0"); }),
              std::vector<std::string>(3, "input: version: rank 2 has \"0.2.0\"; expected \"0.1.0\" as on rank 0"));
}

TEST(RequireSame, LongValuesAreNotQuoted)
{
    const auto differ = [](Communicator& c) { requireSame(c, "scene", std::string(c.isRoot() ? 500 : 501, 'x')); };
    EXPECT_EQ(caughtBy(2, differ)[0],
              "input: scene: rank 1 has one of 501 bytes; expected one of 500 bytes as on rank 0");
}

}  // namespace
}  // namespace aeolic
