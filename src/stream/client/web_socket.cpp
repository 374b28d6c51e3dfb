#include "stream/client/web_socket.h"

#include <boost/asio/ssl/context.hpp>
#include <boost/beast/websocket/error.hpp>
#include <stdexcept>

#include "stream/web_connection.h"

namespace aeolic::stream {
namespace {

constexpr std::size_t kLargestMessage = (std::size_t{64} << 20) + kHeaderBytes;

/// How an operation has ended, or that it has not.
struct Outcome {
    std::exception_ptr failure;
    bool done = false;
};

std::shared_ptr<asio::ssl::context> makeTlsContext(bool trustAny)
{
    auto context = std::make_shared<asio::ssl::context>(asio::ssl::context::tls_client);
    context->set_default_verify_paths();
    context->set_verify_mode(trustAny ? asio::ssl::verify_none : asio::ssl::verify_peer);
    return context;
}

class Socket final : public ClientWebSocket {
public:
    Socket(const StreamAddress& address, bool trustAnyCertificate, std::chrono::milliseconds timeout)
        : connection_(Tcp::socket(io_), address.secure ? makeTlsContext(trustAnyCertificate) : nullptr)
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
    /// Runs one operation to its end. When the time is over, drops the connection and throws. The operation may live
    /// longer than this call, because a name lookup cannot be cancelled. So it must own everything it uses.
    void run(asio::awaitable<void> operation, std::chrono::milliseconds timeout)
    {
        const auto outcome = std::make_shared<Outcome>();
        asio::co_spawn(io_, std::move(operation), [outcome](const std::exception_ptr& failure) {
            outcome->failure = failure;
            outcome->done = true;
        });
        io_.restart();
        io_.run_for(waitable(timeout));
        if (!outcome->done) {
            connection_.drop();
            io_.restart();
            io_.poll();  // Lets the operation end.
            throw std::runtime_error("the server did not answer within " + std::to_string(timeout.count()) + " ms");
        }
        if (outcome->failure) std::rethrow_exception(outcome->failure);
    }

    asio::awaitable<void> open(StreamAddress address)
    {
        Tcp::resolver resolver(io_);
        const auto found = co_await resolver.async_resolve(address.host, address.port, asio::use_awaitable);
        co_await connection_.connect(found);
        if (address.secure) co_await connection_.connectTls(address.host);
        const bool isIpv6 = address.host.find(':') != address.host.npos;
        const std::string host = (isIpv6 ? "[" + address.host + "]" : address.host) + ":" + address.port;
        const std::string target = "/stream" + (address.token.empty() ? "" : "?token=" + address.token);
        unsigned status = 0;
        try {
            co_await connection_.openWebSocket(host, target, kLargestMessage, status);
        } catch (const boost::system::system_error&) {
            if (status == 401) throw std::runtime_error("the token is not the server's");
            throw;
        }
    }
    asio::awaitable<void> write(WireMessage message)
    {
        const WebConnection::Error error = co_await connection_.write(message);
        if (error) throw boost::system::system_error(error);
    }
    asio::awaitable<void> read(std::shared_ptr<ByteVector> bytes)
    {
        const WebConnection::Error error = co_await connection_.read(*bytes);
        if (error == boost::beast::websocket::error::closed)
            throw std::runtime_error("the server hung up (" + std::to_string(connection_.closeCode()) + ") " +
                                     connection_.closeReason());
        if (error) throw boost::system::system_error(error);
    }

    asio::io_context io_{1};
    WebConnection connection_;
};

}  // namespace

std::unique_ptr<ClientWebSocket> openWebSocket(const StreamAddress& address, bool trustAnyCertificate,
                                               std::chrono::milliseconds timeout)
{
    const std::string where = address.host + ":" + address.port + ": ";
    try {
        return std::make_unique<Socket>(address, trustAnyCertificate, timeout);
    } catch (const boost::system::system_error& error) {
        throw std::runtime_error(where + error.code().message());
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(where + error.what());
    }
}

}  // namespace aeolic::stream
