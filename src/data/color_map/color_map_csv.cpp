#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "data/color_map/color_map_file.h"
#include "description/option_rules.h"

namespace aeolic {
namespace {

constexpr const char* expectedLine = "r,g,b or value,r,g,b";

bool isBetween(char c)
{
    return c == ',' || c == ';' || c == ' ' || c == '\t' || c == '\r';
}

/// The words between commas, semicolons and blanks. Words after the fifth are left out.
std::vector<std::string_view> partsOf(std::string_view line)
{
    std::vector<std::string_view> parts;
    for (std::size_t at = 0; parts.size() < 6;) {
        while (at < line.size() && isBetween(line[at])) ++at;
        if (at == line.size()) break;
        const std::size_t start = at;
        while (at < line.size() && !isBetween(line[at])) ++at;
        parts.push_back(line.substr(start, at - start));
    }
    return parts;
}

}  // namespace

ColorPoints colorPointsFromCsv(std::string_view text, const std::string& path)
{
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // A spreadsheet's byte order mark.
    ColorPoints map;
    std::size_t columns = 0, line = 0;
    bool mayBeHeading = true;
    double highest = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const auto parts = partsOf(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        ++line;
        if (parts.empty() || parts[0].starts_with('#')) continue;
        const std::string where = fmt::format("{}: line {}", path, line);
        if (std::exchange(mayBeHeading, false) && !parseNumber(parts[0])) continue;  // The columns' names.
        if (columns == 0) columns = parts.size();
        if (parts.size() != columns || columns < 3 || columns > 4)
            throw InputError(where, fmt::format("found {} values", parts.size()),
                             columns == 3 || columns == 4 ? fmt::format("{}, as before", columns) : expectedLine);
        double numbers[4] = {double(map.points.size()), 0, 0, 0};  // Without values the points are equally far apart.
        for (std::size_t i = 0; i < columns; ++i) {
            const auto number = parseNumber(parts[i]);
            if (!number) throw InputError(where, "found " + inQuotes(parts[i]), "a number");
            numbers[i + 4 - columns] = *number;
        }
        for (int c = 1; c < 4; ++c) {
            highest = std::max(highest, numbers[c]);
            if (numbers[c] < 0 || numbers[c] > 255)
                throw InputError(where, "found a colour of " + numberText(numbers[c]),
                                 "parts from 0 to 1, or from 0 to 255");
        }
        map.points.push_back({numbers[0], {numbers[1], numbers[2], numbers[3]}});
    }
    if (highest > 1)
        for (auto& point : map.points)
            for (double& part : point.rgb) part /= 255;
    return map;
}

}  // namespace aeolic
