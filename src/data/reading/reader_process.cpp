#include "data/reading/reader_process.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <thread>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/reading/reader_words.h"

extern char** environ;

namespace aeolic {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kLookAgainMs = 100;
constexpr int kTriesToReap = 200, kReapMs = 10;
constexpr off_t kMostWords = 64 << 10;   // Bytes of libraries' messages. No process is charged for memory files.
constexpr std::size_t kMostTold = 2000;  // Bytes of them that an error's message quotes.

/// The program that reads files of data. The environment variable AEOLIC_READER names it; else it is looked for beside
/// the library: in its folder, in libexec/aeolic there, and in libexec/aeolic of the folder that the library's was
/// installed in. Throws InputError where it is not there.
std::string readerProgram()
{
    namespace fs = std::filesystem;
    if (const char* named = std::getenv("AEOLIC_READER"); named && *named) {
        if (access(named, X_OK) != 0)
            throw InputError("AEOLIC_READER", std::string(named) + " is not a program", "the program aeolic-reader");
        return named;
    }
    Dl_info info{};
    std::error_code error;
    fs::path folder;
    if (dladdr(reinterpret_cast<const void*>(&readerProgram), &info) != 0 && info.dli_fname)
        folder = fs::canonical(info.dli_fname, error).parent_path();
    if (folder.empty())
        throw InputError("aeolic-reader", "not found: nobody knows where the library is", "AEOLIC_READER=PATH");
    for (const char* place : {"aeolic-reader", "libexec/aeolic/aeolic-reader", "../libexec/aeolic/aeolic-reader",
                              "../../libexec/aeolic/aeolic-reader"}) {
        std::string program = (folder / place).string();
        if (access(program.c_str(), X_OK) == 0) return program;
    }
    throw InputError("aeolic-reader", "not found in " + folder.string() + " or libexec/aeolic near it",
                     "the program that reads files, installed with the library, or AEOLIC_READER=PATH");
}

/// A file that cannot grow: bytes that do not fit are lost.
OwnedFile wordsFile()
{
    OwnedFile file(memfd_create("aeolic-words", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!file || ftruncate(file.get(), kMostWords) != 0 ||
        fcntl(file.get(), F_ADD_SEALS, F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) != 0)
        throw InputError("aeolic-reader", std::strerror(errno), "memory for what it says");
    return file;
}

/// Not one of the descriptors that the reader gets by number.
OwnedFile aboveNumbered(const OwnedFile& file)
{
    OwnedFile moved(fcntl(file.get(), F_DUPFD_CLOEXEC, 10));
    if (!moved) throw InputError("aeolic-reader", std::strerror(errno), "a file descriptor for it");
    return moved;
}

/// The reader's files are its own: its socket is 3, and its libraries write into `words`.
pid_t start(const std::string& program, int socket, int words)
{
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, words, 1);
    posix_spawn_file_actions_adddup2(&files, words, 2);
    posix_spawn_file_actions_adddup2(&files, socket, 3);
    posix_spawn_file_actions_addclosefrom_np(&files, 4);

    // Ctrl-C at a terminal goes to the caller alone, which ends the reader.
    posix_spawnattr_t how;
    posix_spawnattr_init(&how);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&how, &none);
    posix_spawnattr_setsigdefault(&how, &all);
    posix_spawnattr_setpgroup(&how, 0);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);

    std::string name = "aeolic-reader";
    std::array<char*, 2> arguments{name.data(), nullptr};
    pid_t pid = -1;
    const int error = posix_spawn(&pid, program.c_str(), &files, &how, arguments.data(), environ);
    posix_spawnattr_destroy(&how);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) throw InputError(program, std::strerror(error), "a program that can be started");
    return pid;
}

/// How many bytes the process has read so far; 0 where the system does not say it.
std::uint64_t bytesRead(pid_t pid)
{
    std::ifstream io("/proc/" + std::to_string(pid) + "/io");
    std::string key;
    std::uint64_t bytes = 0;
    return io >> key >> bytes && key == "rchar:" ? bytes : 0;
}

}  // namespace

void failNonsense(const std::string& path)
{
    throw InputError(path, "the reader's answer makes no sense", "an undamaged file");
}

double readerPatience()
{
    const char* text = std::getenv("AEOLIC_READER_SECONDS");
    const double seconds = text ? std::atof(text) : 0;
    return seconds > 0 ? seconds : 60;
}

ReaderProcess::ReaderProcess() : owner_(getpid())
{
    const std::string program = readerProgram();
    std::array<int, 2> pair{};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pair.data()) != 0)
        throw InputError("aeolic-reader", std::strerror(errno), "a connection to it");
    const OwnedFile first(pair[0]), second(pair[1]);
    words_ = aboveNumbered(wordsFile());
    socket_ = PacketSocket(aboveNumbered(first));
    const OwnedFile theirs = aboveNumbered(second);
    pid_ = start(program, theirs.get(), words_.get());
}

ReaderProcess::~ReaderProcess()
{
    end();
}

void ReaderProcess::end() noexcept
{
    ready_ = false;
    socket_ = PacketSocket();
    if (pid_ < 0 || getpid() != owner_) return;
    kill(pid_, SIGKILL);  // It has nothing to finish.
    // One that waits for a disk or a network ends when they answer. Nobody waits for that.
    for (int tries = 0; tries < kTriesToReap && waitpid(pid_, nullptr, WNOHANG) == 0; ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(tries < 20 ? 1 : kReapMs));
    pid_ = -1;
}

bool ReaderProcess::ready(int waitMs) noexcept
{
    if (!ready_ || getpid() != owner_) return false;
    try {
        if (closing_) {
            const auto closed = socket_.receive(waitMs);
            if (!closed || closed->kind != PacketKind::answer) return false;
            closing_ = false;
        }
        pollfd look{socket_.descriptor(), 0, 0};
        return poll(&look, 1, 0) == 0;
    } catch (const std::exception&) {
        return ready_ = false;
    }
}

void ReaderProcess::close() noexcept
{
    if (getpid() != owner_ || !ready_) return;  // The reader may be that of the process that fork() copied.
    try {
        socket_.send(PacketKind::close);
        closing_ = true;
    } catch (const std::exception&) {
        ready_ = false;
    }
}

ReaderProcess::Answer ReaderProcess::ask(PacketKind kind, std::span<const std::byte> request, const Subject& subject,
                                         const ProgressReport& progress)
{
    ready_ = false;
    // The reader writes there, too, and a new one may have said something already.
    if (kind == PacketKind::open && toldWords_ > 0) toldWords_ = lseek(words_.get(), 0, SEEK_SET);
    const struct AtTheEnd {  // However it ends.
        ReaderProcess& reader;
        const Subject& subject;
        ~AtTheEnd() { reader.tellWords(subject); }
    } atTheEnd{*this, subject};
    Answer answer;
    double fraction = 0;
    const auto patience = std::chrono::duration<double>(readerPatience());
    Clock::time_point last = Clock::now();
    std::uint64_t read = 0;
    try {
        socket_.send(kind, request);
        for (;;) {
            std::optional<Packet> packet = socket_.receive(kLookAgainMs);
            if (!packet) {
                progress(subject.what, fraction);
                if (const std::uint64_t now = bytesRead(pid_); now != read) {
                    read = now;
                    last = Clock::now();
                }
                if (Clock::now() - last > patience) failSilent(subject);
                continue;
            }
            last = Clock::now();
            switch (packet->kind) {
                case PacketKind::progress:
                    if (packet->bytes.size() != sizeof fraction) throw LostPeer();
                    std::memcpy(&fraction, packet->bytes.data(), sizeof fraction);
                    progress(subject.what, fraction);
                    break;
                case PacketKind::memory:
                    for (const OwnedFile& file : packet->files)
                        answer.memory.push_back(std::make_shared<SharedMemory>(file));
                    break;
                case PacketKind::answer:
                    answer.text = std::move(packet->bytes);
                    ready_ = true;
                    return answer;
                case PacketKind::refusal:
                    ready_ = true;
                    throw InputError(std::string(reinterpret_cast<const char*>(packet->bytes.data()),  //
                                                 packet->bytes.size()));
                default:
                    throw LostPeer();
            }
        }
    } catch (const InputError&) {
        throw;
    } catch (const LostPeer&) {
        failEnded(subject);
    } catch (const TooLong& error) {
        end();
        throw InputError(subject.path, fmt::format("there is {} while {}", error.what(), subject.what),
                         "a file of fewer parts and arrays");
    } catch (const std::system_error& error) {
        end();
        throw InputError(subject.path, fmt::format("its reader cannot be spoken to ({})", error.what()),
                         "free memory and file descriptors");
    } catch (const std::bad_alloc&) {
        end();
        throw InputError(subject.path, "there is not enough memory for what was read",
                         "a smaller file or a larger machine");
    }
}

/// "SIGSEGV", or what else there is to say of its end.
std::string ReaderProcess::endedHow()
{
    int status = 0;
    pid_t ended = 0;
    for (int tries = 0; tries < kTriesToReap && ended == 0; ++tries) {  // Its socket is closed; it is about to be gone.
        ended = waitpid(pid_, &status, WNOHANG);
        if (ended == 0) std::this_thread::sleep_for(std::chrono::milliseconds(kReapMs));
    }
    if (ended < 0) pid_ = -1;  // Somebody else has reaped it, and its number may be another process's by now.
    if (ended != pid_ || pid_ < 0) return ended == 0 ? "it answered nonsense" : "nobody knows how";
    pid_ = -1;
    if (WIFSIGNALED(status)) {
        const char* name = sigabbrev_np(WTERMSIG(status));
        return name ? "SIG" + std::string(name) : fmt::format("signal {}", WTERMSIG(status));
    }
    return fmt::format("exit code {}", WEXITSTATUS(status));
}

/// What the reader's libraries have said, from byte `from` on. They can move the end to anywhere, as it is the file's
/// place to write.
std::string ReaderProcess::words(long from) const
{
    const off_t end = std::min(lseek(words_.get(), 0, SEEK_CUR), kMostWords);
    std::string text(std::size_t(std::max<off_t>(end - from, 0)), '\0');
    const ssize_t count = pread(words_.get(), text.data(), text.size(), from);
    text.resize(std::size_t(std::max<ssize_t>(count, 0)));
    return text;
}

void ReaderProcess::tellWords(const Subject& subject) noexcept
{
    const std::string text = words(toldWords_);
    toldWords_ += long(text.size());
    tellReaderWords(subject.path, text);
}

void ReaderProcess::failEnded(const Subject& subject)
{
    const std::string how = endedHow();
    std::string said = words(0);
    said.erase(0, said.size() - std::min(said.size(), kMostTold));
    end();
    std::string found = fmt::format("the reader ended ({}) while {}", how, subject.what);
    if (std::getenv("AEOLIC_READER_WORDS") && !said.empty()) found += ", and said: " + withSpaces(said);
    throw InputError(subject.path, found, "an undamaged file that its library can read");
}

void ReaderProcess::failSilent(const Subject& subject)
{
    end();
    throw InputError(subject.path,
                     fmt::format("the reader made no progress for {:g} s while {}", readerPatience(), subject.what),
                     "an undamaged file; AEOLIC_READER_SECONDS says how long to wait");
}

}  // namespace aeolic
