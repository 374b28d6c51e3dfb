#include "description/option_names.h"

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "description/option_help.h"
#include "description/validate.h"
#include "test_paths.h"

namespace aeolic {
namespace {

constexpr std::string_view kDashes = "--";

std::string textOf(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(std::filesystem::path(AEOLIC_SOURCE_DIR) / path, std::ios::binary).rdbuf();
    return text.str();
}

std::string camelCase(std::string_view words)
{
    std::string key;
    bool begins = false;
    for (const char c : words) {
        if (c != '-') key += begins ? char(std::toupper(static_cast<unsigned char>(c))) : c;
        begins = c == '-';
    }
    return key;
}

/// The one rule by which an option's name on the command line gives its key in the JSON, which is the name of the
/// struct's member, too: "noiseScale" of "--noise-scale". An option that is called like its group has the group's own
/// key: "method" of "--lic". The group's name is not repeated: "precision" of "--field-precision". An item of a
/// compound option is called like the item: "zoom" of "--camera zoom". Words in the place of an option's numbers have a
/// key of their own: "colorRangeOf" beside "colorRange".
std::string keyOfName(const Option& option)
{
    std::string_view name = std::string_view(option.name).substr(kDashes.size());
    if (name.ends_with(wordSuffix)) {
        Option row = option;
        const std::string ofNumbers(option.name, kDashes.size() + name.size() - wordSuffix.size());
        row.name = ofNumbers.c_str();
        return keyOfName(row) + "Of";
    }
    if (const std::size_t space = name.find(' '); space != std::string_view::npos) name.remove_prefix(space + 1);
    const std::string_view group = option.group.key;
    if (name == group) return option.group.own;
    if (name.starts_with(group) && name[group.size()] == '-') name.remove_prefix(group.size() + 1);
    return camelCase(name);
}

/// "shading.colorBy" of "--color-by", for every option.
std::map<std::string, std::string> keysByName()
{
    std::map<std::string, std::string> keys;
    forEachOption(SceneDescription{},
                  [&](const Option& option, const auto&, const auto&) { keys[option.name] = jsonName(option); });
    return keys;
}

TEST(OptionNames, KeysOfSceneFilesFollowFromTheCommandLines)
{
    forEachOption(SceneDescription{}, [&](const Option& option, const auto&, const auto&) {
        EXPECT_EQ(option.key, keyOfName(option)) << option.name;
    });
    const std::map<std::string, std::string> keys = keysByName();
    EXPECT_EQ(keys.at("--noise-scale"), "lic.noiseScale");
    EXPECT_EQ(keys.at("--lic"), "lic.method");
    EXPECT_EQ(keys.at("--time-range"), "time.range");
    EXPECT_EQ(keys.at("--time-stamp"), "shading.timeStamp");
    EXPECT_EQ(keys.at("--camera zoom"), "camera.zoom");
    EXPECT_EQ(keys.at("--size width"), "output.width");
    EXPECT_EQ(keys.at("--color-range word"), "shading.colorRangeOf");
}

/// The row of each option hands over the member of its struct: `Option{lic, "steps", …}, scene.lic.steps, …`.
TEST(OptionNames, MembersInCppAreCalledLikeTheKeys)
{
    const std::string table = textOf("src/description/option_table.h");
    const std::regex row(R"re(Option\{\s*\w+, "(\w+)", "(--[^"]+)"[\s\S]*?scene\.(\w+)\.(\w+),)re");
    const std::map<std::string, std::string> keys = keysByName();
    std::set<std::string> seen;
    for (std::sregex_iterator match(table.begin(), table.end(), row), end; match != end; ++match) {
        const std::string name = (*match)[2];
        ASSERT_TRUE(keys.contains(name)) << name;
        EXPECT_EQ((*match)[3].str() + "." + (*match)[4].str(), keys.at(name)) << name;
        seen.insert(name);
    }
    EXPECT_EQ(seen.size(), keys.size());
}

/// What differs from surface to surface is called as it is for all of them.
TEST(OptionNames, KeysOfOneOfSeveralSurfacesAreThoseOfAll)
{
    std::set<std::string> known;
    forEachOption(SceneDescription{},
                  [&](const Option& option, const auto&, const auto&) { known.insert(option.key); });
    forEachItemOption(SurfaceItem{}, "surfaces", [&](const Option& option, const auto&, const auto&) {
        EXPECT_TRUE(known.contains(option.key) || option.key == std::string("shown")) << option.key;
    });
}

TEST(OptionNames, PythonHasAllWithUnderscores)
{
    EXPECT_EQ(pythonName("--noise-scale"), "noise_scale");
    EXPECT_EQ(pythonName("--camera zoom"), "camera zoom");
    for (const OptionHelp& help : optionsHelp()) {
        const std::string name = pythonName(help.name);
        EXPECT_TRUE(std::regex_match(name, std::regex("[a-z]+(_[a-z]+)*"))) << name;
        EXPECT_EQ(inPythonsWords(help.name + ": found 0; expected more, with " + help.name),
                  name + ": found 0; expected more, with " + name);
        const std::string text = inPythonsWords(help.text);
        for (const OptionHelp& other : optionsHelp())
            EXPECT_FALSE(std::regex_search(text, std::regex(other.name + "(?![-a-z])"))) << help.name << ": " << text;
    }
}

TEST(OptionNames, PythonsMessagesHaveItsOwnWords)
{
    for (const auto& [told, python] : std::map<std::string, std::string>{
             {"--camera azimuth: found 'x'; expected a number", "camera azimuth: found 'x'; expected a number"},
             {"--phase has no effect without --kernel hann", "phase has no effect without kernel hann"},
             {"surfaces[1].colorBy: found 3; expected text", "surface[1]: color_by: found 3; expected text"},
             {"surfaces[0].spec: found ''", "surface[0]: surface: found ''"},
             {"--stepz: unknown; expected --step.", "--stepz: unknown; expected step."},
             {"a.vtp: expected an undamaged file; aeolic info --verbose",
              "a.vtp: expected an undamaged file; aeolic info --verbose"},
             {"/tmp/--steps: no such file", "/tmp/--steps: no such file"},
             {"title: found '--steps'; expected", "title: found '--steps'; expected"},
             {"scene.json: surfaces[1].colorBy: found 3", "scene.json: surfaces[1].colorBy: found 3"},
             {"-", "-"},
             {"", ""}})
        EXPECT_EQ(inPythonsWords(told), python);
}

}  // namespace
}  // namespace aeolic
