#include "data/reading/reader_process.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/reading/reader_words.h"
#include "data/vtk/file_reader.h"
#include "data/vtk/testing/sample_files.h"

namespace aeolic {
namespace {

/// Readers that are scripts, and do what a library may do to one.
class ReaderEnds : public testing::Test {
protected:
    ~ReaderEnds() override
    {
        unsetenv("AEOLIC_READER");
        unsetenv("AEOLIC_READER_SECONDS");
        unsetenv("AEOLIC_READER_WORDS");
    }

    /// What opening a file says when the reader does this.
    std::string saidWhere(const std::string& script)
    {
        const std::string program = folder_.file("reader");
        std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
        chmod(program.c_str(), 0700);
        setenv("AEOLIC_READER", program.c_str(), 1);
        try {
            FileReader("a.vtp", FileReader::Use::surface);
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    }

    static std::size_t openFiles()
    {
        std::size_t count = 0;
        for ([[maybe_unused]] const auto& file : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
        return count;
    }

    test::TempFolder folder_;
};

TEST_F(ReaderEnds, BySignalOrByItself)
{
    const std::size_t before = openFiles();
    EXPECT_EQ(
        saidWhere("kill -SEGV $$"),
        "a.vtp: the reader ended (SIGSEGV) while opening it; expected an undamaged file that its library can read");
    EXPECT_NE(saidWhere("kill -KILL $$").find("(SIGKILL)"), std::string::npos);
    EXPECT_NE(saidWhere("exit 3").find("(exit code 3)"), std::string::npos);
    EXPECT_EQ(openFiles(), before);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a process is left";
}

TEST_F(ReaderEnds, WhenItMakesNoProgress)
{
    setenv("AEOLIC_READER_SECONDS", "0.2", 1);
    EXPECT_NE(saidWhere("exec sleep 1000").find("the reader made no progress for 0.2 s while opening it"),
              std::string::npos);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a process is left";
}

/// What a library writes reaches nobody who did not ask for it, and is no more than fits.
TEST_F(ReaderEnds, WithWords)
{
    testing::internal::CaptureStderr();
    const std::string script = "yes 'a library complains' 2>&1 | head -c 1000000; echo its last words >&2; exit 1";
    EXPECT_EQ(saidWhere(script).find("complains"), std::string::npos);
    setenv("AEOLIC_READER_WORDS", "1", 1);
    EXPECT_NE(saidWhere("echo its last; echo words >&2; exit 1").find("and said: its last words"), std::string::npos);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(ReaderEnds, WithItsPlaceInTheWordsMovedFarAway)
{
    const std::string said = saidWhere("perl -e 'sysseek STDERR, 1 << 62, 0'; exit 3");
    EXPECT_NE(said.find("the reader ended (exit code 3)"), std::string::npos) << said;
}

/// Who asked for them gets them, once, and line by line.
TEST_F(ReaderEnds, WithWordsThatSomebodyHears)
{
    std::vector<std::string> heard;
    hearReaderWords([&](const std::string& path, const std::string& words) { heard.push_back(path + ": " + words); });
    saidWhere("echo it complains >&2; printf 'and stops' >&2; exit 1");
    EXPECT_EQ(heard, std::vector<std::string>{"a.vtp: it complains\nand stops\n"});
    heard.clear();
    saidWhere("exit 1");
    EXPECT_TRUE(heard.empty()) << "it said nothing";
    hearReaderWords([](const std::string&, const std::string&) { throw std::runtime_error("no room"); });
    EXPECT_NE(saidWhere("echo words >&2; exit 3").find("(exit code 3)"), std::string::npos);
    hearReaderWords({});
    saidWhere("echo words >&2; exit 1");
}

TEST_F(ReaderEnds, ProgramsThatAreNone)
{
    setenv("AEOLIC_READER", folder_.file("none").c_str(), 1);
    EXPECT_THROW(FileReader("a.vtp", FileReader::Use::surface), InputError);
}

}  // namespace
}  // namespace aeolic
