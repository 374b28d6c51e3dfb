#include "data/reading/packet_socket.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace aeolic {
namespace {

constexpr std::size_t kMostBytes = 32 << 10;                // Sent as they are.
constexpr std::size_t kLongestText = std::size_t(1) << 32;  // Descriptions of millions of parts are shorter.

struct Head {
    PacketKind kind;
    std::uint8_t isLong;  // The text is in the last descriptor.
};

[[noreturn]] void failBySystem(const char* what)
{
    if (errno == EPIPE || errno == ECONNRESET || errno == ENOTCONN) throw LostPeer();
    throw std::system_error(errno, std::generic_category(), what);
}

OwnedFile textFile(std::span<const std::byte> bytes)
{
    OwnedFile file(memfd_create("aeolic-text", MFD_CLOEXEC));
    if (!file) failBySystem("memfd_create");
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count = ::write(file.get(), bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) failBySystem("write");
        done += std::size_t(count);
    }
    return file;
}

Bytes textOf(const OwnedFile& file)
{
    struct stat status {};
    if (fstat(file.get(), &status) != 0 || status.st_size < 0) throw LostPeer();
    if (std::size_t(status.st_size) > kLongestText) throw TooLong();
    Bytes bytes(std::size_t(status.st_size));
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count = ::pread(file.get(), bytes.data() + done, bytes.size() - done, off_t(done));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) throw LostPeer();
        done += std::size_t(count);
    }
    return bytes;
}

}  // namespace

void PacketSocket::send(PacketKind kind, std::span<const std::byte> bytes, std::span<const int> files) const
{
    if (bytes.size() > kLongestText) throw TooLong();
    Head head{kind, bytes.size() > kMostBytes};
    OwnedFile text;
    std::vector<int> attached(files.begin(), files.end());
    if (head.isLong) {
        text = textFile(bytes);
        attached.push_back(text.get());
        bytes = {};
    }
    std::array<iovec, 2> parts{{{&head, sizeof head}, {const_cast<std::byte*>(bytes.data()), bytes.size()}}};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int) * (kMostFiles + 1))> control{};
    msghdr message{};
    message.msg_iov = parts.data();
    message.msg_iovlen = parts.size();
    if (!attached.empty()) {
        message.msg_control = control.data();
        message.msg_controllen = CMSG_SPACE(sizeof(int) * attached.size());
        cmsghdr* header = CMSG_FIRSTHDR(&message);
        header->cmsg_level = SOL_SOCKET;
        header->cmsg_type = SCM_RIGHTS;
        header->cmsg_len = CMSG_LEN(sizeof(int) * attached.size());
        std::memcpy(CMSG_DATA(header), attached.data(), sizeof(int) * attached.size());
    }
    while (sendmsg(socket_.get(), &message, MSG_NOSIGNAL) < 0)
        if (errno != EINTR) failBySystem("sendmsg");
}

std::optional<Packet> PacketSocket::receive(int timeoutMs) const
{
    pollfd wait{socket_.get(), POLLIN, 0};
    const int ready = poll(&wait, 1, timeoutMs);
    if (ready == 0 || (ready < 0 && errno == EINTR)) return std::nullopt;
    if (ready < 0) failBySystem("poll");

    Head head{};
    Packet packet;
    packet.bytes.resize(kMostBytes);
    std::array<iovec, 2> parts{{{&head, sizeof head}, {packet.bytes.data(), packet.bytes.size()}}};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int) * (kMostFiles + 1))> control{};
    msghdr message{};
    message.msg_iov = parts.data();
    message.msg_iovlen = parts.size();
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    ssize_t count = 0;
    while ((count = recvmsg(socket_.get(), &message, MSG_CMSG_CLOEXEC)) < 0)
        if (errno != EINTR) failBySystem("recvmsg");
    for (cmsghdr* header = CMSG_FIRSTHDR(&message); header; header = CMSG_NXTHDR(&message, header)) {
        if (header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS) continue;
        const std::size_t files = (header->cmsg_len - CMSG_LEN(0)) / sizeof(int);
        for (std::size_t i = 0; i < files; ++i) {
            int descriptor = -1;
            std::memcpy(&descriptor, CMSG_DATA(header) + i * sizeof(int), sizeof descriptor);
            packet.files.emplace_back(descriptor);
        }
    }
    if ((message.msg_flags & MSG_CTRUNC) != 0)
        throw std::system_error(EMFILE, std::generic_category(), "descriptors of an answer");
    if (count < ssize_t(sizeof head) || (message.msg_flags & MSG_TRUNC) != 0) throw LostPeer();
    packet.kind = head.kind;
    packet.bytes.resize(std::size_t(count) - sizeof head);
    if (head.isLong != 0) {
        if (packet.files.empty()) throw LostPeer();
        packet.bytes = textOf(packet.files.back());
        packet.files.pop_back();
    }
    return packet;
}

}  // namespace aeolic
