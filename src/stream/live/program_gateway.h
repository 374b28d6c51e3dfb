#pragma once

#include <boost/asio/io_context.hpp>
#include <string>
#include <thread>

#include "stream/gateway/hub/hub.h"
#include "stream/gateway/job_links.h"
#include "stream/gateway/web_server.h"
#include "stream/gateway_address.h"

namespace aeolic::stream {

/// The gateway of a program that draws itself, in a thread of this process. The program's ranks join it once. It starts
/// nothing, and where a rank goes, nothing comes back.
class ProgramGateway {
public:
    /// Opens the ports. `onOneHost`: no rank comes from another host. `web` lacks what only this class knows. Throws
    /// InputError where a port cannot be had.
    ProgramGateway(Hub::Options hub, WebServerOptions web, int ranks, bool onOneHost);
    /// Tells viewers that the server stops, and waits for its thread: a tenth of a second.
    ~ProgramGateway();
    ProgramGateway(const ProgramGateway&) = delete;
    ProgramGateway& operator=(const ProgramGateway&) = delete;

    const std::string& address() const { return address_; }       ///< For browsers.
    const GatewayAddress& linkAddress() const { return links_; }  ///< For ranks.

private:
    boost::asio::awaitable<void> tick();

    Hub hub_;
    boost::asio::io_context io_{1};  ///< Sessions end with it, and leave the hub then.
    JobLinks jobLinks_;
    std::unique_ptr<WebServer> server_;
    std::string address_;
    GatewayAddress links_;
    std::thread thread_;
};

}  // namespace aeolic::stream
