#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "test_paths.h"

/// The built program, from outside.
namespace aeolic::cli_testing {

namespace fs = std::filesystem;

inline std::string fileText(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Outcome {
    int exitCode = -1;
    std::string out, err;

    bool oneLineError() const
    {
        return err.starts_with("aeolic: ") && err.ends_with('\n') && std::count(err.begin(), err.end(), '\n') == 1;
    }
};

class Cli : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    /// Runs `ENVIRONMENT aeolic ARGUMENTS` through the shell in the test's own folder.
    Outcome aeolic(const std::string& arguments, const std::string& environment = "") const
    {
        const fs::path out = folder_ / ".out", err = folder_ / ".err";
        const std::string command = "cd '" + folder_.string() + "' && " + environment + " '" AEOLIC_PROGRAM "' " +
                                    arguments + " >.out 2>.err </dev/null";
        const int status = std::system(command.c_str());
        Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, fileText(out), fileText(err)};
        fs::remove(out);
        fs::remove(err);
        return outcome;
    }

    /// A small scene, quick to draw.
    Outcome render(const std::string& arguments, const std::string& environment = "") const
    {
        return aeolic("render --surface teapot:2000 --field uniform:8,8,8 --size 64x48 --steps 8 " + arguments,
                      environment);
    }

    std::size_t filesLeft() const { return std::size_t(std::distance(fs::directory_iterator(folder_), {})); }

    fs::path folder_ = fs::temp_directory_path() / ("aeolic_cli_" + std::to_string(getpid()));
};

}  // namespace aeolic::cli_testing
