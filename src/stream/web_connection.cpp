#include "stream/web_connection.h"

#include <algorithm>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/host_name_verification.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "base/text.h"
#include "stream/byte_stream.h"

namespace aeolic::stream {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;

namespace {

using WebSocket = websocket::stream<ByteStream, false>;  // Without compression: tiles are compressed already.

/// Messages are binary and go out in one piece; larger ones than `largestMessage` bytes do not come in.
void setMessages(WebSocket& socket, std::size_t largestMessage)
{
    socket.read_message_max(largestMessage);
    socket.binary(true);
    socket.auto_fragment(false);
}

ByteStream makeStream(Tcp::socket&& socket, asio::ssl::context* tls)
{
    return tls ? ByteStream(std::move(socket), *tls) : ByteStream(std::move(socket));
}

}  // namespace

struct WebConnection::State {
    std::shared_ptr<asio::ssl::context> tls;
    WebSocket socket;  // Until the WebSocket is open, HTTP goes over its next layer.
    beast::flat_buffer requests;

    State(Tcp::socket&& tcp, const std::shared_ptr<asio::ssl::context>& context)
        : tls(context), socket(makeStream(std::move(tcp), context.get()))
    {
    }
    ByteStream& stream() { return socket.next_layer(); }
};

WebConnection::WebConnection(Tcp::socket socket, const std::shared_ptr<asio::ssl::context>& tls)
    : state_(std::make_unique<State>(std::move(socket), tls))
{
}
WebConnection::~WebConnection() = default;
WebConnection::WebConnection(WebConnection&&) noexcept = default;

asio::any_io_executor WebConnection::executor() const
{
    return state_->stream().get_executor();
}

void WebConnection::drop()
{
    boost::system::error_code ignored;
    state_->stream().tcp().socket().close(ignored);
}

asio::awaitable<void> WebConnection::acceptTls()
{
    co_await state_->stream().tls().async_handshake(asio::ssl::stream_base::server, asio::use_awaitable);
}

void WebConnection::expiresAfter(std::chrono::milliseconds time)
{
    state_->stream().tcp().expires_after(time);
}

asio::awaitable<HttpRequest> WebConnection::readRequest(std::uint32_t mostHeaderBytes, std::uint32_t mostBodyBytes)
{
    state_->requests.max_size(mostHeaderBytes + mostBodyBytes);
    http::request_parser<http::string_body> parser;
    parser.header_limit(mostHeaderBytes);
    parser.body_limit(mostBodyBytes);
    co_await http::async_read(state_->stream(), state_->requests, parser, asio::use_awaitable);
    co_return parser.release();
}

asio::awaitable<void> WebConnection::writeAnswer(const HttpResponse& answer)
{
    co_await http::async_write(state_->stream(), answer, asio::use_awaitable);
}

asio::awaitable<WebConnection::Error> WebConnection::acceptWebSocket(HttpRequest request, std::size_t largestMessage)
{
    state_->stream().tcp().expires_never();  // From here on the WebSocket's own times count.
    websocket::stream_base::timeout times{};
    times.handshake_timeout = std::chrono::seconds(5);
    times.idle_timeout = std::chrono::seconds(30);
    times.keep_alive_pings = true;
    state_->socket.set_option(times);
    setMessages(state_->socket, largestMessage);
    Error error;
    co_await state_->socket.async_accept(request, asio::redirect_error(asio::use_awaitable, error));
    co_return error;
}

asio::awaitable<void> WebConnection::connect(Tcp::resolver::results_type places)
{
    co_await state_->stream().tcp().async_connect(places, asio::use_awaitable);
    state_->stream().tcp().socket().set_option(Tcp::no_delay(true));
}

asio::awaitable<void> WebConnection::connectTls(std::string host)
{
    auto& tls = state_->stream().tls();
    SSL_set_tlsext_host_name(tls.native_handle(), host.c_str());
    tls.set_verify_callback(asio::ssl::host_name_verification(host));
    co_await tls.async_handshake(asio::ssl::stream_base::client, asio::use_awaitable);
}

asio::awaitable<void> WebConnection::openWebSocket(std::string host, std::string target, std::size_t largestMessage,
                                                   unsigned& status)
{
    setMessages(state_->socket, largestMessage);
    websocket::response_type response;
    Error error;
    co_await state_->socket.async_handshake(response, host, target, asio::redirect_error(asio::use_awaitable, error));
    status = response.result_int();
    if (error) throw boost::system::system_error(error);
}

asio::awaitable<WebConnection::Error> WebConnection::read(ByteVector& message)
{
    auto buffer = asio::dynamic_buffer(message);
    Error error;
    co_await state_->socket.async_read(buffer, asio::redirect_error(asio::use_awaitable, error));
    co_return error;
}

asio::awaitable<WebConnection::Error> WebConnection::write(WireMessage message)
{
    Error error;
    co_await state_->socket.async_write(asio::buffer(*message), asio::redirect_error(asio::use_awaitable, error));
    co_return error;
}

asio::awaitable<WebConnection::Error> WebConnection::close(std::uint16_t code, std::string reason)
{
    websocket::close_reason why{websocket::close_code(code)};
    const std::size_t length = characterStart(reason, std::min(reason.size(), why.reason.max_size()));
    why.reason.assign(reason.begin(), reason.begin() + std::ptrdiff_t(length));
    Error error;
    co_await state_->socket.async_close(why, asio::redirect_error(asio::use_awaitable, error));
    co_return error;
}

std::chrono::steady_clock::time_point WebConnection::wroteAt() const
{
    return state_->stream().wroteAt();
}

bool WebConnection::gotBinary() const
{
    return state_->socket.got_binary();
}
std::uint16_t WebConnection::closeCode() const
{
    return state_->socket.reason().code;
}
std::string WebConnection::closeReason() const
{
    return state_->socket.reason().reason.c_str();
}

bool asksForWebSocket(const HttpRequest& request)
{
    return websocket::is_upgrade(request);
}

}  // namespace aeolic::stream
