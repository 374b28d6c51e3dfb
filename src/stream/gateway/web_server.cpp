#include "stream/gateway/web_server.h"

#include <sys/socket.h>

#include <boost/asio/ssl/context.hpp>
#include <list>

#include "aeolic/error.h"
#include "stream/gateway/viewer_session.h"
#include "stream/gateway/wrong_tokens.h"
#include "stream/link/accept.h"
#include "stream/listen.h"

namespace aeolic::stream {
namespace {

namespace http = boost::beast::http;

constexpr auto kRequestTime = std::chrono::seconds(10);  // For one whole request, however slowly it comes.
constexpr std::uint32_t kMostHeaderBytes = 8 * 1024, kMostBodyBytes = 1024;

Tcp::acceptor listenForViewers(asio::io_context& io, const std::string& host, std::uint16_t port)
{
    try {
        return listenOn(io, host, {port, port});
    } catch (const boost::system::system_error& error) {
        const auto& category = error.code().category();
        if (category == asio::error::get_netdb_category() || category == asio::error::get_addrinfo_category())
            throw InputError("--host", "'" + host + "' (" + error.code().message() + ")", "an address of this host");
        throw InputError("--port", std::to_string(port) + " on " + host + " (" + error.code().message() + ")",
                         "a free port of an address of this host");
    }
}

}  // namespace

std::shared_ptr<asio::ssl::context> makeTlsContext(const std::string& certificate, const std::string& key)
{
    auto context = std::make_shared<asio::ssl::context>(asio::ssl::context::tls_server);
    context->set_options(asio::ssl::context::default_workarounds | asio::ssl::context::no_tlsv1 |
                         asio::ssl::context::no_tlsv1_1);
    boost::system::error_code error;
    context->use_certificate_chain_file(certificate, error);
    if (error) throw InputError("--tls-cert " + certificate, error.message(), "a PEM file with the certificate chain");
    context->use_private_key_file(key, asio::ssl::context::pem, error);
    if (error) throw InputError("--tls-key " + key, error.message(), "a PEM file with the certificate's private key");
    return context;
}

struct WebServer::State {
    asio::io_context& io;
    WebServerOptions options;
    std::shared_ptr<Tcp::acceptor> acceptor =
        std::make_shared<Tcp::acceptor>(listenForViewers(io, options.host, options.port));
    Hub& hub;
    int connections = 0;
    std::list<std::weak_ptr<ViewerPort>> viewers;
    WrongTokens wrongTokens;
    const std::shared_ptr<CommonRate> rate = std::make_shared<CommonRate>();

    State(asio::io_context& theIo, WebServerOptions theOptions, Hub& theHub)
        : io(theIo), options(std::move(theOptions)), hub(theHub)
    {
        // Browsers share cookies among the ports of a host: two servers would overwrite each other's.
        options.rules.cookieName = "aeolic-" + std::to_string(acceptor->local_endpoint().port());
    }

    static asio::awaitable<void> serve(std::shared_ptr<State> self, Tcp::socket socket)
    {
        if (self->connections >= self->options.mostConnections) co_return;
        ++self->connections;
        try {
            const asio::ip::address from = socket.remote_endpoint().address();
            WebConnection connection(std::move(socket), self->options.tls);
            connection.expiresAfter(kRequestTime);
            if (self->options.tls) co_await connection.acceptTls();
            co_await self->serveRequests(std::move(connection), from);
        } catch (const std::exception&) {
            // The client has hung up, or what it sent is not HTTP. There is nothing to answer.
        }
        --self->connections;
    }

    asio::awaitable<void> serveRequests(WebConnection connection, asio::ip::address from)
    {
        for (;;) {
            connection.expiresAfter(kRequestTime);
            HttpRequest request = co_await connection.readRequest(kMostHeaderBytes, kMostBodyBytes);
            co_await waitAfterWrongTokens(request, from);
            if (asksForWebSocket(request)) {
                const http::status refusal = refusalOf(request);
                if (refusal == http::status::ok) {
                    const auto session = std::make_shared<ViewerSession>(std::move(connection), hub, rate);
                    viewers.remove_if([](const auto& viewer) { return viewer.expired(); });
                    viewers.push_back(session);
                    co_await session->run(std::move(request));
                    co_return;
                }
                const HttpResponse response = emptyAnswer(request, refusal);
                co_await connection.writeAnswer(response);
                co_return;
            }
            const HttpResponse response = answer(request, options.rules);
            connection.expiresAfter(kRequestTime);
            co_await connection.writeAnswer(response);
            if (!response.keep_alive()) co_return;
        }
    }

    asio::awaitable<void> waitAfterWrongTokens(const HttpRequest& request, asio::ip::address from)
    {
        if (!goesByToken(request, options.rules)) co_return;
        const SteadyClock::time_point now = SteadyClock::now();
        const auto wait = wrongTokens.waitFor(from, now);
        if (!bringsToken(request, options.rules.token)) wrongTokens.add(from, now);
        if (wait.count() == 0) co_return;
        co_await pauseFor(wait);
    }

    /// The status that refuses a WebSocket; ok where it may be opened.
    http::status refusalOf(const HttpRequest& request) const
    {
        if (!mayEnter(request, options.rules)) return http::status::unauthorized;
        if (!isOwnOrigin(request, options.rules)) return http::status::forbidden;
        if (pathOf(request) != "/stream") return http::status::not_found;
        return http::status::ok;
    }
};

WebServer::WebServer(asio::io_context& io, WebServerOptions options, Hub& hub)
    : state_(std::make_shared<State>(io, std::move(options), hub))
{
    const auto take = [state = state_](Tcp::socket socket) {
        asio::co_spawn(state->io, State::serve(state, std::move(socket)), asio::detached);
    };
    asio::co_spawn(io, acceptAll(state_->acceptor, kWriteLimit, take), asio::detached);
}

WebServer::~WebServer()
{
    stop();
}

std::uint16_t WebServer::port() const
{
    return state_->acceptor->local_endpoint().port();
}

void WebServer::stop()
{
    if (!state_->acceptor->is_open()) return;
    boost::system::error_code ignored;
    ::shutdown(state_->acceptor->native_handle(), SHUT_RDWR);  // A process that was forked may hold the socket, too.
    state_->acceptor->close(ignored);
    for (const auto& viewer : state_->viewers)
        if (const auto port = viewer.lock()) port->close(Goodbye::goingAway, "the server stops");
}

}  // namespace aeolic::stream
