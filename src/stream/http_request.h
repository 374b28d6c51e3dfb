#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace aeolic::stream {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;
using HttpResponse = boost::beast::http::response<boost::beast::http::string_body>;

/// The target without its query.
std::string pathOf(const HttpRequest& request);

/// The token that a request brings, in its query or as a bearer. Nothing where it brings none.
std::optional<std::string_view> tokenOf(const HttpRequest& request);

/// Whether a request brings that token in its query or as a bearer.
bool bringsToken(const HttpRequest& request, std::string_view token);

/// The target with the token taken out of its query.
std::string targetWithoutToken(const HttpRequest& request);

/// The value of a cookie of the request; empty where there is none.
std::string_view cookieOf(const HttpRequest& request, std::string_view name);

/// An answer without a body.
HttpResponse emptyAnswer(const HttpRequest& request, boost::beast::http::status status);

inline std::string_view textOf(boost::beast::string_view text)
{
    return {text.data(), text.size()};
}

}  // namespace aeolic::stream
