#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stream/http_request.h"

namespace aeolic::stream {

/// What a server answers with, whoever asks.
struct HttpRules {
    std::string token;  ///< Empty: none is asked for.
    bool secure = false;
    std::string cookieName;
    std::function<std::string()> statusJson;
    std::vector<std::string> names =
        {};  ///< Of this host, for servers without a token; addresses and localhost always are.
};

/// Whether a request brings the token: in its query, as a bearer, or as the cookie. Where there is none, whether it
/// calls this host by a name of its own: a page of elsewhere may have had its name pointed here (DNS rebinding).
bool mayEnter(const HttpRequest& request, const HttpRules& rules);

/// Whether a request comes from the server's own page, or from a program (which sends no Origin).
bool isOwnOrigin(const HttpRequest& request, const HttpRules& rules);

/// The answer to anything but a WebSocket. Without the right token: 401 and nothing else.
HttpResponse answer(const HttpRequest& request, const HttpRules& rules);

}  // namespace aeolic::stream
