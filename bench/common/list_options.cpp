#include "common/list_options.h"

#include "aeolic/error.h"
#include "description/field_rules.h"

namespace aeolic {

std::vector<std::string> listItems(const std::string& text)
{
    std::vector<std::string> items;
    for (std::size_t start = 0;;) {
        const std::size_t comma = text.find(',', start);
        items.push_back(text.substr(start, comma - start));
        if (comma == std::string::npos) return items;
        start = comma + 1;
    }
}

int wholeNumber(const std::string& option, std::string_view text, double least, double most)
{
    const NumberRule rule{least, most};
    const auto value = parseNumber(text);
    if (!value) throw InputError(option, "found " + inQuotes(text), expectedNumber(rule, true));
    checkWhole(option, *value, rule);
    return int(*value);
}

}  // namespace aeolic
