#include "stream/gateway/job_process.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "aeolic/error.h"

namespace aeolic::stream {
namespace {

using Words = std::vector<std::string>;
using namespace std::chrono_literals;

TEST(LauncherWords, AreSplitAsAShellSplits)
{
    EXPECT_EQ(launcherWords("mpirun -n {ranks}", 8), (Words{"mpirun", "-n", "8"}));
    EXPECT_EQ(launcherWords("  srun\t-n{ranks}x{ranks}\n", 12), (Words{"srun", "-n12x12"}));
    EXPECT_EQ(launcherWords("a 'b  c' \"d 'e'\" f\\ g h'i'j", 1), (Words{"a", "b  c", "d 'e'", "f g", "hij"}));
    EXPECT_EQ(launcherWords("a '' \"\"", 1), (Words{"a", "", ""})) << "empty words are words";
    EXPECT_EQ(launcherWords(R"('a\b' "c\"d")", 1), (Words{"a\\b", "c\"d"}));
    EXPECT_EQ(launcherWords("a $HOME;b|c `d` {rank}", 1), (Words{"a", "$HOME;b|c", "`d`", "{rank}"})) << "no shell";
}

TEST(LauncherWords, NothingAndOpenQuotesAreRefused)
{
    for (const char* wrong : {"", "  \t", "mpirun 'x", "mpirun \"x", "'"})
        EXPECT_THROW(launcherWords(wrong, 1), InputError);
}

/// How the process ends, within ten seconds.
std::string endOf(JobProcess& process)
{
    for (int i = 0; i < 1000; ++i) {
        if (const auto how = process.ended()) return *how;
        std::this_thread::sleep_for(10ms);
    }
    return "still runs";
}

TEST(JobProcess, TellsHowItEnded)
{
    JobProcess done({"true"}, ""), wrong({"sh", "-c", "exit 7"}, "");
    EXPECT_EQ(endOf(done), "ended with code 0");
    EXPECT_EQ(endOf(wrong), "ended with code 7");
    EXPECT_EQ(endOf(wrong), "ended with code 7") << "and goes on telling";
}

TEST(JobProcess, KeepsWhatItWroteLast)
{
    JobProcess talks({"sh", "-c", "echo first; seq 100000 | tail -c 20000; echo why >&2; exit 1"}, "");
    EXPECT_EQ(endOf(talks), "ended with code 1");
    EXPECT_TRUE(talks.written().ends_with("100000\nwhy\n"));
    EXPECT_EQ(talks.written().size(), 4096u);
}

TEST(JobProcess, TellsTheSignalThatEndedIt)
{
    JobProcess process({"sleep", "100"}, "");
    EXPECT_FALSE(process.ended());
    process.signal(SIGKILL);
    EXPECT_EQ(endOf(process), "was ended by signal 9 (Killed)");
}

TEST(JobProcess, GetsItsLineOnStandardInputAndThenTheEnd)
{
    JobProcess process({"sh", "-c", "read line; read more; [ \"$line/$more\" = 'a secret/' ]"}, "a secret\n");
    EXPECT_EQ(endOf(process), "ended with code 0");
}

TEST(JobProcess, OneThatEndsBeforeItReadsItsLineEndsNobodyElse)
{
    for (int i = 0; i < 50; ++i) {  // Whether the process has gone when the line is written is a matter of luck.
        JobProcess process({"true"}, std::string(4000, 'x'));
        EXPECT_EQ(endOf(process), "ended with code 0");
    }
}

TEST(JobProcess, WhatCannotBeStartedIsNamed)
{
    for (const char* name : {"/no/such/launcher", "no-such-launcher", "/tmp", "/etc/hostname"}) try {
            JobProcess process({name, "-n", "3"}, "x");
            ADD_FAILURE() << name;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        }
}

/// Ends a shell that runs `script`, which writes another process's number into $FILE, and expects that one's end.
void expectEndOfAll(const std::string& script)
{
    const auto file = std::filesystem::temp_directory_path() / ("aeolic_group_" + std::to_string(getpid()));
    pid_t grandchild = 0;
    {
        JobProcess process({"sh", "-c", "FILE='" + file.string() + "'; " + script}, "");
        for (int i = 0; i < 1000 && !(std::ifstream(file) >> grandchild); ++i) std::this_thread::sleep_for(10ms);
        ASSERT_GT(grandchild, 0);
        EXPECT_EQ(kill(grandchild, 0), 0);
    }
    std::filesystem::remove(file);
    const auto isGone = [&] {  // Whoever adopts it may be slow to bury it.
        std::ifstream stat("/proc/" + std::to_string(grandchild) + "/stat");
        std::string pid, name, state;
        return !(stat >> pid >> name >> state) || state == "Z" || state == "X";
    };
    for (int i = 0; i < 1000 && !isGone(); ++i) std::this_thread::sleep_for(10ms);
    EXPECT_TRUE(isGone());
}

TEST(JobProcess, TakesItsWholeGroupWithIt)
{
    expectEndOfAll("sleep 100 & echo $! >$FILE; wait");
}

TEST(JobProcess, TakesProcessesOfOtherGroupsWithIt)
{
    // `timeout` gives itself a process group of its own.
    expectEndOfAll("timeout 100 sleep 100 & sleep 0.3; echo $! >$FILE; sleep 100");
}

TEST(JobProcess, HoldsNoneOfTheGatewaysFiles)
{
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t pid = [&] {
        JobProcess process({"sleep", "100"}, "");
        close(ends[1]);
        pollfd end{ends[0], POLLIN, 0};
        EXPECT_EQ(poll(&end, 1, 5000), 1) << "the process keeps open what the gateway has closed";
        return process.pid();
    }();
    EXPECT_GT(pid, 0);
    close(ends[0]);
}

TEST(JobProcess, DoesNotInheritWhatTheGatewayIgnores)
{
    // Python and shells leave signals ignored; a rank that ignores SIGTERM could not be asked to end.
    const auto before = ::signal(SIGTERM, SIG_IGN);
    JobProcess process({"sleep", "100"}, "");
    ::signal(SIGTERM, before);
    process.signal(SIGTERM);
    EXPECT_EQ(endOf(process), "was ended by signal 15 (Terminated)");
}

}  // namespace
}  // namespace aeolic::stream
