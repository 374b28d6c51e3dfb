#include "stream/gateway/job_process.h"

#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "aeolic/error.h"

extern char** environ;

namespace aeolic::stream {

namespace {

/// The processes of this host that belong to a session. No other session gets its number while one of them is left.
std::vector<pid_t> processesOfSession(pid_t session)
{
    std::vector<pid_t> found;
    std::error_code error;
    std::filesystem::directory_iterator entry("/proc", error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename();
        if (name.find_first_not_of("0123456789") != name.npos) continue;
        const pid_t pid = std::stoi(name);
        if (getsid(pid) == session) found.push_back(pid);
    }
    return found;
}

}  // namespace

std::vector<std::string> launcherWords(const std::string& launcher, int ranks)
{
    std::vector<std::string> words;
    std::string word;
    bool inWord = false;
    char quote = 0;
    for (std::size_t i = 0; i < launcher.size(); ++i) {
        const char c = launcher[i];
        if (quote ? c == quote : c == '\'' || c == '"') {
            quote = quote ? 0 : c;
            inWord = true;
        } else if (c == '\\' && quote != '\'' && i + 1 < launcher.size()) {
            word += launcher[++i];
            inWord = true;
        } else if (!quote && (c == ' ' || c == '\t' || c == '\n')) {
            if (inWord) words.push_back(std::exchange(word, {}));
            inWord = false;
        } else {
            word += c;
            inWord = true;
        }
    }
    if (quote) throw InputError("--launcher", std::string("an open ") + quote, "a command line");
    if (inWord) words.push_back(word);
    if (words.empty()) throw InputError("--launcher", "nothing", "a command line such as 'mpirun -n {ranks}'");
    const std::string mark = "{ranks}";
    for (std::string& w : words)
        for (std::size_t at = w.find(mark); at != w.npos; at = w.find(mark))
            w.replace(at, mark.size(), std::to_string(ranks));
    return words;
}

JobProcess::JobProcess(const std::vector<std::string>& words, const std::string& input)
{
    reapLeftBehind();
    int ends[2], output[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
    if (pipe2(output, O_CLOEXEC) != 0) {
        const int error = errno;
        ::close(ends[0]);
        ::close(ends[1]);
        throw std::runtime_error(std::string("pipe: ") + std::strerror(error));
    }
    fcntl(output[0], F_SETFL, O_NONBLOCK);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output[1], STDERR_FILENO);
    // Some libraries open sockets that a new process inherits. A rank that holds one would keep it open for the peer.
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    sigset_t none, ours;
    sigemptyset(&none);
    sigemptyset(&ours);
    for (const int number : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGCHLD, SIGXFSZ}) sigaddset(&ours, number);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &ours);
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int error = posix_spawnp(&pid_, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (error == 0) {
        // The input is far smaller than what a pipe holds, so this never waits. While this process holds the end for
        // reading, writing raises no SIGPIPE even if the new process has ended already.
        const ssize_t written = ::write(ends[1], input.data(), input.size());
        if (written != ssize_t(input.size())) signal(SIGKILL);
    }
    ::close(ends[0]);
    ::close(ends[1]);
    ::close(output[1]);
    output_ = output[0];
    if (error != 0) {
        pid_ = -1;
        ::close(output_);
        if (error == EAGAIN || error == ENOMEM || error == EMFILE || error == ENFILE)
            throw std::runtime_error(std::string("the renderer cannot be started: ") + std::strerror(error));
        throw InputError("--launcher", "'" + words[0] + "' cannot be started (" + std::strerror(error) + ")",
                         "a program that starts the ranks");
    }
}

JobProcess::~JobProcess()
{
    if (pid_ < 0) return;
    signal(SIGKILL);
    passOn();
    ::close(output_);
    if (!ended_ && waitpid(pid_, nullptr, WNOHANG) == 0) leftBehind.push_back(pid_);
}

void JobProcess::reapLeftBehind()
{
    std::erase_if(leftBehind, [](pid_t pid) { return waitpid(pid, nullptr, WNOHANG) != 0; });
}

std::optional<std::string> JobProcess::ended()
{
    passOn();
    if (ended_) return ended_;
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
    passOn();  // What it wrote between the two.
    if (WIFSIGNALED(status))
        ended_ = "was ended by signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
    else
        ended_ = "ended with code " + std::to_string(WEXITSTATUS(status));
    return ended_;
}

/// Passes on what it has written since the last time, and keeps the end of it. Never waits: where nobody reads this
/// process's error, the words are lost there.
void JobProcess::passOn()
{
    constexpr std::size_t kept = 4096;
    char bytes[PIPE_BUF];            // So many are written at once, or none.
    for (int i = 0; i < 256; ++i) {  // A job that never stops writing must not hold up the server.
        const ssize_t count = ::read(output_, bytes, sizeof bytes);
        if (count <= 0) return;
        pollfd error{STDERR_FILENO, POLLOUT, 0};
        if (::poll(&error, 1, 0) == 1 && (error.revents & (POLLOUT | POLLERR)) == POLLOUT &&
            ::write(STDERR_FILENO, bytes, std::size_t(count)) < 0)
            errno = 0;  // There is nobody to tell.
        written_.append(bytes, std::size_t(count));
        if (written_.size() > kept) written_.erase(0, written_.size() - kept);
    }
}

void JobProcess::signal(int number)
{
    if (pid_ <= 0) return;
    ::kill(-pid_, number);
    if (number != SIGKILL) return;
    for (const pid_t pid : processesOfSession(pid_)) ::kill(pid, SIGKILL);
}

}  // namespace aeolic::stream
