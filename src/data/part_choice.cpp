#include "data/part_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "aeolic/error.h"
#include "base/nearest_name.h"

namespace aeolic {
namespace {

constexpr std::size_t kMostListed = 40;

/// Whether `name` has the pattern's shape; '*' stands for any letters. Takes time in proportion to both lengths at
/// most.
bool matches(std::string_view pattern, std::string_view name)
{
    std::size_t p = 0, n = 0, star = std::string_view::npos, afterStar = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            afterStar = n;
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++afterStar;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

bool matches(const std::string& pattern, const PartInfo& part)
{
    const auto fits = [&](const std::string& name) { return matches(pattern, name); };
    if (fits(part.name) || std::any_of(part.groups.begin(), part.groups.end(), fits)) return true;
    const std::size_t slash = part.name.rfind('/');
    return slash != std::string::npos && fits(part.name.substr(slash + 1));
}

/// The most commas that one of the names has.
std::size_t commasIn(const std::vector<PartInfo>& parts)
{
    std::size_t most = 0;
    const auto look = [&](const std::string& name) {
        most = std::max(most, std::size_t(std::count(name.begin(), name.end(), ',')));
    };
    for (const PartInfo& part : parts) {
        look(part.name);
        std::for_each(part.groups.begin(), part.groups.end(), look);
    }
    return most;
}

}  // namespace

std::vector<std::size_t> chooseParts(const std::vector<PartInfo>& parts, const std::vector<std::string>& wanted,
                                     const std::string& where)
{
    std::vector<bool> chosen(parts.size(), false);
    const auto choose = [&](const std::string& pattern) {
        bool any = false;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (matches(pattern, parts[i])) chosen[i] = any = true;
        return any;
    };
    const std::size_t mostCommas = commasIn(parts);
    for (std::size_t k = 0; k < wanted.size();) {
        // A name may have commas itself: the longest that there is counts.
        std::size_t end = std::min(wanted.size(), k + 1 + mostCommas);
        while (end > k + 1 && !choose(fmt::format("{}", fmt::join(wanted.begin() + std::ptrdiff_t(k),
                                                                  wanted.begin() + std::ptrdiff_t(end), ","))))
            --end;
        const std::string& pattern = wanted[k];
        const bool any = end > k + 1 || choose(pattern);
        k = end;
        if (any) continue;
        std::vector<std::string_view> names;
        names.reserve(parts.size());
        for (const PartInfo& part : parts) names.push_back(part.name);
        std::vector<std::string_view> shown(names.begin(),
                                            names.begin() + std::ptrdiff_t(std::min(names.size(), kMostListed)));
        std::vector<std::string_view> ends = names;  // What may be named alone.
        for (const std::string_view name : names) ends.push_back(name.substr(name.rfind('/') + 1));
        throw InputError(where, fmt::format("no part '{}'", pattern),
                         names.empty()
                             ? "a file with parts"
                             : fmt::format("one of {}{}{}", fmt::join(shown, ", "),
                                           shown.size() < names.size() ? " …" : "", didYouMean(pattern, ends)));
    }
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (chosen[i]) numbers.push_back(i);
    return numbers;
}

}  // namespace aeolic
