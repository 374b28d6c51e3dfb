// aeolic-reader: reads files of data for another process, which starts it with a socket as descriptor 3. A fault of a
// library, or a file made to provoke one, ends this process alone.

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <thread>

#include "reader/file_server.h"

namespace {

constexpr int kSocket = 3;

void limitItself()
{
    const auto limit = [](auto what, rlim_t most) {
        rlimit now{};
        getrlimit(what, &now);
        now.rlim_cur = std::min(most, now.rlim_max);
        setrlimit(what, &now);
    };
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_NOFILE, RLIM_INFINITY);  // Each large array is a file.
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
}

/// While a library computes nobody looks at the socket. A caller that has gone wants no answer.
void endWithCaller()
{
    std::thread([] {
        pollfd wait{kSocket, 0, 0};
        while (poll(&wait, 1, -1) < 0 || (wait.revents & (POLLHUP | POLLERR | POLLNVAL)) == 0) {
        }
        _exit(0);
    }).detach();
}

}  // namespace

int main()
{
    int type = 0;
    socklen_t size = sizeof type;
    if (getsockopt(kSocket, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_SEQPACKET) {
        std::fputs("aeolic-reader: it is started by Aeolic's library, and does nothing by itself\n", stderr);
        return 2;
    }
    limitItself();
    endWithCaller();
    const aeolic::PacketSocket caller{aeolic::OwnedFile(kSocket)};
    aeolic::FileServer(caller).serve();
    _exit(0);  // Nothing is left to be tidied up.
}
