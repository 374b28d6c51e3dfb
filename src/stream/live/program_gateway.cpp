#include "stream/live/program_gateway.h"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/ip/host_name.hpp>
#include <boost/asio/post.hpp>
#include <chrono>

#include "stream/gateway/open_files.h"
#include "stream/gateway/serve.h"
#include "stream/link/accept.h"
#include "stream/token.h"

namespace aeolic::stream {

namespace asio = boost::asio;

namespace {

constexpr auto kTick = std::chrono::milliseconds(100);
constexpr auto kGoodbye = std::chrono::milliseconds(100);  // Viewers on this host have heard it by then.

}  // namespace

ProgramGateway::ProgramGateway(Hub::Options hub, WebServerOptions web, int ranks, bool onOneHost)
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
    const std::string secret = makeToken();
    links_.fingerprint = jobLinks_.expect(secret, ranks);
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
        co_await pauseFor(kTick);
    }
}

}  // namespace aeolic::stream
