#include "stream/link/accept.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>

namespace aeolic::stream {

asio::awaitable<void> pauseFor(std::chrono::steady_clock::duration time)
{
    const asio::any_io_executor executor = co_await asio::this_coro::executor;
    asio::steady_timer timer(executor, time);
    co_await timer.async_wait(asio::use_awaitable);
}

asio::awaitable<void> acceptAll(std::shared_ptr<Tcp::acceptor> acceptor, std::chrono::seconds lostAfter,
                                std::function<void(Tcp::socket)> take)
{
    while (acceptor->is_open()) {
        boost::system::error_code error;
        Tcp::socket socket = co_await acceptor->async_accept(asio::redirect_error(asio::use_awaitable, error));
        if (!acceptor->is_open()) co_return;
        if (error) {  // Perhaps too many files are open: waits instead of spinning.
            co_await pauseFor(std::chrono::milliseconds(100));
            continue;
        }
        socket.set_option(Tcp::no_delay(true), error);
        noticeLostPeer(socket.native_handle(), lostAfter);
        take(std::move(socket));
    }
}

void noticeLostPeer(int socket, std::chrono::seconds limit)
{
    constexpr int kProbes = 3;
    const auto set = [&](int level, int name, int value) { setsockopt(socket, level, name, &value, sizeof value); };
    const int seconds = std::max(1, int(limit.count())), between = std::max(1, seconds / (kProbes + 1));
    set(SOL_SOCKET, SO_KEEPALIVE, 1);
    set(IPPROTO_TCP, TCP_KEEPIDLE, between);
    set(IPPROTO_TCP, TCP_KEEPINTVL, between);
    set(IPPROTO_TCP, TCP_KEEPCNT, kProbes);
    set(IPPROTO_TCP, TCP_USER_TIMEOUT, 1000 * seconds);
}

}  // namespace aeolic::stream
