#include "ranks/replay_communicator.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "cluster/comm/communicator.h"
#include "communicator_testing.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

using namespace testkit;

class Replay : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, Replay, ::testing::Values(1, 2, 3, 5, 8));

TEST_P(Replay, EveryOperationIsAnsweredAloneAsItWasTogether)
{
    std::atomic<int> alone = 0;
    runRanks(GetParam(), [&](Communicator& others) {
        ReplayCommunicator communicator(others);
        for (const std::string& fault : communicatorFaults(communicator)) ADD_FAILURE() << fault;
        Recording recording;
        communicator.record(recording);
        for (const std::string& fault : communicatorFaults(communicator)) ADD_FAILURE() << fault;
        const Traffic once = others.sent();
        for (int i = 0; i < 2; ++i) {
            communicator.replay(recording);
            const Traffic sent = communicator.sent(), received = communicator.received();
            for (const std::string& fault : communicatorFaults(communicator)) ADD_FAILURE() << "alone: " << fault;
            EXPECT_EQ(2 * (communicator.sent().bytes - sent.bytes), once.bytes) << "counted as if sent";
            EXPECT_EQ(2 * (communicator.sent().messages - sent.messages), once.messages);
            EXPECT_EQ(2 * (communicator.received().bytes - received.bytes), others.received().bytes);
        }
        EXPECT_EQ(others.sent(), once) << "nothing goes to the others";
        ++alone;
    });
    EXPECT_EQ(alone, GetParam());
}

TEST(Replay, OneRankDoesItAgainWhileTheOthersDoNot)
{
    runRanks(3, [](Communicator& others) {
        ReplayCommunicator communicator(others);
        Recording first, second;
        communicator.record(first);
        communicator.allReduce(std::int64_t(communicator.rank()), Reduction::sum);
        communicator.record(second);
        communicator.allReduce(std::int64_t(10 * communicator.rank()), Reduction::sum);
        if (communicator.rank() != 1) return;
        communicator.replay(second);
        EXPECT_EQ(communicator.allReduce(std::int64_t(0), Reduction::sum), 30);
        communicator.replay(first);
        EXPECT_EQ(communicator.allReduce(std::int64_t(0), Reduction::sum), 3);
    });
}

/// What is thrown when a rank does something else than was recorded.
template <class Body>
std::string errorOfReplaying(const Body& body)
{
    std::string error;
    runRanks(2, [&](Communicator& others) {
        ReplayCommunicator communicator(others);
        Recording recording;
        communicator.record(recording);
        const Bytes bytes(5);
        Bytes into(5);
        communicator.exchangeInPlace({{1 - communicator.rank(), bytes}}, {{1 - communicator.rank(), into}});
        communicator.replay(recording);
        if (communicator.rank() != 0) return;
        try {
            body(communicator);
        } catch (const std::logic_error& thrown) {
            error = thrown.what();
        }
    });
    return error;
}

TEST(Replay, SomethingElseThanWasRecordedIsAnError)
{
    EXPECT_EQ(errorOfReplaying([](Communicator& communicator) { communicator.allGather({}); }),
              "replay: allGather where exchange was recorded");
    EXPECT_EQ(errorOfReplaying([](Communicator& communicator) {
                  Bytes into(4);
                  communicator.exchangeInPlace({}, {{1, into}});
              }),
              "replay: 4 bytes from rank 1 where 5 were recorded");
    EXPECT_EQ(errorOfReplaying([](Communicator& communicator) {
                  Bytes into(5);
                  communicator.exchangeInPlace({}, {{1, into}});
                  communicator.allGather({});
              }),
              "replay: allGather after all that was recorded");
}

}  // namespace
}  // namespace aeolic
