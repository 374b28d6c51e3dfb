#include "output/output_check.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "aeolic/error.h"
#include "aeolic/picture.h"

namespace aeolic {
namespace {

namespace fs = std::filesystem;

class OutputCheck : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_ = fs::temp_directory_path() / ("aeolic_output_" + std::to_string(getpid()));
};

TEST_F(OutputCheck, NewAndExistingFilesAreFineAndUntouched)
{
    const std::string path = (folder_ / "a.png").string();
    EXPECT_NO_THROW(checkWritable(path));
    EXPECT_FALSE(fs::exists(path));
    std::ofstream(path) << "old";
    EXPECT_NO_THROW(checkWritable(path));
    EXPECT_EQ(fs::file_size(path), 3u);
    EXPECT_NO_THROW(checkWritable("in_the_current_folder.png"));
}

TEST_F(OutputCheck, FoldersDevicesAndMissingFoldersAreRefused)
{
    EXPECT_THROW(checkWritable(folder_.string()), InputError);
    EXPECT_THROW(checkWritable("/dev/null"), InputError);
    EXPECT_THROW(checkWritable((folder_ / "no" / "a.png").string()), InputError);
    EXPECT_THROW(checkWritable((folder_ / std::string(300, 'a')).string()), InputError);
    EXPECT_THROW(checkWritable(""), InputError);
}

TEST_F(OutputCheck, NamesWithAByteOfZeroAreToldInOneLine)
{
    const std::string zero(1, '\0');
    const auto told = [](const std::string& path, const std::function<void(const std::string&)>& write) {
        try {
            write(path);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("written");
    };
    const Picture picture{1, 1, 3, {1, 2, 3}}, wrong{1, 1, 3, {}};
    const std::string begins = zero + "a.png", within = "a" + zero + ".png";
    const std::string expected = "'; expected a name without a byte of 0";
    for (const Picture& one : {picture, wrong}) {
        const auto write = [&](const std::string& path) { writePicture(one, path); };
        EXPECT_EQ(told(begins, write), "output file: found '\\x00a.png" + expected);
        EXPECT_EQ(told(within, write), "output file: found 'a\\x00.png" + expected);
    }
    EXPECT_EQ(told(within, [](const std::string& path) { writeTextFile(path, "text"); }),
              "output file: found 'a\\x00.png" + expected);
    EXPECT_EQ(told(within, checkWritable), "output file: found 'a\\x00.png" + expected);
}

TEST_F(OutputCheck, TextIsWrittenWholeAndReplacesTheOld)
{
    const std::string path = (folder_ / "stats.json").string();
    writeTextFile(path, "first, and longer");
    writeTextFile(path, "second");
    std::ifstream file(path);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "second");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

/// In a shared folder another user may have put links under the names that a process of this number would use.
TEST_F(OutputCheck, PreparedLinksAreNotFollowed)
{
    const std::string path = (folder_ / "stats.json").string();
    std::ofstream(folder_ / "victim") << "precious";
    const fs::path prepared = path + "." + std::to_string(getpid()) + ".tmp";
    fs::create_symlink(folder_ / "victim", prepared);
    for (const bool mayBeNameless : {false, true}) {
        writeTextFile(path, "text", mayBeNameless);
        std::ifstream victim(folder_ / "victim"), written(path);
        EXPECT_EQ(std::string(std::istreambuf_iterator<char>(victim), {}), "precious");
        EXPECT_EQ(std::string(std::istreambuf_iterator<char>(written), {}), "text");
        EXPECT_TRUE(fs::is_symlink(prepared)) << "somebody else's file";
        EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 3);
    }
}

TEST_F(OutputCheck, FailureLeavesNothingBehind)
{
    fs::create_directories(folder_ / "taken" / "by_a_folder");
    EXPECT_THROW(writeTextFile((folder_ / "taken").string(), "text"), std::runtime_error);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
    EXPECT_THROW(writeTextFile((folder_ / "no_folder" / "a.txt").string(), "text"), std::runtime_error);
}

TEST_F(OutputCheck, PermissionsAreThoseOfAnyNewFile)
{
    writeTextFile((folder_ / "written.txt").string(), "text");
    std::ofstream(folder_ / "plain.txt") << "text";
    EXPECT_EQ(fs::status(folder_ / "written.txt").permissions(), fs::status(folder_ / "plain.txt").permissions());
}

/// A child process writes more than it may, which the kernel answers with a signal: the end in the middle of a file.
TEST_F(OutputCheck, AProgramKilledWhileItWritesLeavesTheOldFileAlone)
{
    const std::string path = (folder_ / "a.png").string();
    writeTextFile(path, "precious");
    const int nameless = open(folder_.c_str(), O_TMPFILE | O_WRONLY, 0600);
    const bool canBeNameless = nameless >= 0;
    if (canBeNameless) close(nameless);
    const pid_t child = fork();
    if (child == 0) {
        const rlimit limit{1 << 16, 1 << 16};
        setrlimit(RLIMIT_FSIZE, &limit);
        const rlimit noCore{0, 0};
        setrlimit(RLIMIT_CORE, &noCore);
        std::signal(SIGXFSZ, SIG_DFL);
        writeTextFile(path, std::string(1 << 20, 'x'));
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    std::ifstream file(path);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "precious");
    if (canBeNameless) {
        EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
    }
}

}  // namespace
}  // namespace aeolic
