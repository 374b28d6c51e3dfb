#include "reader/lists/series_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "aeolic/error.h"
#include "reader/binary/whole_file.h"

namespace aeolic {

namespace {

using Json = nlohmann::json;

constexpr const char* expected = R"({"file-series-version": "1.0", "files": [{"name": ..., "time": ...}, ...]})";

}  // namespace

std::vector<SeriesEntry> readSeriesFile(const std::string& path)
{
    const Json document = Json::parse(wholeFile(path), nullptr, false);
    if (document.is_discarded()) throw InputError(path, "it is not JSON", expected);
    const auto member = [](const Json& object, const char* key) {
        return object.is_object() && object.contains(key) ? &object[key] : nullptr;
    };
    const Json* version = member(document, "file-series-version");
    if (version && !(version->is_string() && version->get<std::string>().starts_with("1.")))
        throw InputError(path, "file-series-version is " + version->dump(), "\"1.0\"");
    const Json* files = member(document, "files");
    if (!files || !files->is_array()) throw InputError(path, "it has no list \"files\"", expected);
    std::vector<SeriesEntry> entries;
    for (const Json& item : *files) {
        const std::string where = fmt::format("{}: files[{}]", path, entries.size());
        const Json *name = member(item, "name"), *time = member(item, "time");
        if (!name || !name->is_string() || name->get<std::string>().empty())
            throw InputError(where, "it has no \"name\"", "the name of a file");
        if (const auto text = name->get<std::string>();
            std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < ' '; }))
            throw InputError(where, "its \"name\" has control characters", "the name of a file");
        if (!time || !time->is_number()) throw InputError(where, "it has no \"time\"", "a number");
        entries.push_back({name->get<std::string>(), time->get<double>()});
    }
    return entries;
}

}  // namespace aeolic
