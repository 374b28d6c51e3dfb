#include "data/load/series/series_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "aeolic/error.h"

namespace aeolic {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t largestFileBytes = std::size_t{64} << 20;  // A million steps take less.
constexpr const char* expected = R"({"file-series-version": "1.0", "files": [{"name": ..., "time": ...}, ...]})";

std::string fileText(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(file)), {});
    if (file.bad()) throw InputError(path, "it cannot be read", expected);
    if (text.size() > largestFileBytes) throw InputError(path, "found more than 64 MiB", expected);
    return text;
}

constexpr std::size_t mostDigits = 18;  // So many fit into 64 bits.

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// A file name around its wildcard.
struct Pattern {
    std::string before, after;
    std::size_t width = 0;  ///< Digits a shorter number is padded to; 0: any width.
    bool another = false;   ///< A second wildcard follows.
};

/// Where a wildcard begins and ends in `name`, from `start` on.
std::optional<Pattern> findWildcard(const std::string& name, std::size_t start = 0)
{
    for (std::size_t at = start; at < name.size(); ++at) {
        std::size_t end = at + 1, width = 0;
        if (name[at] == '%') {
            while (end < name.size() && isDigit(name[end]) && width < 100)
                width = 10 * width + std::size_t(name[end++] - '0');
            if (end == name.size() || name[end] != 'd') continue;
            ++end;
        } else if (name[at] != '*') {
            continue;
        }
        return Pattern{name.substr(0, at), name.substr(end), width, findWildcard(name, end).has_value()};
    }
    return std::nullopt;
}

/// The number in `name`, where it has the pattern's shape.
std::optional<std::int64_t> numberIn(const std::string& name, const Pattern& pattern)
{
    if (name.size() <= pattern.before.size() + pattern.after.size() || !name.starts_with(pattern.before) ||
        !name.ends_with(pattern.after))
        return std::nullopt;
    const std::string digits =
        name.substr(pattern.before.size(), name.size() - pattern.before.size() - pattern.after.size());
    if (digits.size() > mostDigits || !std::all_of(digits.begin(), digits.end(), isDigit)) return std::nullopt;
    const bool padded = digits.size() > 1 && digits.front() == '0';
    if (pattern.width > 0 && (digits.size() < pattern.width || (padded && digits.size() > pattern.width)))
        return std::nullopt;
    std::int64_t number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
}

}  // namespace

std::vector<SeriesEntry> readSeriesFile(const std::string& path)
{
    const Json document = Json::parse(fileText(path), nullptr, false);
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
            std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }))
            throw InputError(where, "its \"name\" has control characters", "the name of a file");
        if (!time || !time->is_number()) throw InputError(where, "it has no \"time\"", "a number");
        entries.push_back({name->get<std::string>(), time->get<double>()});
    }
    return entries;
}

bool isNumberPattern(const std::string& path)
{
    std::error_code error;
    return findWildcard(fs::path(path).filename().string()) && !fs::exists(path, error);
}

std::vector<SeriesEntry> numberedFiles(const std::string& path)
{
    const auto pattern = findWildcard(fs::path(path).filename().string());
    if (!pattern || pattern->another)
        throw InputError(path, pattern ? "two wildcards" : "no wildcard", "one, for the number: %d, %04d or *");
    const fs::path folder = fs::path(path).parent_path();
    std::vector<std::pair<std::int64_t, std::string>> found;
    std::error_code error;
    for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end;
         at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (const auto number = numberIn(name, *pattern)) found.emplace_back(*number, name);
    }
    if (error)
        throw InputError(path, fmt::format("its folder cannot be read ({})", error.message()), "a folder of files");
    if (found.empty())
        throw InputError(path, "no file has such a name",
                         fmt::format("files like {}{:0{}}{}", pattern->before, 0,
                                     std::max<std::size_t>(1, pattern->width), pattern->after));
    std::sort(found.begin(), found.end());
    std::vector<SeriesEntry> entries;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i > 0 && found[i].first == found[i - 1].first)
            throw InputError(path,
                             fmt::format("'{}' and '{}' have the same number", found[i - 1].second, found[i].second),
                             "one file for each number");
        entries.push_back({(folder / found[i].second).string(), double(i)});
    }
    return entries;
}

}  // namespace aeolic
