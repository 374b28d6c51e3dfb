#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "aeolic/error.h"
#include "base/text.h"
#include "output/animation.h"
#include "output/new_file.h"

extern char** environ;

namespace aeolic {
namespace {

std::string ffmpegPath()
{
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::string program = (folder.empty() ? "." : folder) + "/ffmpeg";
        if (access(program.c_str(), X_OK) == 0) return program;
    }
    return "";
}

/// A child process that gets pixels by a socket, which it reads as standard input, and the file it writes as
/// kFileThere. What it complains of is kept.
class Ffmpeg {
public:
    static constexpr int kFileThere = 3;

    Ffmpeg(std::vector<std::string> words, int file)
    {
        std::array<int, 2> ends{};
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail("socketpair");
        input_ = ends[0];
        complaints_ = memfd_create("ffmpeg", MFD_CLOEXEC);
        if (complaints_ < 0) fail("memfd_create");
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions, complaints_, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, complaints_, STDERR_FILENO);
        posix_spawn_file_actions_adddup2(&actions, file, kFileThere);
        std::vector<char*> arguments;
        arguments.reserve(words.size() + 1);
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        const int error = posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        close(ends[1]);
        if (error != 0) {
            process_ = 0;
            errno = error;
            fail(words[0]);
        }
    }
    ~Ffmpeg()
    {
        if (input_ >= 0) close(input_);
        if (process_ > 0) {  // It must not finish a file that is not whole.
            kill(process_, SIGKILL);
            waitpid(process_, nullptr, 0);
        }
        if (complaints_ >= 0) close(complaints_);
    }
    Ffmpeg(const Ffmpeg&) = delete;
    Ffmpeg& operator=(const Ffmpeg&) = delete;

    /// False where it no longer reads.
    bool write(const std::vector<std::uint8_t>& pixels) const
    {
        for (std::size_t at = 0; at < pixels.size();) {
            const ssize_t sent = send(input_, pixels.data() + at, pixels.size() - at, MSG_NOSIGNAL);
            if (sent < 0 && errno == EINTR) continue;
            if (sent < 0) return false;
            at += std::size_t(sent);
        }
        return true;
    }

    /// Ends its input and waits for it. Whether it succeeded.
    bool finish()
    {
        if (process_ == 0) return false;  // It has ended before.
        close(std::exchange(input_, -1));
        int status = 0;
        pid_t ended = 0;
        do ended = waitpid(process_, &status, 0);
        while (ended < 0 && errno == EINTR);
        process_ = 0;
        return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }

    /// The first line that it wrote.
    std::string complaint() const
    {
        std::array<char, 300> text{};
        const ssize_t bytes = pread(complaints_, text.data(), text.size(), 0);
        std::string line(text.data(), std::size_t(std::max<ssize_t>(bytes, 0)));
        line = withoutControls(line.substr(0, line.find('\n')));
        return line.empty() ? "it said nothing" : line;
    }

private:
    [[noreturn]] static void fail(const std::string& what)
    {
        throw std::runtime_error(what + ": " + std::strerror(errno));
    }

    pid_t process_ = 0;
    int input_ = -1, complaints_ = -1;
};

class Video : public Animation {
public:
    explicit Video(const AnimationPlan& plan) : plan_(plan), file_(plan.path), program_(ffmpegPath())
    {
        if (program_.empty())
            throw InputError("-o", "found a .mp4, and no ffmpeg in PATH", "an installed ffmpeg, or .webp or .apng");
    }
    void add(const Picture& picture) override
    {
        requireSound(picture, plan_.path);
        if (!ffmpeg_) start(picture);
        if (!ffmpeg_->write(picture.pixels)) fail();
    }

    void complete() override
    {
        if (!ffmpeg_ || !ffmpeg_->finish()) fail();
        file_.complete();
    }

private:
    void start(const Picture& picture)
    {
        // Players want even sides, and half the resolution in colour. A file name is never an option: it has a
        // protocol.
        const std::string options = fmt::format(
            "-nostdin -hide_banner -loglevel error -y -f rawvideo -pix_fmt {} -s {}x{} -r {} -i pipe:0 -an "
            "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2:color=0x{} -pix_fmt yuv420p -crf 16 -q:v 2 -movflags +faststart -f mp4",
            picture.channels == 4 ? "rgba" : "rgb24", picture.width, picture.height, plan_.framesPerSecond,
            plan_.background);
        std::vector<std::string> words{program_};
        for (const std::string_view word : splitText(options, ' ')) words.emplace_back(word);
        words.push_back("file:" + file_.nameFor(Ffmpeg::kFileThere));
        ffmpeg_ = std::make_unique<Ffmpeg>(std::move(words), file_.descriptor());
    }
    [[noreturn]] void fail()
    {
        if (ffmpeg_) ffmpeg_->finish();
        throw std::runtime_error(plan_.path + ": ffmpeg failed: " + (ffmpeg_ ? ffmpeg_->complaint() : "no picture"));
    }

    AnimationPlan plan_;
    NewFile file_;
    std::string program_;
    std::unique_ptr<Ffmpeg> ffmpeg_;  // Ends before its file does.
};

}  // namespace

bool hasFfmpeg()
{
    return !ffmpegPath().empty();
}

std::unique_ptr<Animation> makeVideo(const AnimationPlan& plan)
{
    return std::make_unique<Video>(plan);
}

}  // namespace aeolic
