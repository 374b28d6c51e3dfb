/// What tests/fuzz/mutate_files.py drives: the real program's commands `info` and `render`. Loading VTK and binding its
/// symbols takes far longer than a small file, so one process does many files, one after the other. When it dies, the
/// next file gets a new one.
///   aeolic_files seeds FOLDER     writes small sound files of every format
///   aeolic_files run REPORT       reads lines of arguments from stdin, which tabs separate, and says how each ended.
///   The
///                                 line "new" ends the process, so that the next file is the first one of its process.
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/program.h"
#include "data/reading/reader_pool.h"
#include "file_seeds.h"

namespace {

constexpr rlim_t cpuSeconds = 20;  // A reader that is busy for longer hangs.
constexpr int wallSeconds = 100;   // For one that waits for ever. The machine may be busy with other things.
constexpr int filesOfAProcess = 200;

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

/// The most memory of this process so far, in MiB. A file that needs too much is the last one of its process.
long mostMemory()
{
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return used.ru_maxrss / 1024;
}

/// Beyond so much more time of the processors the process is ended by SIGXCPU.
void limitTime()
{
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const rlimit limit{rlim_t(used.ru_utime.tv_sec + used.ru_stime.tv_sec) + 1 + cpuSeconds, RLIM_INFINITY};
    setrlimit(RLIMIT_CPU, &limit);
}

/// The program's own exit status. What it says on stderr goes to the file `report`.
int runProgramOnce(const std::vector<std::string>& words, const char* report)
{
    const int errors = open(report, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(errors, 2);
    close(errors);
    std::string program = "aeolic";
    std::vector<char*> arguments{program.data()};
    std::vector<std::string> own = words;
    for (std::string& word : own) arguments.push_back(word.data());
    limitTime();
    const int status = aeolic::runProgram({"aeolic", ""}, int(arguments.size()), arguments.data(), addCommands);
    std::fflush(nullptr);
    return status;
}

[[noreturn]] void runChild(int lines, int answers, const char* report)
{
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, 0);
    dup2(nothing, 1);
    const rlimit noCore{0, 0};
    setrlimit(RLIMIT_CORE, &noCore);
    const aeolic::KeptReaders kept;  // Of one file to the next, as a server's. To start one takes longer than a file.
    FILE* in = fdopen(lines, "r");
    char* line = nullptr;
    std::size_t room = 0;
    for (ssize_t length; (length = getline(&line, &room, in)) > 0;) {
        const int status = runProgramOnce(wordsOf({line, std::size_t(length) - 1}), report);
        const std::string answer = std::to_string(status) + '\t' + std::to_string(mostMemory()) + '\n';
        if (write(answers, answer.data(), answer.size()) != ssize_t(answer.size())) break;
    }
    std::_Exit(0);  // Without the destructors of static objects: they are the same for every file.
}

/// A process that does one file after the other, until it dies.
class Child {
public:
    explicit Child(const char* report)
    {
        int lines[2], answers[2];
        if (pipe2(lines, O_CLOEXEC) != 0 || pipe2(answers, O_CLOEXEC) != 0) std::abort();
        process_ = fork();
        if (process_ == 0) {
            close(lines[1]);
            close(answers[0]);
            runChild(lines[0], answers[1], report);
        }
        close(lines[0]);
        close(answers[1]);
        lines_ = lines[1];
        answers_ = answers[0];
    }
    ~Child() { end(); }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    int files() const { return files_; }

    /// "exit N MiB" of one file, or "signal N 0". After a signal the child is gone.
    std::string answerTo(const std::string& line)
    {
        ++files_;
        const std::string whole = line + '\n';
        std::string answer;
        if (write(lines_, whole.data(), whole.size()) == ssize_t(whole.size())) answer = nextLine();
        if (!answer.empty()) return "exit\t" + answer;
        kill(process_, SIGKILL);
        const int status = end();
        return WIFSIGNALED(status) ? "signal\t" + std::to_string(WTERMSIG(status)) + "\t0"
                                   : "exit\t" + std::to_string(WEXITSTATUS(status)) + "\t0";
    }
    bool lives() const { return process_ > 0; }

private:
    std::string nextLine()
    {
        std::string answer;
        for (pollfd ready{answers_, POLLIN, 0}; poll(&ready, 1, wallSeconds * 1000) > 0;) {
            char c = 0;
            if (read(answers_, &c, 1) != 1) return {};
            if (c == '\n') return answer;
            answer += c;
        }
        return {};
    }

    int end()
    {
        int status = 0;
        if (process_ <= 0) return status;
        close(lines_);
        close(answers_);
        waitpid(process_, &status, 0);
        process_ = 0;
        return status;
    }

    pid_t process_ = 0;
    int lines_ = -1, answers_ = -1, files_ = 0;
};

/// "exit N" or "signal N", the lines on stderr, the most memory in MiB, how many files the process had done before, and
/// the first line.
std::string verdictOn(const std::string& line, Child& child, const char* report)
{
    const int before = child.files();
    std::istringstream answer(child.answerTo(line));
    std::string how, number, mib, first;
    std::getline(answer, how, '\t');
    std::getline(answer, number, '\t');
    std::getline(answer, mib);
    int lines = 0;
    std::ifstream said(report);
    for (std::string next; std::getline(said, next);)
        if (lines++ == 0) first = next.substr(0, 500);
    std::ostringstream result;
    result << how << '\t' << number << '\t' << lines << '\t' << mib << '\t' << before << '\t' << first;
    return result.str();
}

int serve(const char* report)
{
    std::signal(SIGPIPE, SIG_IGN);
    std::unique_ptr<Child> child;
    for (std::string line; std::getline(std::cin, line);) {
        if (!child || !child->lives() || child->files() >= filesOfAProcess || line == "new") {
            child.reset();  // First, because the new one would keep its pipes open.
            child = std::make_unique<Child>(report);
        }
        if (line != "new") std::cout << verdictOn(line, *child, report) << std::endl;
    }
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
