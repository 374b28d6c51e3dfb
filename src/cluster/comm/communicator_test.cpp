#include "cluster/comm/communicator.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "cluster/comm/serial_communicator.h"
#include "communicator_testing.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

using namespace testkit;

TEST(SerialCommunicator, AnswersAsAGroupOfOne)
{
    const auto communicator = makeSerialCommunicator();
    EXPECT_EQ(communicator->size(), 1);
    for (const std::string& fault : communicatorFaults(*communicator)) ADD_FAILURE() << fault;
    EXPECT_EQ(communicator->sent(), Traffic{});
}

TEST(SerialCommunicator, AbortEndsTheProcessWithOneLine)
{
    EXPECT_EXIT(makeSerialCommunicator()->abortJob("no memory", 3), ::testing::ExitedWithCode(3),
                "^aeolic: no memory\n$");
}

class ThreadGroup : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, ThreadGroup, ::testing::Values(1, 2, 3, 5, 8, 13));

TEST_P(ThreadGroup, AnswersEveryOperation)
{
    std::atomic<int> ran = 0;
    runRanks(GetParam(), [&](Communicator& communicator) {
        EXPECT_EQ(communicator.size(), GetParam());
        for (const std::string& fault : communicatorFaults(communicator)) ADD_FAILURE() << fault;
        ++ran;
    });
    EXPECT_EQ(ran, GetParam());
}

/// What runRanks() throws, or nothing.
std::string errorOf(int ranks, const std::function<void(Communicator&)>& body)
{
    try {
        runRanks(ranks, body);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(ThreadCommunicator, ARankThatThrowsReleasesTheOthersAndIsHeard)
{
    EXPECT_EQ(errorOf(4,
                      [](Communicator& communicator) {
                          if (communicator.rank() == 2) throw std::runtime_error("disk full");
                          communicator.barrier();
                          communicator.barrier();
                      }),
              "disk full");
}

TEST(ThreadCommunicator, AbortNamesTheRank)
{
    EXPECT_EQ(errorOf(3,
                      [](Communicator& communicator) {
                          if (communicator.rank() == 1) communicator.abortJob("disk full");
                          communicator.allGather({});
                      }),
              "rank 1: disk full");
}

TEST(ThreadCommunicator, ARankThatLeftIsNotWaitedFor)
{
    EXPECT_EQ(errorOf(2,
                      [](Communicator& communicator) {
                          if (communicator.rank() == 0) communicator.barrier();
                      }),
              "rank 0 waits in barrier for rank 1, which has left");
}

TEST(ThreadCommunicator, DifferentOperationsAreFoundOut)
{
    const std::string error = errorOf(2, [](Communicator& communicator) {
        if (communicator.rank() == 0)
            communicator.barrier();
        else
            communicator.allGather({});
    });
    EXPECT_TRUE(error == "rank 0 is in barrier while rank 1 is in allGather" ||
                error == "rank 1 is in allGather while rank 0 is in barrier")
        << error;
}

TEST(ThreadCommunicator, RanksThatAllWaitAreFoundOut)
{
    const std::string error = errorOf(3, [](Communicator& communicator) {
        Bytes four(4);
        communicator.exchangeInPlace({}, {{(communicator.rank() + 1) % 3, four}});
    });
    EXPECT_NE(error.find("and all other ranks wait too"), std::string::npos) << error;
}

TEST(ThreadCommunicator, AMessageNobodyTakesIsFoundOut)
{
    EXPECT_EQ(errorOf(2,
                      [](Communicator& communicator) {
                          const Bytes four(4);
                          if (communicator.rank() == 0) communicator.exchangeInPlace({{1, four}}, {});
                      }),
              "rank 1 left without the message of rank 0 from exchange");
}

TEST(ThreadCommunicator, AnotherLengthThanAnnouncedIsFoundOut)
{
    EXPECT_EQ(errorOf(2,
                      [](Communicator& communicator) {
                          Bytes four(4), five(5);
                          if (communicator.rank() == 0)
                              communicator.exchangeInPlace({{1, four}}, {});
                          else
                              communicator.exchangeInPlace({}, {{0, five}});
                      }),
              "rank 1: expected 5 bytes from rank 0, received 4");
}

TEST(ThreadCommunicator, UnequalNumbersOfValuesAreFoundOut)
{
    const std::string error = errorOf(2, [](Communicator& communicator) {
        std::vector<double> values(communicator.isRoot() ? 2 : 3);
        communicator.allReduce(std::span(values), Reduction::sum);
    });
    EXPECT_NE(error.find("another rank gave"), std::string::npos) << error;
}

TEST(MakeCommunicator, IsSerialWithoutALauncher)
{
    EXPECT_EQ(makeCommunicator()->name(), "serial");
}

}  // namespace
}  // namespace aeolic
