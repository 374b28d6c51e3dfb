#include "stream/live/program_gateway.h"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/ip/host_name.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <chrono>

#include "stream/gateway/open_files.h"
#include "stream/gateway/serve.h"
#include "stream/token.h"

namespace aeolic::stream {

namespace asio = boost::asio;

namespace {

constexpr auto kTick = std::chrono::milliseconds(100);
constexpr auto kGoodbye = std::chrono::milliseconds(100);  // Viewers on this host have heard it by then.

}  // namespace

ProgramGateway::ProgramGateway(const Options& options)
    : hub_(options.hub, [this](const WireMessage& message) { jobLinks_.send(message); }),
      jobLinks_(io_, options.linksOnAllHosts ? "" : "127.0.0.1", 0, kSilenceLimit,
                {[this, ranks = options.ranks] { hub_.jobStarted(ranks); },
                 [this](const WireMessage& message) { hub_.jobSaid(message); },
                 [this](const std::optional<std::string>& why) {
                     hub_.jobEnded(why.value_or("the program has ended"));
                     hub_.jobGivenUp(why.value_or("the program has ended"));
                 }})
{
    WebServerOptions web;
    web.host = options.host;
    web.port = options.port;
    web.rules.token = options.token;
    web.rules.statusJson = [this] { return status(); };
    web.rules.names = {options.host, asio::ip::host_name()};
    web.rules.embedded = options.embedded;
    web.mostConnections = provideOpenFiles(options.ranks);
    server_ = std::make_unique<WebServer>(io_, std::move(web), hub_);
    address_ = addressText(options.host, server_->port(), false, options.token);
    const std::string secret = makeToken();
    links_.fingerprint = jobLinks_.expect(secret, options.ranks);
    links_.secret = secret;
    links_.hosts = jobLinks_.hosts();
    links_.port = jobLinks_.port();
    hub_.jobStarting();
    asio::co_spawn(io_, tick(), asio::detached);
    thread_ = std::thread([this] { io_.run(); });
}

ProgramGateway::~ProgramGateway()
{
    asio::post(io_, [this] {
        server_->stop();
        jobLinks_.hangUp();
    });
    std::this_thread::sleep_for(kGoodbye);
    io_.stop();
    thread_.join();
    hub_.dismissAll();
}

asio::awaitable<void> ProgramGateway::tick()
{
    for (;;) {
        hub_.tick();
        asio::steady_timer pause(io_, kTick);
        co_await pause.async_wait(asio::use_awaitable);
    }
}

std::string ProgramGateway::status() const
{
    return statusJson(hub_, jobLinks_.pids());
}

}  // namespace aeolic::stream
