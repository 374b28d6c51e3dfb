#pragma once

#include <sys/types.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/byte_message.h"
#include "data/progress.h"
#include "data/reading/packet_socket.h"
#include "data/reading/shared_memory.h"

namespace aeolic {

/// A process that reads files of data for this one, so that a fault of a library, or a file made to provoke one, ends
/// that process alone. It gets no descriptors of this one, writes to no terminal, leaves no core file, and takes no
/// more memory than there is. It ends when this object does, and when the caller's process ends, however it ends.
class ReaderProcess {
public:
    /// Starts it. Throws InputError where the program is not there or cannot be started. Cost: some milliseconds.
    ReaderProcess();
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;
    ~ReaderProcess();

    struct Answer {
        Bytes text;
        std::vector<std::shared_ptr<SharedMemory>> memory;
    };

    /// What a request is about, for messages.
    struct Subject {
        const std::string& path;
        const char* what;  ///< "reading the surface"
    };

    /// Sends a request and waits for the answer. `progress` is called several times a second, so that it may throw to
    /// give up. What libraries print meanwhile goes to tellReaderWords(). Throws InputError: what the reader found, or
    /// one line where it ended, or made no progress for readerPatience().
    Answer ask(PacketKind kind, std::span<const std::byte> request, const Subject& subject,
               const ProgressReport& progress);

    /// The file is not needed any longer. Does not wait. Never throws.
    void close() noexcept;

    /// Whether it has answered all that it was asked, is still there, and belongs to this process: so it can be asked
    /// again. Waits at most so long for it to be done with the file that was closed.
    bool ready(int waitMs = 0) noexcept;

private:
    [[noreturn]] void failEnded(const Subject& subject);
    [[noreturn]] void failSilent(const Subject& subject);
    std::string endedHow();
    std::string words(long from) const;
    void tellWords(const Subject& subject) noexcept;
    void end() noexcept;

    pid_t pid_ = -1, owner_ = -1;  // owner_: the process that started it. A copy made by fork() must not end it.
    bool ready_ = true;            // Nothing is left to be answered …
    bool closing_ = false;         // … but that the file is closed.
    PacketSocket socket_;
    OwnedFile words_;     // What its libraries say to standard output and standard error.
    long toldWords_ = 0;  // Bytes of it that tellReaderWords() has got.
};

/// Throws InputError: a reader's answer about the file makes no sense.
[[noreturn]] void failNonsense(const std::string& path);

/// The value in a reader's answer about the file.
template <class Value>
Value valueIn(const Bytes& answer, const std::string& path)
{
    try {
        ByteReader message(answer);
        Value value{};
        message.read(value);
        return value;
    } catch (const std::runtime_error&) {
        failNonsense(path);
    }
}

/// How long a reader may make no progress, in seconds: AEOLIC_READER_SECONDS, or 60. Progress is what it tells, and
/// bytes that it reads.
double readerPatience();

}  // namespace aeolic
