#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "stream/gateway/hub/hub.h"
#include "stream/gateway/job_links.h"
#include "stream/gateway/job_process.h"
#include "stream/gateway/restarts.h"
#include "stream/gateway_address.h"

namespace aeolic::stream {

struct JobOptions {
    std::vector<std::string> words;  ///< The command that starts the job.
    int ranks = 1;
    std::string linkHost = "127.0.0.1";  ///< Where the ranks connect to; empty: all addresses of this host.
    std::uint16_t linkPort = 0;          ///< 0: any that is free.
    /// What ranks are told. Each start fills in where this gateway is, and how both know each other.
    GatewayAddress told;
};

/// Keeps the render job running: starts it, waits for its ranks, and when it dies starts it again, as Restarts says.
/// Where that gives up it waits for a viewer to ask for another start.
class Supervisor {
public:
    /// `hopeless` is called once if not even the first scene can be loaded (Hub::sceneError()). The job has ended then
    /// and is not started again.
    Supervisor(boost::asio::io_context& io, JobOptions options, Hub& hub, std::function<void()> hopeless);

    /// Ends the job: asks first, then uses force. Takes a few seconds at most, and calls `done` then.
    void stop(std::function<void()> done);

    /// Throws what ended the supervision, if anything did.
    void rethrowFailure() const;

    void send(const WireMessage& message) { links_.send(message); }
    std::vector<int> pids() const { return links_.pids(); }

private:
    void take(const WireMessage& message);
    boost::asio::awaitable<void> run();
    boost::asio::awaitable<void> endProcess();
    boost::asio::awaitable<bool> processEndsWithin(std::chrono::milliseconds time);
    boost::asio::awaitable<void> joinsWithin(std::chrono::milliseconds time);
    boost::asio::awaitable<void> runOnce();
    boost::asio::awaitable<void> untilAskedForAStart();
    boost::asio::awaitable<void> sleep(std::chrono::milliseconds time);
    std::string whyItEnded();

    boost::asio::io_context& io_;
    JobOptions options_;
    Hub& hub_;
    JobLinks links_;
    boost::asio::steady_timer wake_;
    std::optional<JobProcess> process_;
    Restarts restarts_;
    std::string why_;  ///< How the job ended.
    bool joined_ = false, stopping_ = false;
    bool broken_ = false;                   ///< A link has ended.
    std::optional<std::string> whyBroken_;  ///< Where it was not the rank that ended it.
    std::exception_ptr failure_;
    std::function<void()> hopeless_, stopped_;
};

}  // namespace aeolic::stream
