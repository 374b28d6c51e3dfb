#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "base/uninitialized.h"
#include "data/reading/owned_file.h"

namespace aeolic {

/// What a caller and its reader say to each other. The numbers are the first byte of a packet.
enum class PacketKind : std::uint8_t {
    open = 1,  ///< Caller: opens a file (OpenRequest). Answered by facts.
    arrays,    ///< Caller: names the parts, and asks for their arrays. Answered by facts.
    read,      ///< Caller: reads (ReadRequest). Answered by data.
    look,      ///< Caller: asks something of a file that it does not open for it (LookRequest). Answered by the facts.
    close,     ///< Caller: the file is not needed any longer. Answered, without text, once it is gone.
    progress,  ///< Reader: the share of an answer that is done.
    memory,    ///< Reader: memory of the answer that follows, as descriptors.
    answer,    ///< Reader: the last packet of an answer.
    refusal,   ///< Reader: the text of an InputError, in place of an answer.
};

struct Packet {
    PacketKind kind{};
    Bytes bytes;
    std::vector<OwnedFile> files;  ///< Descriptors that came along.
};

/// The other side has gone.
struct LostPeer : std::runtime_error {
    LostPeer() : std::runtime_error("the other side has gone") {}
};

/// What is to be said takes more than a packet's text may have.
struct TooLong : std::runtime_error {
    TooLong() : std::runtime_error("more than 4 GiB to say") {}
};

/// One end of a connection between two processes of one host, which keeps packets apart and carries descriptors. One
/// thread at a time may send, one receive.
class PacketSocket {
public:
    static constexpr std::size_t kMostFiles = 200;  ///< In one packet; Linux takes 253.

    PacketSocket() = default;
    explicit PacketSocket(OwnedFile socket) : socket_(std::move(socket)) {}

    int descriptor() const { return socket_.get(); }

    /// Long texts travel as a memory file. Throws LostPeer, TooLong, or std::system_error where the system has no
    /// memory for it.
    void send(PacketKind kind, std::span<const std::byte> bytes = {}, std::span<const int> files = {}) const;

    /// Waits for `timeoutMs` at most (-1: for ever). Nothing: the time is over. Throws LostPeer or TooLong.
    std::optional<Packet> receive(int timeoutMs) const;

private:
    OwnedFile socket_;
};

}  // namespace aeolic
