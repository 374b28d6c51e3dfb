#include "data/reading/packet_socket.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>

namespace aeolic {
namespace {

constexpr std::size_t kTooLong = (std::size_t(1) << 32) + 1;

class PacketSockets : public testing::Test {
protected:
    PacketSockets()
    {
        int pair[2];
        if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pair) != 0) throw std::runtime_error("socketpair");
        one_ = PacketSocket(OwnedFile(pair[0]));
        other_ = PacketSocket(OwnedFile(pair[1]));
    }

    PacketSocket one_, other_;
};

TEST_F(PacketSockets, LongTextsArriveWhole)
{
    Bytes text(200000);
    for (std::size_t i = 0; i < text.size(); ++i) text[i] = std::byte(i * 7 + i / 256);
    one_.send(PacketKind::answer, text);
    const auto packet = other_.receive(1000);
    ASSERT_TRUE(packet);
    EXPECT_EQ(packet->kind, PacketKind::answer);
    EXPECT_TRUE(packet->bytes == text);
    EXPECT_TRUE(packet->files.empty());
}

/// They are refused whole: nothing of them is sent.
TEST_F(PacketSockets, TextsBeyondFourGiBAreNotSent)
{
    void* const nothing = mmap(nullptr, kTooLong, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    ASSERT_NE(nothing, MAP_FAILED);
    EXPECT_THROW(one_.send(PacketKind::answer, {static_cast<const std::byte*>(nothing), kTooLong}), TooLong);
    munmap(nothing, kTooLong);
    EXPECT_FALSE(other_.receive(0));
}

/// The other side is not believed.
TEST_F(PacketSockets, TextsBeyondFourGiBAreNotTaken)
{
    const OwnedFile file(memfd_create("long", MFD_CLOEXEC));
    ASSERT_EQ(ftruncate(file.get(), off_t(kTooLong)), 0);  // A hole, which takes no memory.
    unsigned char head[2] = {static_cast<unsigned char>(PacketKind::answer), 1};
    iovec part{head, sizeof head};
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof(int));
    const int descriptor = file.get();
    std::memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
    ASSERT_GT(sendmsg(one_.descriptor(), &message, 0), 0);
    EXPECT_THROW(other_.receive(1000), TooLong);
}

}  // namespace
}  // namespace aeolic
