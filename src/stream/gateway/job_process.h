#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace aeolic::stream {

/// Splits a command such as "mpirun -n {ranks}" into words: at spaces, with quotes and backslashes as in a shell. Puts
/// the number in the place of {ranks}. Throws InputError for an open quote.
std::vector<std::string> launcherWords(const std::string& launcher, int ranks);

/// The render job as a process: a launcher with its ranks, or one rank by itself. It has a session of its own, so that
/// all of it can be ended: launchers give ranks process groups of their own. Not thread-safe.
class JobProcess {
public:
    /// Starts `words`, and gives it `input` on its standard input, which is then closed. Standard output and error go
    /// to this process's error whenever ended() is called, and no other file of this process is open in it. Throws
    /// InputError if the program cannot be started, std::runtime_error if the system has no room for one more process.
    JobProcess(const std::vector<std::string>& words, const std::string& input);
    /// Kills all its processes and does not wait: one that hangs in the kernel may take minutes to end. Processes that
    /// are not gone by then are reaped by reapLeftBehind(), which the next start calls, too.
    ~JobProcess();
    JobProcess(const JobProcess&) = delete;
    JobProcess& operator=(const JobProcess&) = delete;

    pid_t pid() const { return pid_; }
    /// How it ended, once it has: "ended with code 1", "was ended by signal 9 (Killed)".
    std::optional<std::string> ended();
    /// The end of what it wrote to standard output and error.
    const std::string& written() const { return written_; }
    /// Sends SIGTERM to the launcher's process group, which the launcher answers for its ranks; or SIGKILL to every
    /// process of the session on this host, stopped ones, too.
    void signal(int number);

    /// Takes leave of processes that were killed and have ended since. Never waits.
    static void reapLeftBehind();

private:
    void passOn();

    inline static std::vector<pid_t> leftBehind;  ///< Killed, and not reaped yet.
    pid_t pid_ = -1;
    int output_ = -1;  ///< The end of the pipe that is read.
    std::string written_;
    std::optional<std::string> ended_;
};

}  // namespace aeolic::stream
