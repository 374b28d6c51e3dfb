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
    struct Options {
        Hub::Options hub;
        std::string host = "127.0.0.1";
        std::uint16_t port = 0;        ///< 0: any that is free.
        std::string token;             ///< Not empty.
        bool embedded = false;         ///< Pages of this host may hold the page in a frame.
        bool linksOnAllHosts = false;  ///< Ranks come from other hosts, too.
        int ranks = 1;
    };
    /// Opens the ports. Throws InputError where one cannot be had.
    explicit ProgramGateway(const Options& options);
    /// Tells viewers that the server stops, and waits for its thread: a tenth of a second.
    ~ProgramGateway();
    ProgramGateway(const ProgramGateway&) = delete;
    ProgramGateway& operator=(const ProgramGateway&) = delete;

    const std::string& address() const { return address_; }       ///< For browsers.
    const GatewayAddress& linkAddress() const { return links_; }  ///< For ranks.

private:
    boost::asio::awaitable<void> tick();
    std::string status() const;

    Hub hub_;
    boost::asio::io_context io_{1};  ///< Sessions end with it, and leave the hub then.
    JobLinks jobLinks_;
    std::unique_ptr<WebServer> server_;
    std::string address_;
    GatewayAddress links_;
    std::thread thread_;
};

}  // namespace aeolic::stream
