#include "data/output_check.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "aeolic/error.h"

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

TEST_F(OutputCheck, TextIsWrittenWholeAndReplacesTheOld)
{
    const std::string path = (folder_ / "stats.json").string();
    writeTextFile(path, "first, and longer");
    writeTextFile(path, "second");
    std::ifstream file(path);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "second");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(OutputCheck, FailureLeavesNothingBehind)
{
    fs::create_directories(folder_ / "taken" / "by_a_folder");
    EXPECT_THROW(writeTextFile((folder_ / "taken").string(), "text"), std::runtime_error);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

}  // namespace
}  // namespace aeolic
