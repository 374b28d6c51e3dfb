#include "stream/gateway/http_answers.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/embedded_file.h"
#include "stream/token.h"

extern "C" const aeolic::EmbeddedFile aeolicWebFiles[];

namespace aeolic::stream {
namespace {

namespace http = boost::beast::http;

/// Bytes, and their type for a browser.
struct TypedText {
    std::string_view bytes, contentType;
};

std::string_view contentType(std::string_view name)
{
    constexpr std::pair<std::string_view, std::string_view> types[] = {
        {".html", "text/html; charset=utf-8"},        {".css", "text/css; charset=utf-8"},
        {".js", "text/javascript; charset=utf-8"},    {".svg", "image/svg+xml"},
        {".json", "application/json; charset=utf-8"}, {".webmanifest", "application/manifest+json"},
    };
    for (const auto& [ending, type] : types)
        if (name.ends_with(ending)) return type;
    return "application/octet-stream";
}

/// `path` is that of a request, without the query: "/", "/net/session.js". Nothing for a path outside of the page.
std::optional<TypedText> webAsset(std::string_view path)
{
    if (path.empty() || path.front() != '/') return std::nullopt;
    const std::string_view name = path == "/" ? "index.html" : path.substr(1);
    for (const EmbeddedFile* file = aeolicWebFiles; file->name; ++file)
        if (name == file->name) return TypedText{file->bytes(), contentType(name)};
    return std::nullopt;
}

/// Whether a policy can hold the text as a host. A client writes what it likes into the Host field.
bool isPlainHost(std::string_view host)
{
    constexpr auto plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_:[]";
    return !host.empty() && host.size() <= 300 && host.find_first_not_of(plain) == host.npos;
}

/// A notebook is another server of this host, or has the page behind its own address.
constexpr const char* kPagesOfThisHost =
    "'self' http://localhost:* http://127.0.0.1:* https://localhost:* https://127.0.0.1:*";

/// What the page may use: its own modules and styles, pictures it made itself, and connections to its own host. With
/// --direct the connections go to the ranks' hosts, too.
std::string policyFor(const HttpRequest& request, const HttpRules& rules)
{
    std::string connections = "'self'";
    const std::string_view host = textOf(request[http::field::host]);
    // Not every browser takes 'self' for WebSockets.
    if (rules.direct)
        connections += " ws: wss:";
    else if (isPlainHost(host))
        connections += (rules.secure ? " wss://" : " ws://") + std::string(host);
    return "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src " +
           connections + "; worker-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors " +
           (rules.embedded ? kPagesOfThisHost : "'none'");
}

HttpResponse textAnswer(const HttpRequest& request, http::status status, const TypedText& text)
{
    HttpResponse response = emptyAnswer(request, status);
    response.set(http::field::content_type,
                 boost::beast::string_view(text.contentType.data(), text.contentType.size()));
    response.set("X-Content-Type-Options", "nosniff");
    response.set(http::field::cache_control, "no-store");
    response.content_length(text.bytes.size());
    if (request.method() != http::verb::head) response.body() = text.bytes;
    return response;
}

/// Whether a person sees the answer. Browsers say what they want it for, or at least that they would like a page.
bool isForAPerson(const HttpRequest& request)
{
    if (request.method() != http::verb::get && request.method() != http::verb::head) return false;
    const std::string_view what = textOf(request["Sec-Fetch-Dest"]), accepts = textOf(request[http::field::accept]);
    return what.empty() ? accepts.find("text/html") != accepts.npos : what == "document" || what == "iframe";
}

/// Says nothing that is not the same for everybody. Its style stands in it, because no other file is given away.
HttpResponse denial(const HttpRequest& request)
{
    const auto page = webAsset("/denied.html");
    if (!page || !isForAPerson(request)) return emptyAnswer(request, http::status::unauthorized);
    HttpResponse response = textAnswer(request, http::status::unauthorized, *page);
    response.set("Content-Security-Policy",
                 "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; "
                 "frame-ancestors 'none'");
    response.set("Referrer-Policy", "no-referrer");
    return response;
}

/// Whether the Host field names this host, rather than something that was made to point here.
bool isOwnName(const HttpRequest& request, const HttpRules& rules)
{
    std::string_view host = textOf(request[http::field::host]);
    if (host.empty() || host.starts_with('[')) return true;  // No browser, or an IPv6 address.
    host = host.substr(0, host.find(':'));
    const bool isAddress = host.find_first_not_of("0123456789.") == host.npos;
    return isAddress || boost::beast::iequals({host.data(), host.size()}, "localhost") ||
           std::any_of(rules.names.begin(), rules.names.end(), [&](const std::string& name) {
               return boost::beast::iequals({host.data(), host.size()}, {name.data(), name.size()});
           });
}

bool hasSession(const HttpRequest& request, const HttpRules& rules)
{
    return rules.sessions->knows(cookieOf(request, rules.cookieName));
}

/// Whether the browser will bring the new cookie when it is sent on. It does not (SameSite=Strict) where a page of
/// another site has led here. Over plain HTTP from other hosts browsers do not say where they come from: then it is
/// taken for possible.
bool bringsCookieAtOnce(const HttpRequest& request)
{
    const std::string_view from = textOf(request["Sec-Fetch-Site"]);
    if (from.empty()) return request.count("Upgrade-Insecure-Requests") == 0;
    return from == "none" || from == "same-origin" || from == "same-site";
}

std::string newCookie(const HttpRules& rules)
{
    return rules.cookieName + "=" + rules.sessions->open() + "; Path=/; HttpOnly; SameSite=Strict" +
           (rules.secure ? "; Secure" : "");
}

HttpResponse redirect(const HttpRequest& request, const std::string& target)
{
    HttpResponse response = emptyAnswer(request, http::status::see_other);
    response.keep_alive(request.keep_alive());
    // A proxy may have this server in a folder of its own, so the address is relative to the one that was asked for.
    const std::size_t name = target.rfind('/', target.find('?')) + 1;
    response.set(http::field::location, "./" + target.substr(name));
    response.set("Referrer-Policy", "no-referrer");  // The address holds the token.
    response.set(http::field::cache_control, "no-store");
    return response;
}

}  // namespace

bool mayEnter(const HttpRequest& request, const HttpRules& rules)
{
    if (rules.token.empty()) return isOwnName(request, rules);
    return bringsToken(request, rules.token) || hasSession(request, rules);
}

bool goesByToken(const HttpRequest& request, const HttpRules& rules)
{
    return !rules.token.empty() && tokenOf(request) && !hasSession(request, rules);
}

bool isOwnOrigin(const HttpRequest& request, const HttpRules& rules)
{
    const std::string_view origin = textOf(request[http::field::origin]);
    if (origin.empty()) return true;
    const std::string host(textOf(request[http::field::host]));
    // A notebook's proxy may talk HTTPS to the browser and HTTP to this server.
    return origin == (rules.secure ? "https://" : "http://") + host || (rules.embedded && origin == "https://" + host);
}

HttpResponse answer(const HttpRequest& request, const HttpRules& rules)
{
    if (!mayEnter(request, rules)) return denial(request);
    if (request.method() != http::verb::get && request.method() != http::verb::head)
        return emptyAnswer(request, http::status::method_not_allowed);
    const std::string path = pathOf(request);
    if (path == "/status")
        return textAnswer(request, http::status::ok, {rules.statusJson(), "application/json; charset=utf-8"});
    const auto asset = webAsset(path);
    if (!asset) return emptyAnswer(request, http::status::not_found);
    const std::string clean = targetWithoutToken(request);  // It names a file of the page, so it is on this host.
    const bool elsewhere = clean != textOf(request.target());
    const bool opens = elsewhere && request.method() == http::verb::get && goesByToken(request, rules);
    HttpResponse response = elsewhere && (!opens || bringsCookieAtOnce(request))
                                ? redirect(request, clean)
                                : textAnswer(request, http::status::ok, *asset);
    if (response.result() == http::status::ok) {
        response.set("Content-Security-Policy", policyFor(request, rules));
        response.set("Referrer-Policy", "no-referrer");
    }
    if (opens) response.set(http::field::set_cookie, newCookie(rules));
    return response;
}

}  // namespace aeolic::stream
