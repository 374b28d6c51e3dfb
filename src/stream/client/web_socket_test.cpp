#include "stream/client/web_socket.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <stdexcept>
#include <string>

// GCC 12 with the sanitizers takes Beast's empty optionals for some that nobody wrote.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#pragma GCC diagnostic pop

namespace aeolic::stream {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using Tcp = asio::ip::tcp;
using std::chrono::milliseconds;

/// A server that opens the WebSocket of one client, says nothing and waits for its end.
class SilentServer {
public:
    SilentServer()
    {
        ended_ = std::async(std::launch::async, [this] {
            beast::websocket::stream<Tcp::socket, false> socket(acceptor_.accept());
            socket.accept();
            boost::system::error_code error;
            beast::flat_buffer buffer;
            socket.read(buffer, error);
            return bool(error);
        });
    }
    StreamAddress address() const
    {
        StreamAddress address;
        address.host = "127.0.0.1";
        address.port = std::to_string(acceptor_.local_endpoint().port());
        return address;
    }
    /// Whether the client is gone, which is waited for a while.
    bool left() { return ended_.wait_for(std::chrono::seconds(60)) == std::future_status::ready && ended_.get(); }

private:
    asio::io_context io_;
    Tcp::acceptor acceptor_{io_, {asio::ip::address_v4::loopback(), 0}};
    std::future<bool> ended_;  // Last: its thread uses the others.
};

TEST(ClientWebSockets, AServerThatDoesNotAnswerInTimeIsLeft)
{
    SilentServer server;
    const auto socket = openWebSocket(server.address(), false, milliseconds(60'000));
    try {
        socket->receive(milliseconds(20));
        FAIL() << "it got a message";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "the server did not answer within 20 ms");
    }
    EXPECT_TRUE(server.left());
}

TEST(ClientWebSockets, WhatFollowsATimeOutFailsAtOnce)
{
    SilentServer server;
    const auto socket = openWebSocket(server.address(), false, milliseconds(60'000));
    EXPECT_THROW(socket->receive(milliseconds(20)), std::runtime_error);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THROW(socket->receive(milliseconds(60'000)), std::runtime_error);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

// What is pending when a call gives up must not write to where that call was.
TEST(ClientWebSockets, OneThatTimedOutEndsInPeace)
{
    SilentServer server;
    auto socket = openWebSocket(server.address(), false, milliseconds(60'000));
    EXPECT_THROW(socket->receive(milliseconds(20)), std::runtime_error);
    socket.reset();
    EXPECT_TRUE(server.left());
}

}  // namespace
}  // namespace aeolic::stream
