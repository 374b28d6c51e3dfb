#include "cli/address_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "aeolic/error.h"

namespace aeolic {
namespace {

namespace fs = std::filesystem;

class AddressFiles : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    static std::string content(const fs::path& path)
    {
        std::ifstream file(path);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), {}); }

    fs::path folder_ = fs::temp_directory_path() / ("aeolic_address_" + std::to_string(getpid()));
    std::string path_ = folder_ / "address";
};

TEST_F(AddressFiles, AreTheOwnersAloneWhateverTheMaskSays)
{
    const mode_t before = umask(0);
    const AddressFile file(path_, "http://x\n");
    umask(before);
    EXPECT_EQ(content(path_), "http://x\n");
    EXPECT_EQ(fs::status(path_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(files(), 1);
}

TEST_F(AddressFiles, TakeThePlaceOfWhatSomebodyHasPrepared)
{
    std::ofstream(folder_ / "victim") << "precious";
    fs::create_symlink(folder_ / "victim", path_);
    {
        const AddressFile file(path_, "secret");
        EXPECT_EQ(content(folder_ / "victim"), "precious");
        EXPECT_FALSE(fs::is_symlink(path_));
    }
    std::ofstream(path_) << "old";
    std::ifstream reader(path_);  // Who holds the old file open reads nothing of the new one.
    const AddressFile file(path_, "secret");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old");
    EXPECT_EQ(fs::status(path_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(AddressFiles, GoWithTheServerUnlessTheyAreAnothers)
{
    std::optional<AddressFile> first(std::in_place, path_, "first");
    const AddressFile second(path_, "second");
    first.reset();
    EXPECT_EQ(content(path_), "second");
    {
        const AddressFile third(folder_ / "third", "third");
    }
    EXPECT_EQ(files(), 1);
}

TEST_F(AddressFiles, FailureIsOneLineAndLeavesNothing)
{
    fs::create_directories(fs::path(path_) / "taken");
    EXPECT_THROW(AddressFile(path_, "x"), InputError);
    EXPECT_EQ(files(), 1);
    EXPECT_THROW(AddressFile(folder_ / "no" / "folder", "x"), InputError);
}

TEST_F(AddressFiles, HaveAPlaceInTheHome)
{
    const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
    setenv("HOME", folder_.c_str(), 1);
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(defaultAddressFile("http://node7:8080/?token=x"), (folder_ / ".aeolic/node7-8080").string());
    EXPECT_EQ(fs::status(folder_ / ".aeolic").permissions(), fs::perms::owner_all);
    for (const char* none : {"", "/no/such/home"}) {
        setenv("HOME", none, 1);
        EXPECT_THROW(defaultAddressFile("http://node7:8080/?token=x"), InputError);
    }
    setenv("HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace aeolic
