#include "base/nearest_name.h"

#include <algorithm>
#include <numeric>

#include "base/text.h"

namespace aeolic {
namespace {

constexpr std::size_t kLettersPerFault = 3;
constexpr std::size_t kShortestBeginning = 3;
constexpr std::size_t kLongestName = 100;  // The comparison takes time in proportion to the product of the lengths.

/// The name without what counts for nothing.
std::string folded(std::string_view name)
{
    std::string letters = lowerCase(std::string(name));
    std::erase_if(letters, [](char c) { return c == '-' || c == '_'; });
    return letters;
}

/// How many letters are inserted, left out, replaced, or changed places with their neighbour (optimal string
/// alignment).
std::size_t faultsBetween(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> beforeLast, last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
        beforeLast = last;
        last = row;
    }
    return last.back();
}

/// The only name that begins with the letters; empty where there is none, or more than one.
std::string_view onlyOneThatBegins(const std::string& letters, const std::vector<std::string_view>& names)
{
    if (letters.size() < kShortestBeginning) return {};
    std::string_view only;
    for (const std::string_view name : names) {
        if (name.size() > kLongestName || !folded(name).starts_with(letters)) continue;
        if (!only.empty()) return {};
        only = name;
    }
    return only;
}

}  // namespace

std::string didYouMean(std::string_view typed, const std::vector<std::string_view>& names)
{
    if (typed.size() > kLongestName || std::find(names.begin(), names.end(), typed) != names.end()) return "";
    const std::string letters = folded(typed);
    std::string_view nearest;
    std::size_t fewest = 0;
    bool nearestBegins = false;
    for (const std::string_view name : names) {
        const std::string other = folded(name);
        if (letters.empty() || other.empty() || name.size() > kLongestName) continue;
        const std::size_t faults = faultsBetween(letters, other);
        if (faults > std::min(letters.size(), other.size()) / kLettersPerFault) continue;
        const bool begins = other.starts_with(letters);
        if (!nearest.empty() && (faults > fewest || (faults == fewest && (nearestBegins || !begins)))) continue;
        nearest = name;
        fewest = faults;
        nearestBegins = begins;
    }
    if (nearest.empty()) nearest = onlyOneThatBegins(letters, names);
    return nearest.empty() ? "" : "; did you mean " + std::string(nearest) + "?";
}

}  // namespace aeolic
