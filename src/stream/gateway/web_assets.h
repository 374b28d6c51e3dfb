#pragma once

#include <optional>
#include <string_view>

namespace aeolic::stream {

/// A file of the page, as bytes in the program.
struct WebAsset {
    std::string_view bytes, contentType;
};

/// `path` is that of a request, without the query: "/", "/net/session.js". Nothing for a path outside of the page.
std::optional<WebAsset> webAsset(std::string_view path);

}  // namespace aeolic::stream
