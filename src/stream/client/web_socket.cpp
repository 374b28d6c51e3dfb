#include "stream/client/web_socket.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/host_name_verification.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <memory>
#include <optional>
#include <stdexcept>

#include "stream/beast.h"

namespace aeolic::stream {
namespace {

using TlsStream = beast::ssl_stream<beast::tcp_stream>;

constexpr std::size_t kLargestMessage = (std::size_t{64} << 20) + kHeaderBytes;

/// What has become of an operation.
struct Outcome {
    std::exception_ptr failure;
    bool done = false;
};

template <class Stream>
class Socket final : public ClientWebSocket {
public:
    template <class... Arguments>
    explicit Socket(const StreamAddress& address, std::chrono::milliseconds timeout, Arguments&... arguments)
        : socket_(io_, arguments...)
    {
        run(open(address), timeout);
    }

    void send(const WireMessage& message, std::chrono::milliseconds timeout) override { run(write(message), timeout); }
    ByteVector receive(std::chrono::milliseconds timeout) override
    {
        const auto bytes = std::make_shared<ByteVector>();
        run(read(bytes), timeout);
        return std::move(*bytes);
    }

private:
    /// Runs one operation to its end. When the time is over the connection is given up, and this throws. What the
    /// operation needs must be its own: looking a name up cannot be given up.
    void run(asio::awaitable<void> operation, std::chrono::milliseconds timeout)
    {
        const auto outcome = std::make_shared<Outcome>();
        asio::co_spawn(io_, std::move(operation), [outcome](const std::exception_ptr& failure) {
            outcome->failure = failure;
            outcome->done = true;
        });
        io_.restart();
        io_.run_for(timeout);
        if (!outcome->done) {
            boost::system::error_code ignored;
            beast::get_lowest_layer(socket_).socket().close(ignored);
            io_.restart();
            io_.poll();  // Lets it end.
            throw std::runtime_error("the server did not answer within " + std::to_string(timeout.count()) + " ms");
        }
        if (outcome->failure) std::rethrow_exception(outcome->failure);
    }

    asio::awaitable<void> open(StreamAddress address)
    {
        Tcp::resolver resolver(io_);
        const auto found = co_await resolver.async_resolve(address.host, address.port, asio::use_awaitable);
        co_await beast::get_lowest_layer(socket_).async_connect(found, asio::use_awaitable);
        beast::get_lowest_layer(socket_).socket().set_option(Tcp::no_delay(true));
        if constexpr (std::is_same_v<Stream, TlsStream>) {
            SSL_set_tlsext_host_name(socket_.next_layer().native_handle(), address.host.c_str());
            socket_.next_layer().set_verify_callback(asio::ssl::host_name_verification(address.host));
            co_await socket_.next_layer().async_handshake(asio::ssl::stream_base::client, asio::use_awaitable);
        }
        setMessages(socket_, kLargestMessage);
        const std::string target = "/stream" + (address.token.empty() ? "" : "?token=" + address.token);
        websocket::response_type response;
        try {
            co_await socket_.async_handshake(response, address.host + ":" + address.port, target, asio::use_awaitable);
        } catch (const boost::system::system_error&) {
            if (response.result_int() == 401) throw std::runtime_error("the token is not the server's");
            throw;
        }
    }
    asio::awaitable<void> write(WireMessage message)
    {
        co_await socket_.async_write(asio::buffer(*message), asio::use_awaitable);
    }
    asio::awaitable<void> read(std::shared_ptr<ByteVector> bytes)
    {
        auto buffer = asio::dynamic_buffer(*bytes);
        try {
            co_await socket_.async_read(buffer, asio::use_awaitable);
        } catch (const boost::system::system_error& error) {
            if (error.code() != websocket::error::closed) throw;
            const auto& reason = socket_.reason();
            throw std::runtime_error("the server hung up (" + std::to_string(reason.code) + ") " +
                                     std::string(reason.reason.c_str()));
        }
    }

    asio::io_context io_{1};
    websocket::stream<Stream> socket_;
};

class TlsSocket final : public ClientWebSocket {
public:
    TlsSocket(const StreamAddress& address, bool trustAny, std::chrono::milliseconds timeout)
    {
        context_.set_default_verify_paths();
        context_.set_verify_mode(trustAny ? asio::ssl::verify_none : asio::ssl::verify_peer);
        socket_.emplace(address, timeout, context_);
    }
    void send(const WireMessage& message, std::chrono::milliseconds timeout) override
    {
        socket_->send(message, timeout);
    }
    ByteVector receive(std::chrono::milliseconds timeout) override { return socket_->receive(timeout); }

private:
    asio::ssl::context context_{asio::ssl::context::tls_client};
    std::optional<Socket<TlsStream>> socket_;
};

}  // namespace

std::unique_ptr<ClientWebSocket> openWebSocket(const StreamAddress& address, bool trustAnyCertificate,
                                               std::chrono::milliseconds timeout)
{
    const std::string where = address.host + ":" + address.port + ": ";
    try {
        if (address.secure) return std::make_unique<TlsSocket>(address, trustAnyCertificate, timeout);
        return std::make_unique<Socket<beast::tcp_stream>>(address, timeout);
    } catch (const boost::system::system_error& error) {
        throw std::runtime_error(where + error.code().message());
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(where + error.what());
    }
}

}  // namespace aeolic::stream
