#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "stream/gateway/sessions.h"
#include "stream/http_request.h"

namespace aeolic::stream {

/// What a server goes by when it answers a request.
struct HttpRules {
    std::string token;  ///< Empty: no token is asked for.
    bool secure = false;
    std::string cookieName;
    std::function<std::string()> statusJson;
    std::vector<std::string> names =
        {};               ///< This host's names, for servers without a token. Addresses and localhost are always taken.
    bool direct = false;  ///< The page connects to ranks, whose hosts are not known before.
    bool embedded = false;  ///< Pages of this host, on any port, may hold the page in a frame.
    std::shared_ptr<Sessions> sessions = std::make_shared<Sessions>();
};

/// Whether a request brings the token in its query or as a bearer, or a session's id in the cookie. A server without a
/// token asks whether the request calls this host by one of its own names: somebody else's page may have had its name
/// pointed here (DNS rebinding).
bool mayEnter(const HttpRequest& request, const HttpRules& rules);

/// Whether a request goes by a token, right or wrong, and by no session. Whoever guesses tokens makes such requests.
bool goesByToken(const HttpRequest& request, const HttpRules& rules);

/// Whether a request comes from the server's own page, or from a program (which sends no Origin).
bool isOwnOrigin(const HttpRequest& request, const HttpRules& rules);

/// The answer to anything but a WebSocket. Without the right token: 401, with a page of words where a person sees it. A
/// page that is asked for with
/// the token opens a session, and is asked for again without the token.
HttpResponse answer(const HttpRequest& request, const HttpRules& rules);

}  // namespace aeolic::stream
