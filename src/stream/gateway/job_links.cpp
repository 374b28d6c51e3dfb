#include "stream/gateway/job_links.h"

#include <fmt/format.h>

#include <boost/asio/ip/host_name.hpp>

#include "aeolic/error.h"
#include "stream/link/accept.h"
#include "stream/link/link_greeting.h"
#include "stream/listen.h"

namespace aeolic::stream {
namespace {

constexpr auto kGreetingTime = std::chrono::seconds(5);
constexpr std::size_t kMostStrangers = 64;  // So many may wait besides the ranks.

Tcp::acceptor listenForRanks(asio::io_context& io, const std::string& host, std::uint16_t port)
{
    try {
        return listenOn(io, host, {port, port});
    } catch (const boost::system::system_error& error) {
        throw InputError(
            port == 0 ? "--job-host" : "--job-port",
            (host.empty() ? "port " : host + ", port ") + std::to_string(port) + " (" + error.code().message() + ")",
            "an address of this host and a free port of it");
    }
}

}  // namespace

/// One rank's connection.
struct JobLinks::Link : std::enable_shared_from_this<Link> {
    LinkSocket socket;
    std::deque<WireMessage> queue;
    bool writing = false, closed = false;
    int rank = -1, pid = 0;
    std::string host;
    DirectPlace direct;

    explicit Link(Tcp::socket&& theSocket) : socket(std::move(theSocket)) {}

    void send(const WireMessage& message)
    {
        queue.push_back(message);
        if (!std::exchange(writing, true))
            asio::co_spawn(socket.tcp().get_executor(), writeAll(shared_from_this()), asio::detached);
    }
    void close()
    {
        closed = true;
        socket.close();
    }
    static asio::awaitable<void> writeAll(std::shared_ptr<Link> self)
    {
        try {
            while (!self->closed && !self->queue.empty()) {
                const WireMessage message = self->queue.front();
                co_await self->socket.write(*message);
                self->queue.pop_front();
            }
            self->writing = false;
        } catch (const std::exception&) {  // The reader ends, too, and reports it.
        }
    }
};

JobLinks::JobLinks(asio::io_context& io, const std::string& host, std::uint16_t port, std::chrono::seconds silenceLimit,
                   Events events)
    : io_(io),
      acceptor_(std::make_shared<Tcp::acceptor>(listenForRanks(io, host, port))),
      silenceLimit_(silenceLimit),
      events_(std::move(events))
{
    hosts_.push_back(host.empty() ? asio::ip::host_name() : host);
    if (host.empty()) hosts_.emplace_back("127.0.0.1");
    asio::co_spawn(io_, acceptAll(acceptor_, silenceLimit_, [this](Tcp::socket socket) { take(std::move(socket)); }),
                   asio::detached);
    asio::co_spawn(io_, pingAll(), asio::detached);
}

JobLinks::~JobLinks()
{
    *alive_ = false;
    hangUp();
    boost::system::error_code ignored;
    acceptor_->close(ignored);
}

std::uint16_t JobLinks::port() const
{
    return acceptor_->local_endpoint().port();
}

std::string JobLinks::expect(const std::string& secret, int ranks)
{
    hangUp();
    std::string fingerprint;
    const bool leavesHost = !plainAddress(acceptor_->local_endpoint().address()).is_loopback();
    tls_ = leavesHost ? makeTlsServer(fingerprint) : nullptr;
    secret_ = secret;
    ranks_ = ranks;
    return fingerprint;
}

void JobLinks::hangUp()
{
    secret_.clear();
    for (const auto& [rank, link] : links_) link->close();
    links_.clear();
    for (const auto& waiting : waiting_)
        if (const auto link = waiting.lock()) link->close();
    waiting_.clear();
}

void JobLinks::send(const WireMessage& message)
{
    for (const auto& [rank, link] : links_) link->send(message);
}

std::vector<int> JobLinks::pids() const
{
    std::vector<int> pids;
    for (const auto& [rank, link] : links_) pids.push_back(link->pid);
    return pids;
}

std::vector<DirectPlace> JobLinks::directPlaces() const
{
    std::vector<DirectPlace> places;
    for (const auto& [rank, link] : links_)
        if (link->direct.port != 0) places.push_back(link->direct);
    return places;
}

/// Whoever has waited longest leaves where too many wait. A rank that is crowded out tries again.
void JobLinks::take(Tcp::socket socket)
{
    std::erase_if(waiting_, [](const std::weak_ptr<Link>& waiting) {
        const auto link = waiting.lock();
        return !link || link->closed || link->rank >= 0;
    });
    while (waiting_.size() >= kMostStrangers + std::size_t(ranks_)) {
        if (const auto link = waiting_.front().lock()) link->close();
        waiting_.pop_front();
    }
    const auto link = std::make_shared<Link>(std::move(socket));
    waiting_.push_back(link);
    asio::co_spawn(io_, serve(link), asio::detached);
}

/// What the other end says about itself, once it has shown that it is a rank of the job that is expected.
asio::awaitable<Json> JobLinks::greet(std::shared_ptr<Link> link)
{
    if (secret_.empty()) throw ProtocolError("no job is expected");
    const std::string secret = secret_;  // This object may be gone when the other end answers.
    if (tls_) co_await link->socket.startTls(tls_, true);
    Json about = co_await greetRank(link->socket, secret);
    co_return about;
}

/// Throws where the job has such a rank already, or is another by now.
void JobLinks::admit(const std::shared_ptr<Link>& link, const Json& about)
{
    const int rank = about.value("rank", -1);
    if (link->closed || rank < 0 || rank >= ranks_ || links_.count(rank) || about.value("ranks", 0) != ranks_)
        throw ProtocolError("not a rank of this job");
    link->rank = rank;
    link->pid = about.value("pid", 0);
    link->host = about.value("host", "");
    if (about.contains("direct") && about["direct"].is_number_unsigned()) {
        link->direct.port = about["direct"].get<std::uint16_t>();
        const auto address = plainAddress(link->socket.tcp().remote_endpoint().address());
        if (address != plainAddress(link->socket.tcp().local_endpoint().address()))
            link->direct.host = address.to_string();
    }
    links_[rank] = link;
    if (int(links_.size()) == ranks_) events_.allJoined();
}

asio::awaitable<void> JobLinks::serve(std::shared_ptr<Link> link)
{
    const auto alive = alive_;
    std::optional<std::string> why;
    try {
        asio::steady_timer limit(io_, kGreetingTime);
        limit.async_wait([weak = std::weak_ptr(link)](const boost::system::error_code& cancelled) {
            const auto late = cancelled ? nullptr : weak.lock();
            if (late && late->rank < 0) late->close();
        });
        const Json about = co_await greet(link);
        limit.cancel();
        if (!*alive) co_return;
        admit(link, about);
        while (!link->closed) {
            const WireMessage message = co_await link->socket.readMessage(Sender::rank);
            if (!*alive || link->closed) co_return;
            const bool isPong = MessageType((*message)[2]) == MessageType::pong;
            if (!isPong) events_.said(message);
        }
    } catch (const ProtocolError& error) {
        why = std::string("a rank sent what it should not: ") + error.what();
    } catch (const std::exception&) {
    }
    if (!*alive || link->rank < 0 || link->closed) {
        link->close();
        co_return;
    }
    breakOff(why);
}

asio::awaitable<void> JobLinks::pingAll()
{
    const auto alive = alive_;
    const auto interval = std::chrono::milliseconds(silenceLimit_) / 4;
    auto last = SteadyClock::now();
    for (;;) {
        co_await pauseFor(interval);
        if (!*alive) co_return;
        const auto now = SteadyClock::now();
        ping(now, now - last < 2 * interval);
        last = now;
    }
}

/// Where this process itself was stopped for a while, the ranks' silence is no fault of theirs.
void JobLinks::ping(SteadyClock::time_point now, bool wasAwake)
{
    std::optional<std::string> why;
    for (const auto& [rank, link] : links_) {
        if (!wasAwake) link->socket.heardAt(now);
        if (now - link->socket.heard() > silenceLimit_)
            why = fmt::format("rank {} on {} has not answered for {} s", rank, link->host, silenceLimit_.count());
        if (link->queue.empty()) link->send(emptyMessage(MessageType::ping));
    }
    if (why) breakOff(why);
}

void JobLinks::breakOff(const std::optional<std::string>& why)
{
    hangUp();
    events_.broken(why);
}

}  // namespace aeolic::stream
