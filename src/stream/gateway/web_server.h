#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <memory>
#include <optional>
#include <string>

#include "stream/gateway/http_answers.h"
#include "stream/gateway/hub/hub.h"

namespace boost::asio::ssl {
class context;
}

namespace aeolic::stream {

struct WebServerOptions {
    std::string host = "127.0.0.1";
    std::uint16_t port = 8080;  ///< 0: any free port.
    int mostConnections = 256;  ///< At once. Each is an open file.
    HttpRules rules;
    std::shared_ptr<boost::asio::ssl::context> tls;  ///< Null: plain.
};

/// TLS 1.2 or newer with the user's certificate chain and key (PEM). Throws InputError naming the file.
std::shared_ptr<boost::asio::ssl::context> makeTlsContext(const std::string& certificate, const std::string& key);

/// The port that browsers and programs connect to for page, status and stream. Runs on the one thread of `io`.
class WebServer {
public:
    /// Listens. Throws InputError where host or port cannot be had.
    WebServer(boost::asio::io_context& io, WebServerOptions options, Hub& hub);
    ~WebServer();

    std::uint16_t port() const;
    /// Takes no more connections and tells viewers that the server stops.
    void stop();

private:
    struct State;
    std::shared_ptr<State> state_;
};

}  // namespace aeolic::stream
