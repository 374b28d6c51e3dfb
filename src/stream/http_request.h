#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <string>
#include <string_view>

namespace aeolic::stream {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;
using HttpResponse = boost::beast::http::response<boost::beast::http::string_body>;

/// The target without its query.
std::string pathOf(const HttpRequest& request);

/// Whether a request brings that token in its query or as a bearer.
bool bringsToken(const HttpRequest& request, std::string_view token);

/// An answer without a body.
HttpResponse emptyAnswer(const HttpRequest& request, boost::beast::http::status status);

inline std::string_view textOf(boost::beast::string_view text)
{
    return {text.data(), text.size()};
}

}  // namespace aeolic::stream
