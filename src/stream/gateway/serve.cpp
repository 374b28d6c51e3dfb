#include "stream/gateway/serve.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <signal.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/host_name.hpp>
#include <boost/asio/signal_set.hpp>

#include "aeolic/error.h"
#include "description/scene_json.h"
#include "stream/gateway/open_files.h"

namespace aeolic::stream {
namespace {

namespace asio = boost::asio;

JobOptions jobOptions(const ServeOptions& options)
{
    JobOptions job = options.job;
    boost::system::error_code notAnAddress;
    if (!options.launcher.empty() || !options.jobHost.empty()) {
        const auto link = asio::ip::make_address(options.jobHost, notAnAddress);
        const bool all = !notAnAddress && link.is_unspecified();
        job.linkHost = all ? "" : options.jobHost;
    }
    job.told.directBytes = options.hub.frameBytes / std::uint64_t(std::max(1, job.ranks));
    const auto address = asio::ip::make_address(options.web.host, notAnAddress);
    const bool loopback = notAnAddress ? options.web.host == "localhost" : address.is_loopback();
    job.told.everywhere = !options.launcher.empty() || !loopback;
    if (!options.launcher.empty() || job.ranks > 1)
        job.words = launcherWords(options.launcher.empty() ? "mpirun -n {ranks}" : options.launcher, job.ranks);
    job.words.insert(job.words.end(), {options.program, "render-job"});
    return job;
}

/// Each Draw holds the scene's options and names.
void requireShort(const SceneDescription& scene)
{
    constexpr std::size_t most = 32 << 10;
    const std::size_t bytes = sceneToJson(scene).size();
    if (bytes > most)
        throw InputError("scene", "found " + std::to_string(bytes >> 10) + " KiB of names and options",
                         "at most " + std::to_string(most >> 10) + " KiB");
}

/// Tiles of many sizes come and go for days. By default the C library learns from each large one that is freed to take
/// the next from the heap, where small blocks that stay keep it from being given back. Tiles of their own are.
void keepTilesOutOfTheHeap()
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 128 << 10);
    mallopt(M_TRIM_THRESHOLD, 256 << 10);
#endif
}

/// Nobody is told of anything any more when the server ends.
struct Dismissal {
    Hub& hub;
    ~Dismissal() { hub.dismissAll(); }
};

}  // namespace

std::string statusJson(const Hub& hub, const std::vector<int>& pids)
{
    const HubStatus status = hub.status();
    return Json{{"state", status.state},   {"ranks", status.ranks},       {"viewers", status.viewers},
                {"frames", status.frames}, {"restarts", status.restarts}, {"pids", pids}}
               .dump() +
           "\n";
}

std::string addressText(std::string host, std::uint16_t port, bool secure, const std::string& token)
{
    boost::system::error_code notAnAddress;
    const auto address = asio::ip::make_address(host, notAnAddress);
    if (!notAnAddress && address.is_unspecified())
        host = asio::ip::host_name();
    else if (!notAnAddress && address.is_v6())
        host = "[" + host + "]";
    return (secure ? "https://" : "http://") + host + ":" + std::to_string(port) + "/" +
           (token.empty() ? "" : "?token=" + token);
}

void serve(const ServeOptions& options)
{
    keepTilesOutOfTheHeap();
    requireShort(options.hub.scene);
    Supervisor* job = nullptr;
    Hub hub(options.hub, [&](const WireMessage& message) { job->send(message); });
    asio::io_context io(1);  // Sessions end with it, and leave the hub then: the hub outlives it.
    std::unique_ptr<Supervisor> supervisor;
    const Dismissal dismissal{hub};
    WebServerOptions web = options.web;
    if (!options.certificate.empty()) web.tls = makeTlsContext(options.certificate, options.key);
    web.rules.secure = web.tls != nullptr;
    web.rules.statusJson = [&] { return statusJson(hub, supervisor->pids()); };
    web.rules.names = {web.host, asio::ip::host_name()};
    web.rules.direct = options.job.told.direct;
    web.mostConnections = provideOpenFiles(options.job.ranks);
    const JobOptions toStart = jobOptions(options);  // Read before the port is opened, because it may be wrong.
    WebServer server(io, std::move(web), hub);
    const auto stop = [&] {
        server.stop();
        supervisor->stop([&] { io.stop(); });
    };
    supervisor = std::make_unique<Supervisor>(io, toStart, hub, stop);
    job = supervisor.get();
    asio::signal_set signals(io, SIGINT, SIGTERM);
    struct sigaction hangUp {};  // Of a terminal that is closed. Under nohup it is ignored.
    if (sigaction(SIGHUP, nullptr, &hangUp) == 0 && hangUp.sa_handler != SIG_IGN) signals.add(SIGHUP);
    signals.async_wait([&](const boost::system::error_code& cancelled, int) {
        if (cancelled) return;
        stop();
        signals.clear();  // A second signal ends this process as it would end any other.
    });
    options.ready(addressText(options.web.host, server.port(), !options.certificate.empty(),
                              options.web.rules.token));  // Whoever knows the address may end the server at once.
    io.run();
    supervisor->rethrowFailure();
    if (hub.sceneError()) throw InputError(*hub.sceneError());
}

}  // namespace aeolic::stream
