#include "stream/http_request.h"

#include <algorithm>

#include "stream/token.h"

namespace aeolic::stream {
namespace {

namespace http = boost::beast::http;

/// The value of `name` in "a=1&name=value&…". Escapes are not resolved: tokens need none.
std::string_view queryValue(std::string_view query, std::string_view name)
{
    while (!query.empty()) {
        const std::string_view item = query.substr(0, query.find('&'));
        if (item.size() > name.size() && item.starts_with(name) && item[name.size()] == '=')
            return item.substr(name.size() + 1);
        query.remove_prefix(std::min(query.size(), item.size() + 1));
    }
    return {};
}

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

bool bringsToken(const HttpRequest& request, std::string_view token)
{
    if (sameToken(queryValue(queryOf(request), "token"), token)) return true;
    constexpr std::string_view bearer = "Bearer ";
    const std::string_view authorization = textOf(request[http::field::authorization]);
    return authorization.starts_with(bearer) && sameToken(authorization.substr(bearer.size()), token);
}

HttpResponse emptyAnswer(const HttpRequest& request, http::status status)
{
    HttpResponse response(status, request.version());
    response.keep_alive(request.keep_alive() && status == http::status::ok);
    response.content_length(0);
    return response;
}

}  // namespace aeolic::stream
