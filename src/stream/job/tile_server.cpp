#include "stream/job/tile_server.h"

#include <atomic>
#include <boost/asio/post.hpp>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "stream/link/accept.h"
#include "stream/outgoing.h"
#include "stream/web_connection.h"

namespace aeolic::stream {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kRequestTime{5000}, kLookAgain{50};
constexpr int kMostFrames = 2;  // The gateway lets a viewer be as many frames behind.
constexpr int kMostConnections = 256;

struct Connection : std::enable_shared_from_this<Connection> {
    WebConnection socket;
    std::mutex mutex;  // Guards the queue. Everything else belongs to the server's thread.
    Outgoing queue;
    bool writing = false;

    explicit Connection(WebConnection&& theSocket) : socket(std::move(theSocket)) {}

    /// False where the viewer reads too slowly. Any thread may call this.
    bool send(std::uint32_t frame, const WireMessage& message)
    {
        const std::lock_guard lock(mutex);
        if (!queue.has(frame) && queue.frames() >= kMostFrames) return false;
        queue.push(message);
        if (!std::exchange(writing, true))
            asio::post(socket.executor(), [self = shared_from_this()] {
                asio::co_spawn(self->socket.executor(), writeAll(self), asio::detached);
            });
        return true;
    }
    static asio::awaitable<void> writeAll(std::shared_ptr<Connection> self)
    {
        while (const WireMessage message = self->next()) {
            const WebConnection::Error error = co_await self->socket.write(message);
            if (error) co_return self->socket.drop();
            const std::lock_guard lock(self->mutex);
            self->queue.pop();
        }
    }
    /// The message to write next, or null.
    WireMessage next()
    {
        const std::lock_guard lock(mutex);
        writing = !queue.empty();
        return writing ? queue.front() : nullptr;
    }
};

struct Invitation {
    std::uint32_t viewer;
    std::string token;
    Clock::time_point until;
};

}  // namespace

struct TileServer::State {
    asio::io_context io{1};
    std::shared_ptr<Tcp::acceptor> acceptor;
    std::mutex mutex;
    std::vector<Invitation> invitations;
    std::map<std::uint32_t, std::shared_ptr<Connection>> connections;
    const TileLimits limits;
    /// What all tiles take that somebody still holds. They may be freed after this object.
    const std::shared_ptr<std::atomic<std::uint64_t>> bytes = std::make_shared<std::atomic<std::uint64_t>>(0);
    int open = 0;
    std::thread thread;

    State(bool everywhere, PortRange ports, const TileLimits& theLimits)
        : acceptor(std::make_shared<Tcp::acceptor>(listenOn(io, everywhere ? "" : "127.0.0.1", ports))),
          limits(theLimits)
    {
        const auto take = [this](Tcp::socket socket) {
            asio::co_spawn(io, serve(WebConnection(std::move(socket), nullptr)), asio::detached);
        };
        asio::co_spawn(io, acceptAll(acceptor, kWriteLimit, take), asio::detached);
        asio::co_spawn(io, forgetInvitations(), asio::detached);
        thread = std::thread([this] { io.run(); });
    }
    ~State()
    {
        io.stop();
        thread.join();
    }

    /// Viewers that never come must not fill the memory, even where nobody else comes either.
    asio::awaitable<void> forgetInvitations()
    {
        for (;;) {
            co_await pauseFor(limits.invitationTime);
            const std::lock_guard lock(mutex);
            forgetOld();
        }
    }
    /// The same bytes, which count as long as anybody holds them; null where there is no room for them.
    WireMessage counted(const WireMessage& tile) const
    {
        if (*bytes + tile->size() > limits.bytes) return nullptr;
        *bytes += tile->size();
        return {tile.get(), [tile, all = bytes](const ByteVector*) { *all -= tile->size(); }};
    }
    void forgetOld()
    {
        std::erase_if(invitations, [](const Invitation& one) { return one.until < Clock::now(); });
    }

// GCC 12 with the sanitizers looks into Boost's allocation of this coroutine's memory, but not into its return.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
    asio::awaitable<void> serve(WebConnection connection)
    {
        if (open >= kMostConnections) co_return;
        ++open;
        try {
            connection.expiresAfter(kRequestTime);
            const HttpRequest request = co_await connection.readRequest(8 * 1024, 0);
            const bool forTiles = asksForWebSocket(request) && pathOf(request) == "/tiles";
            std::optional<std::uint32_t> viewer;
            // The viewer may come before the gateway has told this rank of it.
            for (auto left = kRequestTime; forTiles && left > kLookAgain; left -= kLookAgain) {
                viewer = takeInvitation(request);
                if (viewer) break;
                co_await pauseFor(kLookAgain);
            }
            if (viewer) {
                co_await stay(*viewer, std::make_shared<Connection>(std::move(connection)), request);
            } else {
                const HttpResponse refusal = emptyAnswer(request, boost::beast::http::status::unauthorized);
                co_await connection.writeAnswer(refusal);
            }
        } catch (const std::exception&) {  // The client has hung up, or what it sent is not HTTP.
        }
        --open;
    }
#pragma GCC diagnostic pop

    /// The viewer whose token the request brings. A token works once.
    std::optional<std::uint32_t> takeInvitation(const HttpRequest& request)
    {
        const std::lock_guard lock(mutex);
        forgetOld();
        for (auto one = invitations.begin(); one != invitations.end(); ++one) {
            if (!bringsToken(request, one->token)) continue;
            const std::uint32_t viewer = one->viewer;
            invitations.erase(one);
            return viewer;
        }
        return std::nullopt;
    }

    /// Lasts until the viewer leaves. Viewers have nothing to say here, so any message ends the connection.
    asio::awaitable<void> stay(std::uint32_t viewer, std::shared_ptr<Connection> connection, HttpRequest request)
    {
        const WebConnection::Error refused = co_await connection->socket.acceptWebSocket(std::move(request), 16);
        if (refused) co_return;
        {
            const std::lock_guard lock(mutex);
            connections[viewer] = connection;
        }
        ByteVector nothing;
        co_await connection->socket.read(nothing);
        const std::lock_guard lock(mutex);
        const auto mine = connections.find(viewer);
        if (mine != connections.end() && mine->second == connection) connections.erase(mine);
        connection->socket.drop();
    }
};

TileServer::TileServer(bool everywhere, PortRange ports, const TileLimits& limits)
{
    try {
        state_ = std::make_unique<State>(everywhere, ports, limits);
    } catch (const boost::system::system_error& error) {
        throw std::runtime_error("no port of " + std::to_string(ports.first) + "-" + std::to_string(ports.last) +
                                 " is free for viewers (--direct-ports): " + error.code().message());
    }
}
TileServer::~TileServer() = default;

std::uint16_t TileServer::port() const
{
    return state_->acceptor->local_endpoint().port();
}

void TileServer::invite(std::uint32_t viewer, const std::string& token)
{
    const std::lock_guard lock(state_->mutex);
    state_->invitations.push_back({viewer, token, Clock::now() + state_->limits.invitationTime});
}

std::size_t TileServer::invitations() const
{
    const std::lock_guard lock(state_->mutex);
    return state_->invitations.size();
}

bool TileServer::send(std::uint32_t viewer, const WireMessage& tile)
{
    const std::lock_guard lock(state_->mutex);
    const auto found = state_->connections.find(viewer);
    if (found == state_->connections.end()) return false;
    const WireMessage kept = state_->counted(tile);
    return kept && found->second->send(*frameOf(*tile), kept);
}

}  // namespace aeolic::stream
