#include "cluster/comm/together.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "aeolic/error.h"
#include "cluster/comm/communicator.h"
#include "ranks/thread_communicator.h"

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
              std::vector<std::string>(3, "input: version: rank 2 has '0.2.0'; expected '0.1.0' as on rank 0"));
}

/// What two ranks, of `first` and `second`, are told.
std::string differenceOf(const std::string& first, const std::string& second)
{
    return caughtBy(2, [&](Communicator& c) { requireSame(c, "scene", c.isRoot() ? first : second); })[0];
}

TEST(RequireSame, OfALongValueTheFirstLineThatDiffersIsQuoted)
{
    EXPECT_EQ(differenceOf("{\n  \"size\": 80,\n  \"steps\": 8\n}", "{\n  \"size\": 90,\n  \"steps\": 9\n}"),
              "input: scene: rank 1 has '\"size\": 90'; expected '\"size\": 80' as on rank 0");
    EXPECT_EQ(differenceOf("a\nb\nc", "a\nb\nd"), "input: scene: rank 1 has 'd'; expected 'c' as on rank 0");
    EXPECT_EQ(differenceOf("a\nb", "a\nbc"), "input: scene: rank 1 has 'bc'; expected 'b' as on rank 0");
}

TEST(RequireSame, OneThatGoesOnWhereTheOtherEnds)
{
    EXPECT_EQ(differenceOf("", "more"), "input: scene: rank 1 has 'more'; expected nothing as on rank 0");
    EXPECT_EQ(differenceOf("a\n", "a\nb\n"), "input: scene: rank 1 has 'b'; expected nothing as on rank 0");
}

TEST(RequireSame, EndlessLinesAreCutOff)
{
    const std::string told = differenceOf(std::string(500, 'x'), std::string(501, 'x'));
    EXPECT_LT(told.size(), 300u) << told;
    EXPECT_NE(told.find("xxx…'"), std::string::npos) << told;
}

TEST(DistinctOfAll, EveryRanksTextsOnceByRank)
{
    runRanks(3, [](Communicator& communicator) {
        std::vector<std::string> mine{"a: of all"};
        if (communicator.rank() != 1) mine.push_back("b: of rank " + std::to_string(communicator.rank()));
        EXPECT_EQ(distinctOfAll(communicator, mine),
                  (std::vector<std::string>{"a: of all", "b: of rank 0", "b: of rank 2"}));
        EXPECT_TRUE(distinctOfAll(communicator, {}).empty());
    });
}

}  // namespace
}  // namespace aeolic
