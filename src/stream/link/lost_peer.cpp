#include "stream/link/lost_peer.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>

namespace aeolic::stream {

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
