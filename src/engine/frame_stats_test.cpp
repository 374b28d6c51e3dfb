#include "engine/frame_stats.h"

#include <gtest/gtest.h>

#include <numeric>

#include "engine/frame.h"
#include "ranks/thread_communicator.h"
#include "render_testing.h"

/// What statistics say of bytes and pixels, against what can be counted otherwise.
namespace aeolic {
namespace {

using namespace testkit;

constexpr int kRanks = 3, kWidth = 120, kHeight = 150;

/// The second of two frames of a sphere on so many ranks, and each rank's rows.
struct Drawn {
    std::vector<RankStats> ranks;
    std::vector<FrameRows> rows;
};

Drawn draw(GuardRowsChoice guardRows, LicMethod method, int ranks = kRanks)
{
    const Scene scene = makeBuiltinScene("sphere:2000", "abc:16,16,16");
    Drawn drawn;
    drawn.rows.resize(std::size_t(ranks));
    runRanks(ranks, [&](Communicator& communicator) {
        RunOptions options;
        options.guardRows = guardRows;
        FrameGroup group({&communicator, [](Communicator*) {}}, options);
        const auto backend = makeBackend(BackendChoice::cpu, scene);
        FrameRequest request{fitCamera(scene, {}, kWidth, kHeight), directLic(12), {}};
        request.lic.method = method;
        Frame frame;
        for (int i = 0; i < 2; ++i) renderFrame(request, scene, *backend, group, frame);
        drawn.rows[std::size_t(communicator.rank())] = frame.plan.rows;
        if (communicator.isRoot()) drawn.ranks = frame.stats.ranks;
    });
    return drawn;
}

/// [height] Pixels of each row that the sphere covers.
std::vector<std::int64_t> coveredRows()
{
    Stages stages("cpu", makeBuiltinScene("sphere:2000", "abc:16,16,16"));
    const GBuffer& buffer = stages.project(fitCamera(stages.scene, {}, kWidth, kHeight), directLic(12));
    std::vector<std::int64_t> rows(kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) rows[std::size_t(y)] += buffer.invDepth.at(x, y) > 0;
    return rows;
}

std::int64_t sumOf(const std::vector<std::int64_t>& rows, int y0, int y1)
{
    return std::accumulate(rows.begin() + y0, rows.begin() + y1, std::int64_t{0});
}

TEST(FrameStats, PixelsOfTheStripeAndOfTheGuardsDrawnAgain)
{
    const std::vector<std::int64_t> covered = coveredRows();
    const Drawn drawn = draw(GuardRowsChoice::project, LicMethod::direct);
    ASSERT_EQ(drawn.ranks.size(), std::size_t(kRanks));
    for (std::size_t r = 0; r < kRanks; ++r) {
        const RankStats& rank = drawn.ranks[r];
        const FrameRows& rows = drawn.rows[r];
        EXPECT_EQ(rank.rank, int(r));
        EXPECT_EQ(rank.firstRow, rows.stripe.y0);
        EXPECT_EQ(rank.rows, rows.stripe.height());
        ASSERT_EQ(rank.guardAbove, r == 0 ? 0 : rows.stripe.y0 - rows.valid.y0);
        ASSERT_EQ(rank.guardBelow, r == kRanks - 1 ? 0 : rows.valid.y1 - rows.stripe.y1);
        EXPECT_EQ(rank.pixels, sumOf(covered, rows.stripe.y0, rows.stripe.y1));
        const std::int64_t above = sumOf(covered, rows.stripe.y0 - rank.guardAbove, rows.stripe.y0),
                           below = sumOf(covered, rows.stripe.y1, rows.stripe.y1 + rank.guardBelow);
        EXPECT_EQ(rank.guardPixels, above + below) << "rank " << r;
        EXPECT_EQ(above > 0, r > 0);
        EXPECT_EQ(below > 0, r < kRanks - 1);
    }
}

TEST(FrameStats, GuardsThatAreReceivedAreNotDrawn)
{
    const Drawn drawn = draw(GuardRowsChoice::receive, LicMethod::direct);
    for (const RankStats& rank : drawn.ranks) {
        EXPECT_EQ(rank.guardPixels, 0);
        EXPECT_EQ(rank.guardAbove > 0, rank.rank > 0) << "but they are read";
        EXPECT_EQ(rank.guardBelow > 0, rank.rank < kRanks - 1);
        EXPECT_GT(rank.convolve.receivedMessages, 0);
        const int neighbours = (rank.rank > 0) + (rank.rank < kRanks - 1);
        EXPECT_GE(rank.convolve.receivedBytes, neighbours * kWidth * 4) << "at least a row of each neighbour's flow";
    }
}

/// All that is sent is received, in the same stage.
TEST(FrameStats, RanksReceiveWhatOthersSend)
{
    for (const GuardRowsChoice guardRows : {GuardRowsChoice::project, GuardRowsChoice::receive})
        for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
            const Drawn drawn = draw(guardRows, method);
            for (const StageFields& stage : stages::all) {
                std::int64_t sentBytes = 0, receivedBytes = 0, sentMessages = 0, receivedMessages = 0;
                for (const RankStats& rank : drawn.ranks) {
                    const StageStats& mine = rank.*stage.rank;
                    sentBytes += mine.sentBytes, receivedBytes += mine.receivedBytes;
                    sentMessages += mine.sentMessages, receivedMessages += mine.receivedMessages;
                }
                EXPECT_EQ(receivedBytes, sentBytes);
                EXPECT_EQ(receivedMessages, sentMessages);
            }
            for (const RankStats& rank : drawn.ranks) {
                std::int64_t bytes = 0, messages = 0;
                for (const StageFields& stage : stages::all) {
                    bytes += (rank.*stage.rank).sentBytes;
                    messages += (rank.*stage.rank).sentMessages;
                }
                EXPECT_EQ(rank.sentBytes, bytes);
                EXPECT_EQ(rank.sentMessages, messages);
            }
        }
}

/// The picture goes to rank 0: it receives what all others send, and they receive nothing.
TEST(FrameStats, TheFirstRankReceivesThePicture)
{
    const Drawn drawn = draw(GuardRowsChoice::project, LicMethod::direct);
    std::int64_t sent = 0;
    for (const RankStats& rank : drawn.ranks) {
        sent += rank.gather.sentBytes;
        EXPECT_EQ(rank.gather.sentBytes > 0, rank.rank > 0);
        EXPECT_EQ(rank.gather.receivedBytes > 0, rank.rank == 0);
        EXPECT_EQ(rank.gather.sentMessages, rank.rank > 0 ? 1 : 0) << "of this frame alone";
        EXPECT_EQ(rank.gather.receivedMessages, rank.rank == 0 ? kRanks - 1 : 0);
    }
    EXPECT_EQ(drawn.ranks[0].gather.receivedBytes, sent);
    for (std::size_t r = 1; r < kRanks; ++r) {
        EXPECT_GE(drawn.ranks[r].gather.sentBytes, 3 * drawn.ranks[r].pixels) << "three bytes a covered pixel";
        EXPECT_LE(drawn.ranks[r].gather.sentBytes, 3 * kWidth * (drawn.ranks[r].rows + 2) + 16 * kHeight);
    }
}

TEST(FrameStats, AloneNothingIsSent)
{
    const Drawn drawn = draw(GuardRowsChoice::automatic, LicMethod::hierarchical, 1);
    const RankStats& rank = drawn.ranks.at(0);
    EXPECT_EQ(rank.guardPixels, 0);
    EXPECT_EQ(rank.sentBytes, 0);
    for (const StageFields& stage : stages::all) EXPECT_EQ((rank.*stage.rank).receivedBytes, 0);
}

}  // namespace
}  // namespace aeolic
