#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stream/gateway/hub/hub.h"
#include "stream/link/lost_peer.h"
#include "stream/listen.h"

namespace aeolic::stream {

struct ServeOptions {
    Hub::Options hub;
    std::string host = "127.0.0.1";
    std::uint16_t port = 8080;
    std::string token;  ///< Empty: nobody is asked for one.
    std::string certificate, key;
    int ranks = 1;
    std::string launcher;                                   ///< Empty: mpirun for several ranks, no launcher for one.
    std::string jobHost;                                    ///< Where ranks connect to. Empty: with a launcher all
                                                            ///< addresses of this host, else loopback.
    std::uint16_t jobPort = 0;                              ///< 0: any that is free.
    bool direct = false;                                    ///< Ranks send their tiles to viewers themselves.
    PortRange directPorts;                                  ///< Where ranks listen for viewers.
    std::chrono::seconds silenceLimit = kSilenceLimit;      ///< A rank that says nothing for longer ends the job.
    std::string program;                                    ///< The executable with the render job.
    std::function<void(const std::string& address)> ready;  ///< Called once, when viewers may come.
};

/// Serves until SIGINT or SIGTERM. Throws InputError for what the user can put right: an address in use, a certificate,
/// a launcher, a scene that cannot be loaded. Uses no MPI and starts no threads of its own: the render job is another
/// process.
void serve(ServeOptions options);

/// The answer to `GET /status`: the hub's state, and the processes of the ranks.
std::string statusJson(const Hub& hub, const std::vector<int>& pids);

/// What to type into a browser: IPv6 addresses in brackets, no wildcard, and the token, if it is not empty.
std::string addressText(std::string host, std::uint16_t port, bool secure, const std::string& token);

}  // namespace aeolic::stream
