#include "stream/http_request.h"

#include <utility>

#include "base/text.h"
#include "stream/token.h"

namespace aeolic::stream {
namespace {

namespace http = boost::beast::http;

constexpr std::string_view kTokenItem = "token=";

std::string_view queryOf(const HttpRequest& request)
{
    const std::string_view target = textOf(request.target());
    const std::size_t at = target.find('?');
    return at == target.npos ? std::string_view{} : target.substr(at + 1);
}

}  // namespace

std::string pathOf(const HttpRequest& request)
{
    const std::string_view target = textOf(request.target());
    return std::string(target.substr(0, target.find('?')));
}

std::optional<std::string_view> tokenOf(const HttpRequest& request)
{
    // Escapes are not resolved: tokens need none.
    for (const std::string_view item : splitText(queryOf(request), '&'))
        if (item.starts_with(kTokenItem)) return item.substr(kTokenItem.size());
    constexpr std::string_view bearer = "Bearer ";
    const std::string_view authorization = textOf(request[http::field::authorization]);
    if (authorization.starts_with(bearer)) return authorization.substr(bearer.size());
    return std::nullopt;
}

bool bringsToken(const HttpRequest& request, std::string_view token)
{
    const auto given = tokenOf(request);
    return given && sameToken(*given, token);
}

std::string targetWithoutToken(const HttpRequest& request)
{
    std::string target = pathOf(request);
    char before = '?';
    for (const std::string_view item : splitText(queryOf(request), '&')) {
        if (item.empty() || item.starts_with(kTokenItem)) continue;
        target += std::exchange(before, '&');
        target += item;
    }
    return target;
}

std::string_view cookieOf(const HttpRequest& request, std::string_view name)
{
    for (std::string_view item : splitText(textOf(request[http::field::cookie]), ';')) {
        while (item.starts_with(' ')) item.remove_prefix(1);
        if (item.size() > name.size() && item.starts_with(name) && item[name.size()] == '=')
            return item.substr(name.size() + 1);
    }
    return {};
}

HttpResponse emptyAnswer(const HttpRequest& request, http::status status)
{
    HttpResponse response(status, request.version());
    response.keep_alive(request.keep_alive() && status == http::status::ok);
    response.content_length(0);
    return response;
}

}  // namespace aeolic::stream
