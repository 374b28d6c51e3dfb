#include "mpirun_testing.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <future>
#include <iterator>
#include <optional>
#include <sstream>
#include <thread>

namespace aeolic::testkit {
namespace {

namespace fs = std::filesystem;

std::string fileText(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// OpenMPI 4 and 5 are allowed more ranks than cores, and to run as root in a container. MPI does not free all memory.
void allowLaunching()
{
    for (const char* variable :
         {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "OMPI_MCA_rmaps_base_oversubscribe"})
        setenv(variable, "1", 1);
    setenv("PRTE_MCA_rmaps_default_mapping_policy", ":oversubscribe", 1);
    setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
}

// sh .in_rank RANK SCRIPT PROGRAM …
constexpr const char* kInRank =
    "rank=$1 script=$2\n"
    "shift 2\n"
    "[ \"${OMPI_COMM_WORLD_RANK:-$PMI_RANK}\" = \"$rank\" ] && eval \"$script\"\n"
    "exec \"$@\"\n";

}  // namespace

std::vector<std::string> Ended::ours() const
{
    std::vector<std::string> lines;
    std::istringstream text(err);
    for (std::string line; std::getline(text, line);)
        if (line.starts_with("aeolic: ")) lines.push_back(line);
    return lines;
}

MpirunTest::MpirunTest() : folder_(fs::temp_directory_path() / ("aeolic_mpirun_" + std::to_string(getpid())))
{
    allowLaunching();
    fs::create_directories(folder_);
}

MpirunTest::~MpirunTest()
{
    fs::remove_all(folder_);
}

Ended MpirunTest::run(const std::string& command) const
{
    const fs::path out = folder_ / ".out", err = folder_ / ".err", script = folder_ / ".in_rank";
    std::ofstream(script) << kInRank;
    using Clock = std::chrono::steady_clock;
    const auto since = [](Clock::time_point then) {
        return std::chrono::duration<double>(Clock::now() - then).count();
    };
    const std::string whole = "cd '" + folder_.string() + "' && timeout 60 " + command + " >.out 2>.err </dev/null";
    const auto start = Clock::now();
    std::optional<Clock::time_point> complained;
    auto running = std::async(std::launch::async, [&] { return std::system(whole.c_str()); });
    while (running.wait_for(std::chrono::milliseconds(10)) != std::future_status::ready)
        if (!complained && fileText(err).find("aeolic: ") != std::string::npos) complained = Clock::now();
    const int status = running.get();
    Ended ended;
    ended.seconds = since(start);
    if (complained) ended.secondsSinceComplaint = since(*complained);
    ended.end = fs::file_time_type::clock::now();
    ended.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ended.out = fileText(out);
    ended.err = fileText(err);
    for (const fs::path& mine : {out, err, script}) fs::remove(mine);
    return ended;
}

Ended MpirunTest::mpirun(const std::string& arguments) const
{
    return run("'" AEOLIC_MPIEXEC "' " + arguments);
}

Ended MpirunTest::mpirunUntil(const std::string& file, const std::string& arguments) const
{
    const fs::path script = folder_ / ".until";
    std::ofstream(script) << "'" AEOLIC_MPIEXEC "' " << arguments << " &\nwhile [ ! -e '" << path(file)
                          << "' ]; do sleep 0.02; done\ntouch " << kMark << "\nkill -TERM $!\nwait $!\n";
    const Ended ended = run("sh .until");
    fs::remove(script);
    return ended;
}

std::string MpirunTest::inRank(int rank, const std::string& script) const
{
    return "sh '" + path(".in_rank") + "' " + std::to_string(rank) + " '" + script + "' ";
}

Ended MpirunTest::render(int ranks, const std::string& arguments) const
{
    return mpirun("-n " + std::to_string(ranks) + " " + aeolic() + "render " + arguments);
}

Ended MpirunTest::renderAlone(const std::string& arguments) const
{
    return run(aeolic() + "render " + arguments);
}

std::string MpirunTest::bytes(const std::string& file) const
{
    return fileText(folder_ / file);
}

std::vector<std::string> MpirunTest::files() const
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> MpirunTest::strays() const
{
    std::vector<std::string> found;
    for (int attempt = 0; attempt < 20; ++attempt) {
        found.clear();
        for (const auto& entry : fs::directory_iterator("/proc")) {
            std::string line = fileText(entry.path() / "cmdline");
            std::replace(line.begin(), line.end(), '\0', ' ');
            if (line.find(folder_.string()) != std::string::npos) found.push_back(line);
        }
        if (found.empty()) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return found;
}

}  // namespace aeolic::testkit
