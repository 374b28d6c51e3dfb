#include "stream/job/tile_server.h"

#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <thread>
#include <vector>

// GCC 12 with the sanitizers takes Beast's empty optionals for some that nobody wrote.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/beast/websocket/stream.hpp>
#pragma GCC diagnostic pop

#include "stream/message.h"

namespace aeolic::stream {
namespace {

namespace asio = boost::asio;
namespace websocket = boost::beast::websocket;

constexpr std::uint32_t kViewer = 7;

/// A viewer's connection to a rank, which reads when it is told to.
class Link {
public:
    Link(const TileServer& server, const std::string& token) : socket_(io_)
    {
        socket_.read_message_max(64 << 20);
        const asio::ip::tcp::endpoint place(asio::ip::address_v4::loopback(), server.port());
        auto& tcp = socket_.next_layer();
        tcp.open(asio::ip::tcp::v4());
        tcp.set_option(asio::socket_base::receive_buffer_size(64 << 10));
        tcp.connect(place);
        socket_.handshake("127.0.0.1", "/tiles?token=" + token);
    }
    /// The frame of the next tile.
    std::uint32_t read()
    {
        boost::beast::flat_buffer buffer;
        socket_.read(buffer);
        return *frameOf({static_cast<const std::uint8_t*>(buffer.data().data()), buffer.size()});
    }

private:
    asio::io_context io_;
    websocket::stream<asio::ip::tcp::socket, false> socket_;
};

/// More than what a system keeps for a connection on its own account.
WireMessage largeTile(std::uint32_t frame)
{
    ByteVector message = beginMessage(MessageType::tile);
    putTileHeader(message, {frame, 0, 1, 1, 0, 0, 3, 0});
    message.resize(message.size() + (std::size_t{16} << 20));
    return endMessage(std::move(message));
}

class TileServers : public testing::Test {
protected:
    /// Connected, and known to be by the server.
    static std::unique_ptr<Link> joined(TileServer& to, std::uint32_t viewer)
    {
        to.invite(viewer, "token");
        auto link = std::make_unique<Link>(to, "token");
        const WireMessage first = frameEndMessage(1, "{}");
        while (!to.send(viewer, first)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        EXPECT_EQ(link->read(), 1u);
        return link;
    }
    std::unique_ptr<Link> joined() { return joined(server, kViewer); }
    TileServer server{false};
};

TEST_F(TileServers, WhoIsNotConnectedIsSentNothing)
{
    EXPECT_FALSE(server.send(kViewer, largeTile(1)));
    const auto link = joined();
    EXPECT_FALSE(server.send(kViewer + 1, largeTile(1)));
}

TEST_F(TileServers, WhoReadsNothingIsOwedTwoFramesAtMost)
{
    const auto link = joined();
    const WireMessage tiles[] = {largeTile(2), largeTile(3), largeTile(4)};
    EXPECT_TRUE(server.send(kViewer, tiles[0]));
    EXPECT_TRUE(server.send(kViewer, tiles[1]));
    EXPECT_TRUE(server.send(kViewer, tiles[1])) << "more of the same frame";
    EXPECT_FALSE(server.send(kViewer, tiles[2])) << "to be relayed";
    EXPECT_EQ(link->read(), 2u);
    while (!server.send(kViewer, tiles[2])) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    for (const std::uint32_t frame : {3u, 3u, 4u}) EXPECT_EQ(link->read(), frame);
}

/// Many viewers, each within its two frames, could fill the memory together. What is too much is relayed, where the
/// gateway's own limit counts.
TEST_F(TileServers, WhatWaitsForAllViewersTogetherHasALimit)
{
    TileServer small(false, {}, {.bytes = std::uint64_t{40} << 20});
    const auto first = joined(small, kViewer), second = joined(small, kViewer + 1);
    EXPECT_TRUE(small.send(kViewer, largeTile(2)));
    EXPECT_TRUE(small.send(kViewer, largeTile(3)));
    EXPECT_FALSE(small.send(kViewer + 1, largeTile(2))) << "48 MiB";
    EXPECT_EQ(first->read(), 2u);
    while (!small.send(kViewer + 1, largeTile(2))) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(second->read(), 2u);
}

TEST_F(TileServers, InvitationsThatNobodyTakesAreForgotten)
{
    TileServer quick(false, {}, {.invitationTime = std::chrono::milliseconds(50)});
    for (std::uint32_t viewer = 0; viewer < 1000; ++viewer) quick.invite(viewer, "token" + std::to_string(viewer));
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (quick.invitations() > 0 && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(quick.invitations(), 0u);
}

TEST_F(TileServers, ListenOnTheirPortsAndSayWhereNoneIsFree)
{
    const TileServer any(false);
    const std::uint16_t taken = any.port();
    EXPECT_THROW(TileServer(false, {taken, taken}), std::runtime_error);
    if (taken == 65535) GTEST_SKIP() << "no port beside this one";
    const TileServer next(false, {taken, std::uint16_t(std::min(taken + 20, 65535))});
    EXPECT_GT(next.port(), taken);
}

TEST_F(TileServers, TilesOfManyThreadsAllArrive)
{
    constexpr int threads = 4, tiles = 200;
    const auto link = joined();
    std::atomic<int> refused{0};
    std::vector<std::thread> senders;
    for (int i = 0; i < threads; ++i)
        senders.emplace_back([&] {
            for (int tile = 0; tile < tiles; ++tile) refused += !server.send(kViewer, frameEndMessage(2, "{}"));
        });
    for (int i = 0; i < threads * tiles; ++i) EXPECT_EQ(link->read(), 2u);
    for (std::thread& sender : senders) sender.join();
    EXPECT_EQ(refused, 0);
}

}  // namespace
}  // namespace aeolic::stream
