#include "scaling/measured_frames.h"

#include <gtest/gtest.h>

#include "ranks/thread_communicator.h"
#include "render_testing.h"

namespace aeolic {
namespace {

using namespace testkit;

RankStats rankOf(double projectMs, double convolveMs, int rows)
{
    RankStats rank;
    rank.project.busyMs = projectMs;
    rank.convolve.busyMs = convolveMs;
    rank.busyMs = projectMs + convolveMs;
    rank.rows = rows;
    return rank;
}

TEST(LeastOf, TheLeastTimeOfEachStage)
{
    const RankStats least = leastOf({rankOf(1, 9, 10), rankOf(8, 2, 11), rankOf(2, 30, 12)});
    EXPECT_EQ(least.project.busyMs, 1);
    EXPECT_EQ(least.convolve.busyMs, 2);
    EXPECT_EQ(least.busyMs, 3);
    EXPECT_EQ(least.rows, 12) << "of the last";
}

TEST(LeastOf, OneIsItself)
{
    const RankStats only = leastOf({rankOf(1, 2, 5)});
    EXPECT_EQ(only.project.busyMs, 1);
    EXPECT_EQ(only.convolve.busyMs, 2);
    EXPECT_EQ(only.busyMs, 3);
}

/// Frames as ranks draw them together and as they are measured: body(measured, drawn) on every rank.
template <class Body>
void compareFrames(int ranks, const RunOptions& options, const std::vector<FrameRequest>& requests, const Scene& scene,
                   const Body& body)
{
    std::mutex alone;
    runRanks(ranks, [&](Communicator& communicator) {
        const auto backend = makeBackend(BackendChoice::cpu, scene), other = makeBackend(BackendChoice::cpu, scene);
        MeasuredFrames frames(scene, *backend, communicator, options, alone);
        FrameGroup group(std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}), options);
        Frame frame;
        for (const FrameRequest& request : requests) {
            const RanksOfFrame measured = frames.draw(request, 2);
            renderFrame(request, scene, *other, group, frame);
            body(measured, frame.stats.ranks);
        }
    });
}

std::vector<FrameRequest> requestsFor(const Scene& scene, LicMethod method)
{
    std::vector<FrameRequest> requests;
    for (const auto& [width, height] :
         {std::pair(120, 90), std::pair(120, 90), std::pair(60, 140), std::pair(90, 90)}) {
        requests.push_back({fitCamera(scene, {}, width, height), directLic(20), {}});
        requests.back().lic.method = method;
    }
    return requests;
}

TEST(MeasuredFrames, AreWhatRanksDrawTogether)
{
    const Scene scene = makeBuiltinScene("teapot:2000", "abc:16,16,16");
    for (const Balance balancer : {Balance::equal, Balance::pixels}) {  // These two do not go by times.
        RunOptions options;
        options.balance = balancer;
        for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical})
            compareFrames(3, options, requestsFor(scene, method), scene,
                          [](const RanksOfFrame& measured, const RanksOfFrame& drawn) {
                              ASSERT_EQ(measured.size(), drawn.size());
                              for (std::size_t r = 0; r < drawn.size(); ++r) {
                                  EXPECT_EQ(measured[r].rank, int(r));
                                  EXPECT_EQ(measured[r].rows, drawn[r].rows);
                                  EXPECT_EQ(measured[r].pixels, drawn[r].pixels);
                                  EXPECT_EQ(measured[r].sentBytes, drawn[r].sentBytes);
                                  EXPECT_EQ(measured[r].sentMessages, drawn[r].sentMessages);
                                  EXPECT_EQ(measured[r].convolve.receivedBytes, drawn[r].convolve.receivedBytes);
                                  EXPECT_GT(measured[r].project.busyMs, 0);
                                  EXPECT_GT(measured[r].busyMs, measured[r].project.busyMs);
                              }
                          });
    }
}

/// Stripes that go by times differ each time. A recorded frame is drawn again in its own stripes.
TEST(MeasuredFrames, BalancingByTimesGoesByThoseMeasured)
{
    const Scene scene = makeBuiltinScene("teapot:2000", "abc:16,16,16");
    for (const Balance balancer : {Balance::timing, Balance::hybrid}) {
        RunOptions options;
        options.balance = balancer;
        std::vector<FrameRequest> requests;
        for (int i = 0; i < 3; ++i)
            for (const FrameRequest& request : requestsFor(scene, LicMethod::hierarchical)) requests.push_back(request);
        compareFrames(4, options, requests, scene, [](const RanksOfFrame& measured, const RanksOfFrame&) {
            std::int64_t pixels = 0;
            int row = 0;
            for (const RankStats& rank : measured) {
                EXPECT_EQ(rank.firstRow, row) << "all ranks' stripes are of the same partition";
                row += rank.rows;
                pixels += rank.pixels;
            }
            EXPECT_TRUE(row == 90 || row == 140) << row;
            EXPECT_GT(pixels, 0);
        });
    }
}

TEST(MeasuredFrames, OneRankAloneIsMeasuredTheSameWay)
{
    const Scene scene = makeBuiltinScene("sphere:500", "rotation:8,8,8");
    compareFrames(1, {}, requestsFor(scene, LicMethod::direct), scene,
                  [](const RanksOfFrame& measured, const RanksOfFrame& drawn) {
                      ASSERT_EQ(measured.size(), 1u);
                      EXPECT_EQ(measured[0].pixels, drawn[0].pixels);
                      EXPECT_GT(measured[0].busyMs, 0);
                  });
}

}  // namespace
}  // namespace aeolic
