#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "stream/asio.h"
#include "stream/http_request.h"
#include "stream/message.h"

namespace boost::asio::ssl {
class context;
}

namespace aeolic::stream {

/// One connection that speaks HTTP and then, where both sides want it, the WebSocket protocol; plain or TLS. Beast's
/// templates take minutes to compile, so web_connection.cpp alone includes them.
///
/// GCC 12 compiles a co_await within a condition to a trap: each must be a statement of its own.
/// All calls are made by the thread that runs the socket's io_context. A connection must outlive its coroutines. Those
/// that return void throw boost::system::system_error; the others return what went wrong.
class WebConnection {
public:
    using Error = boost::system::error_code;

    /// `tls` is null for a plain connection.
    WebConnection(Tcp::socket socket, const std::shared_ptr<asio::ssl::context>& tls);
    ~WebConnection();
    WebConnection(WebConnection&&) noexcept;

    asio::any_io_executor executor() const;
    /// Closes the socket without a word. What is pending on it fails.
    void drop();

    // A server's side.
    asio::awaitable<void> acceptTls();
    /// How long each operation before the WebSocket opens may take from now on.
    void expiresAfter(std::chrono::milliseconds time);
    asio::awaitable<HttpRequest> readRequest(std::uint32_t mostHeaderBytes, std::uint32_t mostBodyBytes);
    asio::awaitable<void> writeAnswer(const HttpResponse& answer);
    /// Opens the WebSocket that `request` asks for. A client that is silent is pinged before it is taken for gone.
    asio::awaitable<Error> acceptWebSocket(HttpRequest request, std::size_t largestMessage);

    // A client's side.
    asio::awaitable<void> connect(Tcp::resolver::results_type places);
    /// Checks that the server's certificate is for `host`.
    asio::awaitable<void> connectTls(std::string host);
    /// Opens a WebSocket. `status` gets the server's answer, which is 101 where it agrees.
    asio::awaitable<void> openWebSocket(std::string host, std::string target, std::size_t largestMessage,
                                        unsigned& status);

    // Messages over the WebSocket. At most one read and one write are pending at a time.
    /// Appends the next message to `message`.
    asio::awaitable<Error> read(ByteVector& message);
    asio::awaitable<Error> write(WireMessage message);
    /// When the last byte was written.
    std::chrono::steady_clock::time_point wroteAt() const;
    /// Says goodbye. Of `reason` as many bytes are sent as the protocol allows.
    asio::awaitable<Error> close(std::uint16_t code, std::string reason);
    /// Whether the last message was binary, and not text.
    bool gotBinary() const;
    /// The goodbye of the other side, after `read` has ended with websocket::error::closed.
    std::uint16_t closeCode() const;
    std::string closeReason() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

bool asksForWebSocket(const HttpRequest& request);

}  // namespace aeolic::stream
