#include "stream/gateway/web_assets.h"

#include <utility>

#include "base/embedded_file.h"

extern "C" const aeolic::EmbeddedFile aeolicWebFiles[];

namespace aeolic::stream {
namespace {

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

}  // namespace

std::optional<WebAsset> webAsset(std::string_view path)
{
    if (path.empty() || path.front() != '/') return std::nullopt;
    const std::string_view name = path == "/" ? "index.html" : path.substr(1);
    for (const EmbeddedFile* file = aeolicWebFiles; file->name; ++file)
        if (name == file->name) return WebAsset{file->bytes(), contentType(name)};
    return std::nullopt;
}

}  // namespace aeolic::stream
