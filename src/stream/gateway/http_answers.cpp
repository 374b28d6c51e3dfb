#include "stream/gateway/http_answers.h"

#include <algorithm>

#include "stream/gateway/web_assets.h"
#include "stream/token.h"

namespace aeolic::stream {
namespace {

namespace http = boost::beast::http;

// What the page may use: its own modules and styles, pictures it made itself, and connections. With --direct these go
// to the ranks' hosts.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; "
    "connect-src 'self' ws: wss:; worker-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

std::string_view cookieValue(std::string_view cookies, std::string_view name)
{
    while (!cookies.empty()) {
        std::string_view item = cookies.substr(0, cookies.find(';'));
        cookies.remove_prefix(std::min(cookies.size(), item.size() + 1));
        while (item.starts_with(' ')) item.remove_prefix(1);
        if (item.size() > name.size() && item.starts_with(name) && item[name.size()] == '=')
            return item.substr(name.size() + 1);
    }
    return {};
}

HttpResponse textAnswer(const HttpRequest& request, std::string_view bytes, std::string_view type)
{
    HttpResponse response = emptyAnswer(request, http::status::ok);
    response.set(http::field::content_type, boost::beast::string_view(type.data(), type.size()));
    response.set("X-Content-Type-Options", "nosniff");
    response.content_length(bytes.size());
    if (request.method() != http::verb::head) response.body() = bytes;
    return response;
}

/// Whether the Host field names this host, rather than something that was made to point here.
bool isOwnName(const HttpRequest& request, const HttpRules& rules)
{
    std::string_view host = textOf(request[http::field::host]);
    if (host.empty() || host.starts_with('[')) return true;  // No browser, or an IPv6 address.
    host = host.substr(0, host.find(':'));
    const bool isAddress =
        std::all_of(host.begin(), host.end(), [](char c) { return c == '.' || (c >= '0' && c <= '9'); });
    return isAddress || boost::beast::iequals({host.data(), host.size()}, "localhost") ||
           std::any_of(rules.names.begin(), rules.names.end(), [&](const std::string& name) {
               return boost::beast::iequals({host.data(), host.size()}, {name.data(), name.size()});
           });
}

}  // namespace

bool mayEnter(const HttpRequest& request, const HttpRules& rules)
{
    if (rules.token.empty()) return isOwnName(request, rules);
    return bringsToken(request, rules.token) ||
           sameToken(cookieValue(textOf(request[http::field::cookie]), rules.cookieName), rules.token);
}

bool isOwnOrigin(const HttpRequest& request, const HttpRules& rules)
{
    const std::string_view origin = textOf(request[http::field::origin]);
    if (origin.empty()) return true;
    return origin == (rules.secure ? "https://" : "http://") + std::string(textOf(request[http::field::host]));
}

HttpResponse answer(const HttpRequest& request, const HttpRules& rules)
{
    if (!mayEnter(request, rules)) return emptyAnswer(request, http::status::unauthorized);
    if (request.method() != http::verb::get && request.method() != http::verb::head)
        return emptyAnswer(request, http::status::method_not_allowed);
    const std::string path = pathOf(request);
    if (path == "/status") {
        HttpResponse response = textAnswer(request, rules.statusJson(), "application/json; charset=utf-8");
        response.set(http::field::cache_control, "no-store");
        return response;
    }
    const auto asset = webAsset(path);
    if (!asset) return emptyAnswer(request, http::status::not_found);
    HttpResponse response = textAnswer(request, asset->bytes, asset->contentType);
    response.set("Content-Security-Policy", kPolicy);
    response.set("Referrer-Policy", "no-referrer");  // The address holds the token.
    response.set(http::field::cache_control, "no-cache");
    if (path == "/" && !rules.token.empty())
        response.set(http::field::set_cookie, rules.cookieName + "=" + rules.token +
                                                  "; Path=/; HttpOnly; SameSite=Strict" +
                                                  (rules.secure ? "; Secure" : ""));
    return response;
}

}  // namespace aeolic::stream
