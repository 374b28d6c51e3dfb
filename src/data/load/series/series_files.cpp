#include "data/load/series/series_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "aeolic/error.h"

namespace aeolic {

namespace {

namespace fs = std::filesystem;

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
    if (digits.size() > mostDigits || !std::ranges::all_of(digits, isDigit)) return std::nullopt;
    const bool padded = digits.size() > 1 && digits.front() == '0';
    if (pattern.width > 0 && (digits.size() < pattern.width || (padded && digits.size() > pattern.width)))
        return std::nullopt;
    std::int64_t number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
}

}  // namespace

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
    std::ranges::sort(found);
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
