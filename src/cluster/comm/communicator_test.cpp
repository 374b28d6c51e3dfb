#include "cluster/comm/communicator.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <stdexcept>

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

/// Uses up CPU time of this thread, as MPI does while it waits.
void spin(double ms)
{
    const double end = threadCpuMs() + ms;
    while (threadCpuMs() < end) {
    }
}

/// The first of two ranks, whose partner always comes late.
class SpinningCommunicator final : public Communicator {
public:
    SpinningCommunicator() : Communicator(BusyClock::Of::thread) {}
    static constexpr double kWaitMs = 20;

    std::string name() const override { return "spinning"; }
    int rank() const override { return 0; }
    int size() const override { return 2; }
    [[noreturn]] void abortJob(const std::string& message, int) override { throw std::runtime_error(message); }

    bool fails = false;

private:
    void wait() const
    {
        spin(kWaitMs);
        if (fails) throw std::runtime_error("rank 0: the partner never comes");
    }
    void doBarrier() override { wait(); }
    void doBroadcast(Bytes&, int) override { wait(); }
    void doGather(std::vector<Bytes>& all, ByteSpan mine, int) override
    {
        wait();
        all.assign(2, Bytes(mine.begin(), mine.end()));
    }
    std::vector<Bytes> doAllGather(ByteSpan mine) override
    {
        wait();
        return std::vector<Bytes>(2, Bytes(mine.begin(), mine.end()));
    }
    std::vector<std::int64_t> doAllToAll(const std::vector<std::int64_t>& toRank) override
    {
        wait();
        return toRank;
    }
    void doExchange(const std::vector<OutgoingBytes>&, const std::vector<IncomingBytes>&) override { wait(); }
};

TEST(CommunicatorsClock, StandsDuringEveryCollective)
{
    SpinningCommunicator communicator;
    BusyClock& busy = communicator.busy();
    Bytes bytes(8), other(8);
    std::vector<Bytes> all;
    const std::vector<std::function<void()>> collectives{
        [&] { communicator.barrier(); },
        [&] { communicator.broadcast(bytes); },
        [&] { communicator.gather(bytes); },
        [&] { communicator.gatherInto(all, bytes); },
        [&] { communicator.allGather(bytes); },
        [&] {
            communicator.allGatherInPlace(bytes, {4, 4});
        },
        [&] { communicator.allGatherValue(5); },
        [&] {
            communicator.allToAll({1, 2});
        },
        [&] { communicator.allReduce(3.0, Reduction::sum); },
        [&] { communicator.allReduce(std::int64_t(3), Reduction::max); },
        [&] {
            communicator.exchange({{1, Bytes(3)}});
        },
        [&] {
            communicator.exchangeInPlace({{1, bytes}}, {{1, other}});
        },
    };
    busy.start();
    for (std::size_t i = 0; i < collectives.size(); ++i) {
        busy.lapMs();
        collectives[i]();
        EXPECT_LT(busy.lapMs(), SpinningCommunicator::kWaitMs / 2) << "collective " << i;
        spin(5);
        EXPECT_GE(busy.lapMs(), 5) << "it goes on after collective " << i;
    }
    busy.stop();
    busy.lapMs();
    for (const auto& collective : collectives) collective();
    EXPECT_EQ(busy.lapMs(), 0) << "no collective starts it";
    communicator.fails = true;
    busy.start();
    EXPECT_THROW(communicator.barrier(), std::runtime_error);
    spin(5);
    EXPECT_GE(busy.lapMs(), 5) << "it goes on after an error";
}

TEST(CommunicatorsClock, CountsWhatEachOfSeveralThreadRanksComputesItself)
{
    static constexpr double kWorkMs = 60;
    runRanks(2, [](Communicator& communicator) {
        BusyClock& busy = communicator.busy();
        busy.start();
        if (communicator.isRoot()) spin(kWorkMs);
        communicator.barrier();
        busy.stop();
        if (communicator.isRoot())
            EXPECT_GE(busy.lapMs(), kWorkMs);
        else
            EXPECT_LT(busy.lapMs(), kWorkMs / 2);
    });
}

}  // namespace
}  // namespace aeolic
