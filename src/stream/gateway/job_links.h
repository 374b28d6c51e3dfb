#pragma once

#include <utility>  // Boost 1.74 forgets it.

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stream/gateway/hub/viewer.h"
#include "stream/link/link_tls.h"
#include "stream/message.h"

namespace aeolic::stream {

/// The port that ranks connect to, and the links of the job that runs. Runs on the one thread of `io`.
class JobLinks {
public:
    struct Events {
        std::function<void()> allJoined;
        std::function<void(const WireMessage&)> said;  ///< Any rank's message. A ProtocolError it throws ends the link.
        /// A link has ended: why, or nothing where the rank has just gone. Called once a job.
        std::function<void(const std::optional<std::string>&)> broken;
    };

    /// Listens for ranks on this address of the host, or, if `host` is empty, on all of them; on a free port, if `port`
    /// is 0. What leaves the host is encrypted. Each link is pinged four times within `silenceLimit`, and breaks where
    /// nothing has come from the rank for so long. Throws InputError where address or port cannot be had.
    JobLinks(boost::asio::io_context& io, const std::string& host, std::uint16_t port,
             std::chrono::seconds silenceLimit, Events events);
    ~JobLinks();

    std::uint16_t port() const;
    /// The names under which ranks look for this host.
    const std::vector<std::string>& hosts() const { return hosts_; }

    /// Expects a new job. Closes the links of the job before, and refuses ranks that do not know this secret. Returns
    /// the fingerprint of the certificate that is new for each job; empty where the links are not encrypted.
    std::string expect(const std::string& secret, int ranks);
    /// Closes all links, and refuses further ones.
    void hangUp();
    /// Sends to every rank.
    void send(const WireMessage& message);
    std::vector<int> pids() const;  ///< By rank.
    /// Where viewers can connect to the ranks themselves, in order of rank; empty where they cannot.
    std::vector<DirectPlace> directPlaces() const;

private:
    struct Link;
    void take(boost::asio::ip::tcp::socket socket);
    boost::asio::awaitable<void> serve(std::shared_ptr<Link> link);
    boost::asio::awaitable<Json> greet(std::shared_ptr<Link> link);
    void admit(const std::shared_ptr<Link>& link, const Json& about);
    boost::asio::awaitable<void> pingAll();
    void ping(SteadyClock::time_point now, bool wasAwake);
    void breakOff(const std::optional<std::string>& why);

    boost::asio::io_context& io_;
    std::shared_ptr<boost::asio::ip::tcp::acceptor> acceptor_;
    std::chrono::seconds silenceLimit_;
    Events events_;
    std::vector<std::string> hosts_;
    std::string secret_;
    TlsSide tls_;
    int ranks_ = 0;
    std::deque<std::weak_ptr<Link>> waiting_;  ///< Not known to be ranks yet; the oldest first.
    std::map<int, std::shared_ptr<Link>> links_;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace aeolic::stream
