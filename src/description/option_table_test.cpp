#include "description/option_table.h"

#include <gtest/gtest.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "aeolic/error.h"
#include "description/option_help.h"
#include "description/scene_json.h"
#include "description/scene_text.h"
#include "description/validate.h"
#include "test_paths.h"

namespace aeolic {
namespace {

namespace fs = std::filesystem;

struct Range {
    Option option;
    NumberRule rule;
    bool whole, list;
};

/// Every option that has a range.
std::vector<Range> ranges()
{
    std::vector<Range> all;
    forEachOption(SceneDescription{}, [&](const Option& option, const auto& value, const auto& rule) {
        using Value = std::decay_t<decltype(value)>;
        constexpr bool isNumber = std::is_arithmetic_v<Value> || std::is_same_v<Value, std::optional<double>>;
        if constexpr (std::is_same_v<std::decay_t<decltype(rule)>, NumberRule>)
            all.push_back({option, rule, std::is_integral_v<Value>, !isNumber});
    });
    return all;
}

bool passes(const std::function<void()>& act)
{
    try {
        act();
        return true;
    } catch (const InputError&) {
        return false;
    }
}

bool commandLineTakes(const Range& range, double value)
{
    return passes([&] {
        SceneDescription scene;
        scene.camera.position = {1, 2, 3};  // Else a field of view may be no narrower than the whole surface needs.
        setOption(scene, range.option.name, numberText(value));
        validate(scene);
    });
}

bool jsonTakes(const Range& range, double value)
{
    nlohmann::ordered_json document{{"camera", {{"position", {1, 2, 3}}}}};
    document[range.option.group.key][range.option.key] = value;
    return passes([&] { sceneFromDocument(document, ""); });
}

TEST(OptionTable, EveryRangeHoldsOnEveryWayIn)
{
    for (const Range& range : ranges()) {
        if (range.list) continue;
        const auto& [lo, hi, aboveLo, usualLo, usualHi, automatic] = range.rule;
        const double step = range.whole ? 1 : std::max(1e-9, 1e-9 * std::abs(lo));
        const std::pair<double, bool> cases[] = {{lo - step, false}, {lo, !aboveLo},
                                                 {lo + step, true},  {hi, true},
                                                 {usualHi, true},    {usualLo, !aboveLo || usualLo > lo}};
        for (const auto& [value, fine] : cases) {
            EXPECT_EQ(commandLineTakes(range, value), fine) << range.option.name << " " << value;
            EXPECT_EQ(jsonTakes(range, value), fine) << range.option.name << " " << value;
        }
        if (hi == options::largest) continue;
        const double beyond = hi + (range.whole ? 1 : 1e-9 * hi);
        EXPECT_FALSE(commandLineTakes(range, beyond)) << range.option.name << " " << beyond;
        EXPECT_FALSE(jsonTakes(range, beyond)) << range.option.name << " " << beyond;
    }
}

TEST(OptionTable, NamesAreThereOnce)
{
    std::set<std::string> names, keys;
    int options = 0;
    forEachOption(SceneDescription{}, [&](const Option& option, const auto&, const auto&) {
        names.insert(commandLineName(option));
        keys.insert(jsonName(option));
        ++options;
    });
    EXPECT_EQ(int(names.size()), options);
    EXPECT_EQ(int(keys.size()), options);
}

TEST(OptionTable, HelpShowsEveryRangeAndEveryDefault)
{
    std::map<std::string, OptionHelp> helpOf;
    for (const OptionHelp& help : optionsHelp()) helpOf[help.name] = help;
    const SceneDescription defaults;
    forEachOption(defaults, [&](const Option& option, const auto&, const auto& rule) {
        const std::string name = option.name, initial = optionText(defaults, name);
        if (name.ends_with(wordSuffix)) {  // They stand in the value of their option.
            if constexpr (std::is_same_v<std::decay_t<decltype(rule)>, NameRule>) {
                for (const std::string_view choice : rule.names)
                    EXPECT_NE(helpOf[name.substr(0, name.find(' '))].value.find(choice), std::string::npos) << choice;
            }
            return;
        }
        std::string text = helpOf[name.substr(0, name.find(' '))].text;
        if (const std::size_t item = name.find(' '); item != std::string::npos) {
            const std::size_t line = text.find("\n" + name.substr(item + 1) + ":");
            ASSERT_NE(line, std::string::npos) << name;
            text = text.substr(line, text.find('\n', line + 1) - line);
        }
        EXPECT_NE(text.find("[" + (initial.empty() ? option.unset : initial) + "]"), std::string::npos) << text;
        EXPECT_FALSE(initial.empty() && option.unset[0] == '\0') << name << " has no default to show";
        if constexpr (std::is_same_v<std::decay_t<decltype(rule)>, NumberRule>) {
            EXPECT_NE(text.find(rangeText(rule)), std::string::npos) << text;
        } else if constexpr (std::is_same_v<std::decay_t<decltype(rule)>, NameRule>) {
            for (const std::string_view choice : rule.names)
                EXPECT_NE((helpOf[name].value + text).find(choice), std::string::npos) << name << " " << choice;
        }
    });
    EXPECT_EQ(helpOf["--steps"].text, "integration steps in each direction; from 1 to 65536 [128]");
    EXPECT_EQ(helpOf["--kernel"].value, "box|hann");
}

TEST(OptionTable, ThePageIsToldTheSame)
{
    const auto document = optionsDocument({"lic", "shading", "camera"});
    for (const Range& range : ranges()) {
        if (!document.contains(range.option.group.key)) continue;
        const auto& told = document[range.option.group.key][range.option.key];
        EXPECT_EQ(told["kind"], range.list ? "numbers" : range.whole ? "whole" : "number") << range.option.name;
        if (range.rule.hi == options::largest) continue;
        EXPECT_EQ(told["most"], range.rule.hi) << range.option.name;
        EXPECT_EQ(told[range.rule.aboveLo ? "above" : "least"], range.rule.lo) << range.option.name;
        EXPECT_EQ(told["usual"], (nlohmann::ordered_json{range.rule.usualLo, range.rule.usualHi}));
    }
    EXPECT_EQ(document["lic"]["steps"]["default"], 128);
    EXPECT_EQ(document["lic"]["method"]["names"], (nlohmann::ordered_json{"none", "direct", "hierarchical"}));
    EXPECT_EQ(document["shading"]["background"]["kind"], "color");
    EXPECT_TRUE(document["shading"]["colorRange"]["default"].is_null());
    EXPECT_FALSE(document.contains("run"));
}

std::string textOf(const fs::path& path)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// The ranges that the public header's comments tell are those of the table.
TEST(OptionTable, TheHeadersCommentsTellTheSameRanges)
{
    const std::string header = textOf(fs::path(AEOLIC_SOURCE_DIR) / "include/aeolic/scene_description.h");
    int told = 0;
    for (const Range& range : ranges()) {
        // From the field's name to the end of its comment, which may go on in the next lines.
        const std::regex field("\\b" + std::string(range.option.key) +
                               "\\b[^;]*;[^\\n]*///<[^\\n]*(\\n +///<[^\\n]*)*");
        std::smatch at, ends;
        if (!std::regex_search(header, at, field)) continue;
        const std::string comment = at.str();
        if (!std::regex_search(comment, ends, std::regex(R"(([\[(])(-?[\d.e+]+), (-?[\d.e+]+)\])"))) continue;
        ++told;
        EXPECT_EQ(ends[1] == "(", range.rule.aboveLo) << comment;
        EXPECT_EQ(std::stod(ends[2]), range.rule.lo) << comment;
        EXPECT_EQ(std::stod(ends[3]), range.rule.hi) << comment;
    }
    EXPECT_GE(told, 9);
}

/// The numbers in the code of one line, in their order.
struct NumbersOfLine {
    std::vector<double> values;
    std::vector<std::string> between;  ///< between[i]: what stands after values[i], up to the next number.
};

NumbersOfLine numbersOf(const std::string& line)
{
    std::string code = line.substr(0, line.find("//"));
    std::erase(code, '\'');  // 65'536
    const auto isWord = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    NumbersOfLine numbers;
    for (std::size_t i = 0; i < code.size();) {
        const bool minus = code[i] == '-' && i + 1 < code.size() && isDigit(code[i + 1]);
        if ((!minus && !isDigit(code[i])) || (i > 0 && isWord(code[i - 1]))) {
            if (!numbers.between.empty()) numbers.between.back() += code[i];
            ++i;
            continue;
        }
        double value = 0;
        const char* const end = std::from_chars(code.data() + i, code.data() + code.size(), value).ptr;
        numbers.values.push_back(value);
        numbers.between.emplace_back();
        i = std::size_t(end - code.data());
    }
    return numbers;
}

/// Both ends of a range, one after the other, in one line of code: somebody wrote the range down once more.
bool tellsRange(const NumbersOfLine& numbers, double lo, double hi)
{
    for (std::size_t i = 0; i + 1 < numbers.values.size(); ++i)
        if (numbers.values[i] == lo && numbers.values[i + 1] == hi && numbers.between[i].find('/') == std::string::npos)
            return true;
    return false;
}

/// A copy of a range would go on to tell it when the table has changed. Ranges from 0 to a number as small as 10 are
/// not looked for: such numbers stand everywhere.
TEST(OptionTable, NoRangeStandsAnywhereElse)
{
    EXPECT_TRUE(tellsRange(numbersOf("if (scale >= 0.01 && scale <= 16) return;"), 0.01, 16));
    EXPECT_TRUE(tellsRange(numbersOf("steps: whole(1, 65536), seed: 1"), 1, 65536));
    EXPECT_TRUE(tellsRange(numbersOf("\"integration steps, 1 to 65'536\""), 1, 65536));
    EXPECT_FALSE(tellsRange(numbersOf("kHalfUnit = 1.0f / 65536.0f;  // 1, 65536"), 1, 65536));

    const std::set<std::string> others{"serve_command.cpp: number(\"--ranks\""};  // The same numbers for another thing.
    const std::vector<Range> all = ranges();
    int files = 0;
    for (const char* folder : {"src", "bench", "web"})
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator(fs::path(AEOLIC_SOURCE_DIR) / folder)) {
            const std::string name = entry.path().filename().string(), kind = entry.path().extension().string();
            if (kind != ".cpp" && kind != ".h" && kind != ".js") continue;
            if (name.find("_test.") != std::string::npos || name == "option_table.h") continue;
            ++files;
            std::istringstream lines(textOf(entry.path()));
            for (std::string line; std::getline(lines, line);) {
                const NumbersOfLine numbers = numbersOf(line);
                if (numbers.values.size() < 2) continue;
                for (const Range& range : all) {
                    if (range.rule.hi == options::largest || (range.rule.lo == 0 && range.rule.hi <= 10)) continue;
                    const std::string where =
                        name + ": " + line.substr(std::min(line.size(), line.find_first_not_of(' ')));
                    if (std::any_of(others.begin(), others.end(), [&](const auto& o) { return where.starts_with(o); }))
                        continue;
                    EXPECT_FALSE(tellsRange(numbers, range.rule.lo, range.rule.hi))
                        << where << "\ntells the range of " << range.option.name << "; take it from the table";
                }
            }
        }
    EXPECT_GT(files, 300);
}

}  // namespace
}  // namespace aeolic
