#pragma once

#include <boost/asio/ip/host_name.hpp>
#include <boost/asio/post.hpp>
#include <chrono>
#include <string>
#include <thread>

#include "stream/gateway/open_files.h"
#include "stream/gateway/serve.h"
#include "stream/link/accept.h"
#include "stream/token.h"

namespace aeolic::stream {

/// The gateway of a program that draws itself, in a thread of this process. The program's ranks join it once. It starts
/// nothing, and where a rank goes, nothing comes back.
class ProgramGateway {
public:
    /// Opens the ports. `onOneHost`: no rank comes from another host. What `web` lacks is filled in: the status, the
    /// host's names and how many connections there may be. Throws InputError where a port cannot be had.
    ProgramGateway(Hub::Options hub, WebServerOptions web, int ranks, bool onOneHost)
        : hub_(std::move(hub), [this](const WireMessage& message) { jobLinks_.send(message); }),
          jobLinks_(
              io_, onOneHost ? "127.0.0.1" : "", 0, kSilenceLimit,
              {[this, ranks] { hub_.jobStarted(ranks); }, [this](const WireMessage& message) { hub_.jobSaid(message); },
               [this](const std::optional<std::string>& why) {
                   hub_.jobEnded(why.value_or("the program has ended"));
                   hub_.jobGivenUp(why.value_or("the program has ended"));
               }})
    {
        web.rules.statusJson = [this] { return statusJson(hub_, jobLinks_.pids()); };
        web.rules.names = {web.host, asio::ip::host_name()};
        web.mostConnections = provideOpenFiles(ranks);
        const std::string host = web.host, token = web.rules.token;
        server_ = std::make_unique<WebServer>(io_, std::move(web), hub_);
        address_ = addressText(host, server_->port(), false, token);
        links_.secret = makeToken();
        links_.fingerprint = jobLinks_.expect(links_.secret, ranks);
        links_.hosts = jobLinks_.hosts();
        links_.port = jobLinks_.port();
        hub_.jobStarting();
        asio::co_spawn(io_, tick(), asio::detached);
        thread_ = std::thread([this] { io_.run(); });
    }
    /// Tells viewers that the server stops, and waits for its thread: a tenth of a second.
    ~ProgramGateway()
    {
        asio::post(io_, [this] {
            server_->stop();
            jobLinks_.hangUp();
        });
        std::this_thread::sleep_for(std::chrono::milliseconds(100));  // Viewers on this host have heard it by then.
        io_.stop();
        thread_.join();
        hub_.dismissAll();
    }
    ProgramGateway(const ProgramGateway&) = delete;
    ProgramGateway& operator=(const ProgramGateway&) = delete;

    const std::string& address() const { return address_; }       ///< For browsers.
    const GatewayAddress& linkAddress() const { return links_; }  ///< For ranks.

private:
    asio::awaitable<void> tick()
    {
        for (;;) {
            hub_.tick();
            co_await pauseFor(std::chrono::milliseconds(100));
        }
    }

    Hub hub_;
    asio::io_context io_{1};  ///< Sessions end with it, and leave the hub then.
    JobLinks jobLinks_;
    std::unique_ptr<WebServer> server_;
    std::string address_;
    GatewayAddress links_;
    std::thread thread_;
};

}  // namespace aeolic::stream
