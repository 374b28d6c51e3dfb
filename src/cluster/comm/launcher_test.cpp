#include "cluster/comm/launcher.h"

#include <gtest/gtest.h>

#include <map>

namespace aeolic {
namespace {

Launch launchIn(const std::map<std::string, std::string>& variables)
{
    return detectLaunch([&](const char* name) -> const char* {
        const auto found = variables.find(name);
        return found == variables.end() ? nullptr : found->second.c_str();
    });
}

TEST(Launcher, NoneOnAPlainCommandLine)
{
    EXPECT_EQ(launchIn({{"HOME", "/home/u"}}).variable, "");
}

TEST(Launcher, MpirunOfOpenMpiAndMpich)
{
    EXPECT_EQ(launchIn({{"OMPI_COMM_WORLD_SIZE", "4"}, {"PMIX_RANK", "0"}}).ranks, 4);
    EXPECT_EQ(launchIn({{"PMI_SIZE", "3"}, {"PMI_RANK", "2"}}).ranks, 3);
}

TEST(Launcher, SrunWithPmix)
{
    const Launch launch = launchIn({{"PMIX_RANK", "1"}, {"SLURM_PROCID", "1"}, {"SLURM_STEP_NUM_TASKS", "16"}});
    EXPECT_EQ(launch.variable, "PMIX_RANK");
    EXPECT_EQ(launch.ranks, 16);
    EXPECT_EQ(launchIn({{"PMIX_RANK", "0"}}).ranks, 0) << "another PMIx launcher: the size is not told";
}

TEST(Launcher, ABatchScriptOrTheShellOfAnAllocationIsNoParallelJob)
{
    EXPECT_EQ(launchIn({{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "64"}}).variable, "");
    EXPECT_EQ(launchIn({{"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "1"}}).variable, "");
}

TEST(Launcher, SeveralSlurmTasksWithoutPmiAreNotTakenForSeveralJobs)
{
    EXPECT_EQ(launchIn({{"SLURM_PROCID", "2"}, {"SLURM_STEP_NUM_TASKS", "4"}}).ranks, 4);
}

TEST(Launcher, MpirunInsideASlurmStepCounts)
{
    EXPECT_EQ(launchIn({{"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "2"}, {"OMPI_COMM_WORLD_SIZE", "96"}}).ranks,
              96);
}

}  // namespace
}  // namespace aeolic
