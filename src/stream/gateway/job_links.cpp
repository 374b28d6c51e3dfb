#include "stream/gateway/job_links.h"

#include <fmt/format.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/ip/host_name.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <deque>

#include "stream/lost_peer.h"
#include "stream/requests.h"
#include "stream/token.h"

namespace aeolic::stream {

namespace asio = boost::asio;
using Tcp = asio::ip::tcp;

/// One rank's connection.
struct JobLinks::Link : std::enable_shared_from_this<Link> {
    Tcp::socket socket;
    std::deque<WireMessage> queue;
    bool writing = false, closed = false;
    int rank = -1, pid = 0;
    std::string host;
    SteadyClock::time_point heard = SteadyClock::now();  ///< When the last byte came.
    DirectPlace direct;

    explicit Link(Tcp::socket&& theSocket) : socket(std::move(theSocket)) {}

    void send(const WireMessage& message)
    {
        queue.push_back(message);
        if (!std::exchange(writing, true))
            asio::co_spawn(socket.get_executor(), writeAll(shared_from_this()), asio::detached);
    }
    void close()
    {
        closed = true;
        boost::system::error_code ignored;
        socket.shutdown(Tcp::socket::shutdown_both, ignored);
        socket.close(ignored);
    }
    static asio::awaitable<void> writeAll(std::shared_ptr<Link> self)
    {
        boost::system::error_code error;
        while (!error && !self->closed && !self->queue.empty()) {
            const WireMessage message = self->queue.front();
            co_await asio::async_write(self->socket, asio::buffer(*message),
                                       asio::redirect_error(asio::use_awaitable, error));
            self->queue.pop_front();
        }
        self->writing = false;  // After an error the reader ends, too, and reports it.
    }
};

JobLinks::JobLinks(asio::io_context& io, bool everywhere, std::chrono::seconds silenceLimit, Events events)
    : io_(io),
      acceptor_(io, Tcp::endpoint(everywhere ? asio::ip::address(asio::ip::address_v4::any())
                                             : asio::ip::address(asio::ip::address_v4::loopback()),
                                  0)),
      silenceLimit_(silenceLimit),
      events_(std::move(events))
{
    if (everywhere) hosts_.push_back(asio::ip::host_name());
    hosts_.emplace_back("127.0.0.1");
    asio::co_spawn(io_, acceptAll(), asio::detached);
    asio::co_spawn(io_, pingAll(), asio::detached);
}

JobLinks::~JobLinks()
{
    *alive_ = false;
    hangUp();
    boost::system::error_code ignored;
    acceptor_.close(ignored);
}

std::uint16_t JobLinks::port() const
{
    return acceptor_.local_endpoint().port();
}

void JobLinks::expect(const std::string& secret, int ranks)
{
    hangUp();
    secret_ = secret;
    ranks_ = ranks;
}

void JobLinks::hangUp()
{
    secret_.clear();
    for (const auto& [rank, link] : links_) link->close();
    links_.clear();
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

asio::awaitable<void> JobLinks::acceptAll()
{
    const auto alive = alive_;
    while (*alive) {
        boost::system::error_code error;
        Tcp::socket socket = co_await acceptor_.async_accept(asio::redirect_error(asio::use_awaitable, error));
        if (!*alive) co_return;
        if (error) {
            asio::steady_timer pause(io_, std::chrono::milliseconds(100));
            co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, error));
            continue;
        }
        socket.set_option(Tcp::no_delay(true), error);
        noticeLostPeer(socket.native_handle(), silenceLimit_);
        asio::co_spawn(io_, serve(std::make_shared<Link>(std::move(socket))), asio::detached);
    }
}

asio::awaitable<WireMessage> JobLinks::readMessage(Link& link)
{
    // A large message may take longer than the rank may be silent: every part of it counts as a word.
    const auto noted = [&link](const boost::system::error_code& error, std::size_t) -> std::size_t {
        link.heard = SteadyClock::now();
        return error ? 0 : std::size_t{1} << 16;
    };
    ByteVector bytes(kHeaderBytes);
    co_await asio::async_read(link.socket, asio::buffer(bytes), noted, asio::use_awaitable);
    MessageHeader header = parseHeader(bytes, Sender::rank);
    if ((link.rank < 0) != (header.type == MessageType::join)) throw ProtocolError("a message out of turn");
    bytes.resize(kHeaderBytes + header.payloadBytes);
    co_await asio::async_read(link.socket, asio::buffer(bytes.data() + kHeaderBytes, header.payloadBytes), noted,
                              asio::use_awaitable);
    co_return std::make_shared<const ByteVector>(std::move(bytes));
}

/// Lets in only ranks of the job that is expected.
void JobLinks::admit(const std::shared_ptr<Link>& link, const WireMessage& message)
{
    const Json join = parseJson(parseMessage(*message, Sender::rank).payload);
    const int rank = join.value("rank", -1);
    const bool welcome = !secret_.empty() && sameToken(join.value("secret", ""), secret_) && rank >= 0 &&
                         rank < ranks_ && !links_.count(rank) && join.value("ranks", 0) == ranks_;
    if (!welcome) throw ProtocolError("not a rank of this job");
    link->rank = rank;
    link->pid = join.value("pid", 0);
    link->host = join.value("host", "");
    if (join.contains("direct") && join["direct"].is_number_unsigned()) {
        link->direct.port = join["direct"].get<std::uint16_t>();
        const auto address = link->socket.remote_endpoint().address();
        if (address != link->socket.local_endpoint().address()) link->direct.host = address.to_string();
    }
    links_[rank] = link;
    if (int(links_.size()) == ranks_) events_.allJoined();
}

asio::awaitable<void> JobLinks::serve(std::shared_ptr<Link> link)
{
    const auto alive = alive_;
    std::optional<std::string> why;
    try {
        asio::steady_timer limit(io_, std::chrono::seconds(5));
        limit.async_wait([weak = std::weak_ptr(link)](const boost::system::error_code& cancelled) {
            const auto late = cancelled ? nullptr : weak.lock();
            if (late && late->rank < 0) late->close();
        });
        const WireMessage join = co_await readMessage(*link);
        limit.cancel();
        if (!*alive) co_return;
        admit(link, join);
        while (!link->closed) {
            const WireMessage message = co_await readMessage(*link);
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
    asio::steady_timer pause(io_);
    auto last = SteadyClock::now();
    for (;;) {
        boost::system::error_code ignored;
        pause.expires_after(interval);
        co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
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
        if (!wasAwake) link->heard = now;
        if (now - link->heard > silenceLimit_)
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
