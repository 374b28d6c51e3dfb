#include "cluster/comm/hosts.h"

#include <gtest/gtest.h>

#include "cluster/comm/communicator.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

RankPlace place(const std::string& host, const std::vector<std::uint8_t>& cores)
{
    return {host, cores};
}

/// By rank.
std::vector<HostShare> sharesOf(const std::vector<RankPlace>& places)
{
    std::vector<HostShare> shares;
    for (int r = 0; r < int(places.size()); ++r) shares.push_back(shareOf(places, r));
    return shares;
}

const std::vector<std::uint8_t> kAllOfEight(8, true);

TEST(HostShare, AloneARankHasAllItMayRunOn)
{
    EXPECT_EQ(sharesOf({place("a", kAllOfEight)}), (std::vector<HostShare>{{1, 8}}));
    EXPECT_EQ(sharesOf({place("a", {true, false, true})}), (std::vector<HostShare>{{1, 2}}));
}

TEST(HostShare, RanksThatMayRunAnywhereShareTheirOwnHostAlone)
{
    const RankPlace a = place("a", kAllOfEight), b = place("b", kAllOfEight);
    EXPECT_EQ(sharesOf({a, b, a, a, a}), (std::vector<HostShare>{{4, 2}, {1, 8}, {4, 2}, {4, 2}, {4, 2}}));
}

TEST(HostShare, BoundRanksHaveWhatTheyAreBoundTo)
{
    const RankPlace left = place("a", {true, true, true, true}),
                    right = place("a", {false, false, false, false, true, true});
    EXPECT_EQ(sharesOf({left, right}), (std::vector<HostShare>{{2, 4}, {2, 2}}));
}

/// A container or a batch system gave the whole job half the machine: that is no binding of a rank.
TEST(HostShare, TheJobsPartOfAMachineIsSharedToo)
{
    const RankPlace part = place("a", {false, false, false, false, true, true, true, true});
    EXPECT_EQ(sharesOf({part, part}), (std::vector<HostShare>{{2, 2}, {2, 2}}));
}

TEST(HostShare, OverlappingCoresAreSplitAmongThoseWhoMayUseThem)
{
    const RankPlace wide = place("a", {true, true, true, true}), narrow = place("a", {false, false, true, true});
    EXPECT_EQ(sharesOf({wide, narrow}), (std::vector<HostShare>{{2, 3}, {2, 1}}));
}

TEST(HostShare, ThirdsAddUpToAWholeCore)
{
    const RankPlace three = place("a", {true, true, true});
    EXPECT_EQ(sharesOf({three, three, three}), (std::vector<HostShare>{{3, 1}, {3, 1}, {3, 1}}));
}

TEST(HostShare, MoreRanksThanCoresGetOneEach)
{
    const RankPlace one = place("a", {true});
    EXPECT_EQ(sharesOf({one, one, one}), (std::vector<HostShare>{{3, 1}, {3, 1}, {3, 1}}));
}

TEST(IndexOnHost, CountsTheRanksBeforeOnTheSameHost)
{
    const RankPlace a = place("a", kAllOfEight), b = place("b", kAllOfEight);
    const std::vector<RankPlace> places{a, b, a, b, a};
    for (const auto& [rank, index] :
         {std::pair(0, 0), std::pair(1, 0), std::pair(2, 1), std::pair(3, 1), std::pair(4, 2)})
        EXPECT_EQ(indexOnHost(places, rank), index) << rank;
}

TEST(HostShare, WhereNothingIsToldItIsAtLeastOneCore)
{
    for (const HostShare& share : sharesOf({place("a", {}), place("a", {})})) {
        EXPECT_EQ(share.ranks, 2);
        EXPECT_GE(share.cores, 1);
    }
}

TEST(HostShare, OfThisHostAndAllRanksOfATestAreOnIt)
{
    const RankPlace here = placeOfThisProcess();
    EXPECT_FALSE(here.host.empty());
    const HostShare alone = hostShare(*makeSerialCommunicator());
    EXPECT_EQ(alone.ranks, 1);
    for (const int ranks : {2, 5})
        runRanks(ranks, [&](Communicator& communicator) {
            const HostShare share = hostShare(communicator);
            EXPECT_EQ(share.ranks, ranks);
            EXPECT_EQ(share.cores, std::max(1, alone.cores / ranks));
        });
}

}  // namespace
}  // namespace aeolic
