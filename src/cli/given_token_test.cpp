#include "cli/given_token.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "aeolic/error.h"
#include "stream/token.h"

namespace aeolic {
namespace {

namespace fs = std::filesystem;

const std::string kGood = "sixteen.Letters_-1";

TEST(GivenToken, IsLongAndPlainOrIsRefusedWithoutBeingTold)
{
    EXPECT_NO_THROW(stream::checkToken("--token", kGood));
    EXPECT_NO_THROW(stream::checkToken("--token", std::string(16, 'x')));
    EXPECT_NO_THROW(stream::checkToken("--token", std::string(256, 'x')));
    for (const std::string& wrong :
         {std::string(), std::string("none"), std::string(15, 'x'), std::string(257, 'x'), "a b" + kGood, kGood + "&",
          kGood + "\n", kGood + "\xc3\xa9", kGood + std::string(1, '\0')}) {
        try {
            stream::checkToken("--token", wrong);
            FAIL() << wrong;
        } catch (const InputError& error) {
            const std::string line = error.what();
            EXPECT_TRUE(line.starts_with("--token: ")) << line;
            EXPECT_EQ(line.find('\n'), line.npos);
            EXPECT_EQ(line.find(kGood), line.npos);
        }
    }
}

class TokenFile : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    std::string file(const std::string& content, mode_t mode = 0600)
    {
        const std::string path = folder_ / "token";
        fs::remove(path);
        std::ofstream(path) << content;
        chmod(path.c_str(), mode);
        return path;
    }
    fs::path folder_ = fs::temp_directory_path() / ("aeolic_token_" + std::to_string(getpid()));
};

TEST_F(TokenFile, HoldsOneLine)
{
    EXPECT_EQ(tokenFromFile(file(kGood)), kGood);
    EXPECT_EQ(tokenFromFile(file(kGood + "\n")), kGood);
    EXPECT_EQ(tokenFromFile(file(kGood + "\r\n", 0400)), kGood);
    for (const std::string& wrong : {std::string(), std::string("short\n"), kGood + "\n" + kGood, "\n" + kGood,
                                     kGood + "\n\n", std::string(100000, 'x')})
        EXPECT_THROW(tokenFromFile(file(wrong)), InputError) << wrong.substr(0, 40);
}

TEST_F(TokenFile, IsItsOwnersAlone)
{
    for (const mode_t mode : {0640, 0604, 0644, 0660})
        EXPECT_THROW(tokenFromFile(file(kGood, mode)), InputError) << mode;
}

TEST_F(TokenFile, IsAFile)
{
    EXPECT_THROW(tokenFromFile(folder_ / "nothing"), InputError);
    EXPECT_THROW(tokenFromFile(folder_), InputError);
    EXPECT_THROW(tokenFromFile("/dev/null"), InputError);
    EXPECT_THROW(tokenFromFile("/dev/zero"), InputError) << "it never ends";
    EXPECT_THROW(tokenFromFile(""), InputError);
}

TEST(TokenVariable, IsReadOnce)
{
    setenv("AEOLIC_TOKEN", kGood.c_str(), 1);
    const char* memory = std::getenv("AEOLIC_TOKEN");
    EXPECT_EQ(tokenFromEnvironment(), kGood);
    EXPECT_EQ(std::getenv("AEOLIC_TOKEN"), nullptr) << "programs that are started get it no more";
    EXPECT_EQ(*memory, '\0');
    EXPECT_EQ(tokenFromEnvironment(), "");
    setenv("AEOLIC_TOKEN", "short", 1);
    EXPECT_THROW(tokenFromEnvironment(), InputError);
    EXPECT_EQ(std::getenv("AEOLIC_TOKEN"), nullptr);
}

}  // namespace
}  // namespace aeolic
