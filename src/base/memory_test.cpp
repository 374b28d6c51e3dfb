#include "base/memory.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include "aeolic/error.h"
#include "base/image.h"
#include "base/memory_testing.h"

namespace aeolic {
namespace {

using test::TightAddressSpace;

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
    constexpr std::uint64_t room = 64u << 20;
    std::uint64_t available = 0;
    {
        const TightAddressSpace tight(room);
        if (!tight.set()) GTEST_SKIP() << "this process cannot have so little memory";
        available = availableMemoryBytes();
    }
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

TEST(RequireMemory, SmallSizesAreToldInMebibytes)
{
    std::string what;
    {
        const TightAddressSpace tight(64u << 20);
        if (!tight.set()) GTEST_SKIP() << "this process cannot have so little memory";
        try {
            requireMemory("--field", "'abc'", (100u << 20) + 1);
        } catch (const InputError& error) {
            what = error.what();
        }
    }
    EXPECT_EQ(what.find("--field: 'abc' needs 101 MiB; expected at most the "), 0u) << what;
    EXPECT_NE(what.find(" MiB of memory that is available"), std::string::npos) << what;
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // Their allocators end the program instead.

/// What images do where malloc() gives a null pointer.
TEST(ImageMemory, NoMemoryIsAnExceptionAndTheImageIsUsableAfterwards)
{
    Image<std::uint32_t> image;
    image.resize({0, 0, 10, 10});
    {
        const TightAddressSpace tight(16u << 20);
        if (!tight.set()) GTEST_SKIP() << "this process cannot have so little memory";
        EXPECT_THROW(image.resize({0, 0, 8000, 8000}), std::bad_alloc);
    }
    image.resize({0, 0, 20, 20});
    image.at(19, 19) = 7;
    EXPECT_EQ(image.at(19, 19), 7u);
}

#endif

}  // namespace
}  // namespace aeolic
