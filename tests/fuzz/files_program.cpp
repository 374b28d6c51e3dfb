/// What tests/fuzz/mutate_files.py drives: the real program's commands `info` and `render`, in a process of its own for
/// each file. Loading VTK takes far longer than a small file, so one process loads it once and then forks.
///   aeolic_files seeds FOLDER     writes small sound files of every format
///   aeolic_files run REPORT       reads lines of arguments from stdin, which tabs separate, and says how each ended
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/program.h"
#include "file_seeds.h"

namespace {

constexpr rlim_t cpuSeconds = 20;  // A reader that is busy for longer hangs.
constexpr int wallSeconds = 100;   // For one that waits for ever. The machine may be busy with other things.

void addCommands(CLI::App& program, const std::shared_ptr<aeolic::Communicator>& ranks)
{
    aeolic::addRenderCommand(program, ranks);
    aeolic::addInfoCommand(program, ranks);
}

std::vector<std::string> wordsOf(const std::string& line)
{
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; std::getline(stream, word, '\t');) words.push_back(word);
    return words;
}

[[noreturn]] void runChild(const std::vector<std::string>& words, const char* report)
{
    const int errors = open(report, O_WRONLY | O_CREAT | O_TRUNC, 0600), nothing = open("/dev/null", O_RDWR);
    dup2(nothing, 0);
    dup2(nothing, 1);
    dup2(errors, 2);
    const rlimit limit{cpuSeconds, cpuSeconds + 1}, noCore{0, 0};
    setrlimit(RLIMIT_CPU, &limit);
    setrlimit(RLIMIT_CORE, &noCore);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    std::string program = "aeolic";
    std::vector<char*> arguments{program.data()};
    std::vector<std::string> own = words;
    for (std::string& word : own) arguments.push_back(word.data());
    const int status = aeolic::runProgram({"aeolic", ""}, int(arguments.size()), arguments.data(), addCommands);
    std::fflush(nullptr);
    std::_Exit(status);  // Without the destructors of static objects: they are the same for every file.
}

/// "exit N" or "signal N", the lines on stderr, the most memory in MiB, and the first line.
std::string runOne(const std::vector<std::string>& words, const char* report)
{
    const pid_t child = fork();
    if (child == 0) runChild(words, report);
    sigset_t ended;
    sigemptyset(&ended);
    sigaddset(&ended, SIGCHLD);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(wallSeconds);
    int status = 0;
    rusage usage{};
    bool killed = false;
    while (wait4(child, &status, killed ? 0 : WNOHANG, &usage) == 0) {
        const timespec wait{1, 0};
        sigtimedwait(&ended, nullptr, &wait);
        if (std::chrono::steady_clock::now() < end) continue;
        kill(child, SIGKILL);
        killed = true;
    }
    std::string first, line;
    int lines = 0;
    std::ifstream said(report);
    while (std::getline(said, line))
        if (lines++ == 0) first = line.substr(0, 500);
    std::ostringstream result;
    if (WIFSIGNALED(status))
        result << "signal\t" << WTERMSIG(status);
    else
        result << "exit\t" << WEXITSTATUS(status);
    result << '\t' << lines << '\t' << usage.ru_maxrss / 1024 << '\t' << first;
    return result.str();
}

int serve(const char* report)
{
    sigset_t ended;
    sigemptyset(&ended);
    sigaddset(&ended, SIGCHLD);
    sigprocmask(SIG_BLOCK, &ended, nullptr);
    for (std::string line; std::getline(std::cin, line);) std::cout << runOne(wordsOf(line), report) << std::endl;
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc == 3 && std::strcmp(argv[1], "seeds") == 0) {
        aeolic::test::writeFileSeeds(argv[2]);
        return 0;
    }
    if (argc == 3 && std::strcmp(argv[1], "run") == 0) return serve(argv[2]);
    std::fprintf(stderr, "usage: aeolic_files seeds FOLDER | run REPORT\n");
    return 2;
}
