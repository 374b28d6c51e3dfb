#include "engine/frame_group.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "engine/frame_stats.h"
#include "ranks/thread_communicator.h"
#include "render_testing.h"

namespace aeolic {
namespace {

using namespace testkit;

/// Lets a test say what the ranks took.
struct ToldGroup : FrameGroup {
    using FrameGroup::FrameGroup;
    using FrameGroup::remember;
};

/// What two ranks compute, the second of which has twice the threads of the first, after some frames. All threads are
/// equally fast.
std::vector<double> workOfOneAndTwoThreads(Balance balance)
{
    const Scene scene = makeBuiltinScene("plane:200", "rotation:8,8,8");
    CameraOptions near;
    near.zoom = 4;  // The plane fills the picture.
    const Camera camera = fitCamera(scene, near, 60, 300);
    std::vector<double> work(2);
    runRanks(2, [&](Communicator& ranks) {
        RunOptions options;
        options.balance = balance;
        ToldGroup group({&ranks, [](Communicator*) {}}, options);
        const auto backend = makeBackend(BackendChoice::cpu, scene);
        const LicOptions lic = directLic(4);
        FramePlan plan;
        for (int frame = 0; frame < 40; ++frame) {
            group.partition(makeView(camera, scene, lic), lic, scene, *backend, plan);
            std::vector<RankStats> took(2);
            const RowSums sums(plan.coverage);
            for (int r = 0; r < 2; ++r) {
                RankStats& mine = took[std::size_t(r)];
                mine.rank = r;
                mine.firstRow = plan.stripes.firstRow[std::size_t(r)];
                mine.rows = plan.stripes.rows(r);
                mine.convolve.busyMs = plan.coverage.empty()
                                           ? mine.rows
                                           : stripeCost(sums, plan.costs, mine.firstRow, mine.firstRow + mine.rows);
                if (ranks.isRoot()) work[std::size_t(r)] = mine.convolve.busyMs;
                mine.convolve.workMs = mine.convolve.busyMs / (r + 1);
            }
            group.remember(plan, took);
        }
    });
    return work;
}

/// A node with more cores does more in the same time. Its threads' CPU times add up to as much as a small node's.
TEST(FrameGroup, ARankWithTwiceTheThreadsGetsTwiceTheWork)
{
    for (const Balance balance : {Balance::hybrid, Balance::timing}) {
        const std::vector<double> work = workOfOneAndTwoThreads(balance);
        EXPECT_NEAR(work[1] / work[0], 2, 0.2) << int(balance);
    }
}

/// A communicator as of a process, whose partner comes late.
class LatePartner final : public Communicator {
public:
    static constexpr auto kLate = std::chrono::milliseconds(60);
    std::string name() const override { return "late"; }
    int rank() const override { return 0; }
    int size() const override { return 2; }
    [[noreturn]] void abortJob(const std::string& message, int) override { throw std::runtime_error(message); }

private:
    void doBarrier() override { std::this_thread::sleep_for(kLate); }
    void doBroadcast(Bytes&, int) override {}
    void doGather(std::vector<Bytes>&, ByteSpan, int) override {}
    std::vector<Bytes> doAllGather(ByteSpan) override { return {{}, {}}; }
    std::vector<std::int64_t> doAllToAll(const std::vector<std::int64_t>& toRank) override { return toRank; }
    void doExchange(const std::vector<OutgoingBytes>&, const std::vector<IncomingBytes>&) override {}
};

/// What several threads do at the same time counts once, and waiting for other ranks does not count.
TEST(FrameClock, WorkIsWallTimeWithoutWaiting)
{
    LatePartner ranks;
    FrameStats frame;
    RankStats mine;
    const auto compute = [] {
        const double end = threadCpuMs() + 40;
        while (threadCpuMs() < end) {
        }
    };
    FrameClock clock(ranks, frame, mine);
    clock.time(stages::convolve, [&] {
        std::thread other(compute);
        compute();
        other.join();
        ranks.barrier();
    });
    EXPECT_GE(mine.convolve.busyMs, 80);
    EXPECT_GE(mine.convolve.workMs, 40);
    EXPECT_LE(mine.convolve.workMs, frame.convolveMs - 59) << "the partner's time";
    clock.time(stages::shade, [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); });
    EXPECT_GE(mine.shade.workMs, 20) << "a file or a device that keeps the rank waiting makes it slow";
}

}  // namespace
}  // namespace aeolic
