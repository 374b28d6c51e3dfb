#include <sched.h>

#include <array>
#include <nlohmann/json.hpp>

#include "mpirun_testing.h"

/// Ranks with different numbers of threads, as on a cluster of unequal nodes.
namespace aeolic {
namespace {

using namespace testkit;

class MpirunThreads : public MpirunTest {
protected:
    static constexpr int kFrames = 12;

    static std::string scene(const std::string& options)
    {
        return "render --surface sphere:4000 --field abc:32,32,32 --camera zoom=2.5 --size 240x242 --lic direct "
               "--steps 48 --orbit 0 --frames " +
               std::to_string(kFrames) + " " + options;
    }

    /// Two ranks, each with threads of its own. All share one core, where a scheduler gives each thread as much time as
    /// any other. On several it may leave a rank's two threads on one and the other rank alone on another.
    Ended render(int first, int second, const std::string& options) const
    {
        const std::string words = onOneCore() + aeolic() + scene(options) + " --threads ";
        return mpirun("--bind-to none -n 1 " + words + std::to_string(first) + " : -n 1 " + words +
                      std::to_string(second));
    }

    /// Both halves of the picture are alike, and either rank has more threads in turn. With equally many threads the
    /// shares are within a twentieth of each other, with twice as many they are 1.6 to 2 times as large.
    void expectMoreRowsForMoreThreads(const std::string& options) const
    {
        const auto [few, many] = rowsOf(1, 2, options);
        EXPECT_GT(many, 1.25 * few);
        const auto [manyAbove, fewBelow] = rowsOf(2, 1, options);
        EXPECT_GT(manyAbove, 1.25 * fewBelow);
    }

private:
    static std::string onOneCore()
    {
        cpu_set_t allowed;
        CPU_ZERO(&allowed);
        sched_getaffinity(0, sizeof allowed, &allowed);
        int core = 0;
        while (core < CPU_SETSIZE - 1 && !CPU_ISSET(core, &allowed)) ++core;
        return "taskset -c " + std::to_string(core) + " ";
    }

    /// The rows of each rank, added up over the second half of the frames.
    std::array<int, 2> rowsOf(int first, int second, const std::string& options) const
    {
        const Ended ended = render(first, second, options + " --stats a.json -o a.png");
        EXPECT_EQ(ended.exitCode, 0) << ended.err;
        std::array<int, 2> rows{};
        if (ended.exitCode != 0) return rows;
        const auto stats = nlohmann::json::parse(bytes("a.json"));
        EXPECT_EQ(stats["threads_per_rank"], nlohmann::json({first, second}));
        for (int frame = kFrames / 2; frame < kFrames; ++frame)
            for (std::size_t r = 0; r < 2; ++r)
                rows[r] += stats["frames"][std::size_t(frame)]["stripes"][r]["rows"].get<int>();
        return rows;
    }
};

TEST_F(MpirunThreads, WhoHasMoreGetsMoreRowsByTiming)
{
    expectMoreRowsForMoreThreads("--balance timing");
}

TEST_F(MpirunThreads, WhoHasMoreGetsMoreRowsByHybrid)
{
    expectMoreRowsForMoreThreads("--balance hybrid");
}

TEST_F(MpirunThreads, ThePictureIsTheSame)
{
    ASSERT_EQ(renderAlone(scene("-o alone.png").substr(7)).exitCode, 0);
    const Ended ended = render(1, 2, "-o together.png");
    ASSERT_EQ(ended.exitCode, 0) << ended.err;
    for (const std::string frame : {"-0000.png", "-0011.png"})
        EXPECT_TRUE(bytes("alone" + frame) == bytes("together" + frame)) << frame;
}

}  // namespace
}  // namespace aeolic
