#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stream/http_request.h"

namespace aeolic::stream {

/// What a server goes by when it answers a request.
struct HttpRules {
    std::string token;  ///< Empty: no token is asked for.
    bool secure = false;
    std::string cookieName;
    std::function<std::string()> statusJson;
    std::vector<std::string> names =
        {};  ///< This host's names, for servers without a token. Addresses and localhost are always taken.
};

/// Whether a request brings the token: in its query, as a bearer, or as the cookie. A server without a token asks
/// whether the request calls this host by one of its own names: somebody else's page may have had its name pointed here
/// (DNS rebinding).
bool mayEnter(const HttpRequest& request, const HttpRules& rules);

/// Whether a request comes from the server's own page, or from a program (which sends no Origin).
bool isOwnOrigin(const HttpRequest& request, const HttpRules& rules);

/// The answer to anything but a WebSocket. Without the right token: 401 and nothing else.
HttpResponse answer(const HttpRequest& request, const HttpRules& rules);

}  // namespace aeolic::stream
