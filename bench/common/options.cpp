#include "common/options.h"

#include <cstdio>

#include "aeolic/error.h"
#include "description/option_rules.h"

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

void BenchOptions::remove(std::initializer_list<const char*> options)
{
    for (const char* option : options) command.remove_option(command.get_option(option));
}

void BenchOptions::add(const char* option, const char* value, const std::string& text, std::string& given)
{
    command.add_option(option, given, text)->type_name(value)->group("Measurement")->take_last();
}

void BenchOptions::addJson()
{
    add("--json", "FILE", "writes the numbers as JSON too; - is standard output, instead of the tables", jsonPath);
}

void BenchOptions::warn(const std::string& warning)
{
    fmt::print(stderr, "aeolic-bench: warning: {}\n", warning);
}

}  // namespace aeolic
