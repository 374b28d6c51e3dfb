#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace aeolic::testkit {

/// How a command ended.
struct Ended {
    int exitCode = -1;  ///< 128 + the signal where one ended it.
    std::string out, err;
    double seconds = 0;                   ///< From the start.
    double secondsSinceComplaint = -1;    ///< From the first line of ours on standard error; negative: there is none.
    std::filesystem::file_time_type end;  ///< When that was.

    /// The lines on standard error that are ours; launchers add their own.
    std::vector<std::string> ours() const;
};

/// The built program under the launcher of the MPI it was built with, in a folder of its own.
class MpirunTest : public testing::Test {
protected:
    MpirunTest();
    ~MpirunTest() override;

    /// Runs `mpirun ARGUMENTS` through the shell in the test's folder.
    Ended mpirun(const std::string& arguments) const;

    /// Like mpirun(). Once `file` is there the launcher gets SIGTERM, and before that kMark is made.
    Ended mpirunUntil(const std::string& file, const std::string& arguments) const;

    /// A file in the folder, hidden: its age tells when a fault was made.
    static constexpr const char* kMark = ".fault";

    /// Words for such arguments: the programs, and a shell script (without single quotes) that one rank runs before the
    /// program, in the same process.
    static std::string aeolic() { return "'" AEOLIC_PROGRAM "' "; }
    static std::string bench() { return "'" AEOLIC_BENCH_PROGRAM "' "; }
    std::string inRank(int rank, const std::string& script) const;

    /// `mpirun -n RANKS aeolic render ARGUMENTS`.
    Ended render(int ranks, const std::string& arguments) const;

    /// One process, no launcher.
    Ended renderAlone(const std::string& arguments) const;

    std::string path(const std::string& file) const { return (folder_ / file).string(); }
    std::string bytes(const std::string& file) const;  ///< The file's content; empty where there is none.
    std::vector<std::string> files() const;            ///< In the folder, sorted.

    /// Processes whose command line names the test's folder, a second after the command has ended at the latest.
    std::vector<std::string> strays() const;

private:
    Ended run(const std::string& command) const;

    std::filesystem::path folder_;
};

}  // namespace aeolic::testkit
