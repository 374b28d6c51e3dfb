#include "base/memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "aeolic/error.h"

namespace aeolic {
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

/// A /proc and /sys of our own in a temporary folder.
class CgroupTree : public testing::Test {
protected:
    void SetUp() override
    {
        root_ = std::filesystem::path(testing::TempDir()) /
                (std::string("aeolic_cgroup_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(root_);
    }
    void TearDown() override { std::filesystem::remove_all(root_); }

    void write(const std::string& path, const std::string& text) const
    {
        std::filesystem::create_directories((root_ / path).parent_path());
        std::ofstream(root_ / path) << text;
    }
    std::uint64_t available() const { return cgroupAvailableBytes(root_.string()); }

private:
    std::filesystem::path root_;
};

TEST_F(CgroupTree, Version2CountsDroppableCacheAsFree)
{
    write("proc/self/cgroup", "0::/job\n");
    write("sys/fs/cgroup/job/memory.max", "1000\n");
    write("sys/fs/cgroup/job/memory.current", "700\n");
    write("sys/fs/cgroup/job/memory.stat", "anon 500\ninactive_file 150\nfile 200\n");
    EXPECT_EQ(available(), 1000u - (700u - 150u));
}

TEST_F(CgroupTree, TheTightestAncestorDecides)
{
    write("proc/self/cgroup", "0::/site/user/job\n");
    write("sys/fs/cgroup/site/user/job/memory.max", "max\n");
    write("sys/fs/cgroup/site/user/job/memory.current", "10\n");
    write("sys/fs/cgroup/site/user/memory.max", "500\n");
    write("sys/fs/cgroup/site/user/memory.current", "100\n");
    write("sys/fs/cgroup/site/memory.max", "5000\n");
    write("sys/fs/cgroup/site/memory.current", "100\n");
    EXPECT_EQ(available(), 400u);
}

TEST_F(CgroupTree, Version1IsReadBesideOtherControllers)
{
    write("proc/self/cgroup", "5:cpu,cpuacct:/elsewhere\n4:memory:/job\n0::/\n");
    write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "2000\n");
    write("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "1500\n");
    write("sys/fs/cgroup/memory/job/memory.stat", "inactive_file 1\ntotal_inactive_file 250\n");
    EXPECT_EQ(available(), 750u);
}

TEST_F(CgroupTree, AContainerSeesItsOwnGroupAtTheMount)
{
    write("proc/self/cgroup", "4:memory:/docker/0123abcd\n");
    write("sys/fs/cgroup/memory/memory.limit_in_bytes", "2000\n");
    write("sys/fs/cgroup/memory/memory.usage_in_bytes", "500\n");
    EXPECT_EQ(available(), 1500u);
}

TEST_F(CgroupTree, AGroupOverItsLimitHasNothingLeft)
{
    write("proc/self/cgroup", "0::/job\n");
    write("sys/fs/cgroup/job/memory.max", "1000\n");
    write("sys/fs/cgroup/job/memory.current", "1200\n");
    EXPECT_EQ(available(), 0u);
}

TEST_F(CgroupTree, NoGroupsIsNoLimit)
{
    EXPECT_EQ(available(), unlimited);
    write("proc/self/cgroup", "garbage\n0::/\n");
    EXPECT_EQ(available(), unlimited);
}

TEST(AvailableMemory, IsPositiveAndBelowWhatNoMachineHas)
{
    EXPECT_GT(availableMemoryBytes(), 1u << 20);
    EXPECT_LT(availableMemoryBytes(), std::uint64_t(1) << 60);
}

TEST(AvailableMemory, FollowsTheAddressSpaceLimit)
{
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    constexpr std::uint64_t room = 64u << 20;
    rlimit limited = before;
    limited.rlim_cur = rlim_t(pages * 4096 + room);
    if (limited.rlim_cur >= before.rlim_cur) GTEST_SKIP() << "a tighter limit, or a sanitizer's shadow, is in the way";
    ASSERT_EQ(setrlimit(RLIMIT_AS, &limited), 0);
    const std::uint64_t available = availableMemoryBytes();
    setrlimit(RLIMIT_AS, &before);
    EXPECT_LE(available, room);
    EXPECT_GT(available, room / 4);
}

TEST(RequireMemory, NamesTheOptionTheThingAndBothSizes)
{
    EXPECT_NO_THROW(requireMemory("--field", "'abc'", 1));
    try {
        requireMemory("--field", "'abc'", std::uint64_t(1) << 60);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        const std::string what = error.what();
        EXPECT_EQ(what.find("--field: 'abc' needs 1073741824.0 GiB; expected at most the "), 0u) << what;
    }
}

}  // namespace
}  // namespace aeolic
