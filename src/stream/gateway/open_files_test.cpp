#include "stream/gateway/open_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "aeolic/error.h"

namespace aeolic::stream {
namespace {

TEST(OpenFiles, HalfOfWhatRanksLeaveIsForViewers)
{
    EXPECT_EQ(webConnections(1u << 20, 1), 1024);
    EXPECT_EQ(webConnections(128, 1), 23);
    EXPECT_EQ(webConnections(1104, 1000), 12);
    EXPECT_EQ(webConnections(~std::uint64_t{0}, 65536), 1024) << "no limit at all";
}

TEST(OpenFiles, TooFewAreRefusedWithWhatIsPossible)
{
    EXPECT_NO_THROW(webConnections(1024, 928));
    try {
        webConnections(1024, 929);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("--ranks: 929"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("at most 928 ranks"), std::string::npos) << error.what();
    }
    for (const std::uint64_t few : {0, 3, 80, 96}) EXPECT_THROW(webConnections(few, 1), InputError) << few;
}

/// In a process of its own, because a limit cannot be raised again.
TEST(OpenFiles, TheLimitIsRaisedAsFarAsItIsOfUse)
{
    const pid_t child = fork();
    if (child == 0) {
        rlimit files{};
        getrlimit(RLIMIT_NOFILE, &files);
        files.rlim_cur = 64;
        setrlimit(RLIMIT_NOFILE, &files);
        const int web = provideOpenFiles(100);
        getrlimit(RLIMIT_NOFILE, &files);
        const bool raised = files.rlim_cur == std::min<rlim_t>(files.rlim_max, 80 + 100 + 2 * 1024);
        _exit(raised && (web == 1024 || files.rlim_max < 2300) ? 0 : 1);
    }
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace aeolic::stream
