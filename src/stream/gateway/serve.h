#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stream/gateway/supervisor.h"
#include "stream/gateway/web_server.h"

namespace aeolic::stream {

/// What the server is asked for. serve() fills in the rest: of `web` TLS, how many connections there may be, and all
/// rules but `token`, `embedded` and `sessions`; of `job` its words, where ranks connect to, and what they are told.
struct ServeOptions {
    Hub::Options hub;
    WebServerOptions web;
    JobOptions job;
    std::string certificate, key;  ///< Empty: no TLS.
    std::string launcher;          ///< Empty: mpirun for several ranks, no launcher for one.
    std::string jobHost;  ///< Where ranks connect to. Empty: with a launcher all addresses of this host, else loopback.
    std::string program;  ///< The executable with the render job.
    std::function<void(const std::string& address)> ready;  ///< Called once, when viewers may come.
};

/// Serves until SIGINT or SIGTERM. Throws InputError for what the user can put right: an address in use, a certificate,
/// a launcher, a scene that cannot be loaded. Uses no MPI and starts no threads of its own: the render job is another
/// process.
void serve(const ServeOptions& options);

/// The answer to `GET /status`: the hub's state, and the processes of the ranks.
std::string statusJson(const Hub& hub, const std::vector<int>& pids);

/// What to type into a browser: IPv6 addresses in brackets, no wildcard, and the token, if it is not empty.
std::string addressText(std::string host, std::uint16_t port, bool secure, const std::string& token);

}  // namespace aeolic::stream
