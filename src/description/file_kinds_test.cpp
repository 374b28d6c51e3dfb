#include "description/file_kinds.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "description/option_help.h"
#include "test_paths.h"

namespace aeolic {
namespace {

TEST(FileKinds, TheDocsHaveTheTable)
{
    std::ifstream file(AEOLIC_SOURCE_DIR "/docs/file-formats.md");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    EXPECT_NE(text.find(fileKindsTable()), std::string::npos) << fileKindsTable();
}

TEST(FileKinds, EveryExtensionStandsOnce)
{
    std::set<std::string> extensions;
    for (const FileKind& row : fileKinds)
        forEachEnding(row, [&](std::string_view ending) {
            EXPECT_TRUE(extensions.insert(std::string(ending)).second) << ending;
            EXPECT_EQ(fileKindOf("a/b." + std::string(ending)), &row) << ending;
        });
}

TEST(FileKinds, TheHelpNamesEveryKind)
{
    std::string help;
    for (const OptionHelp& option : optionsHelp()) help += option.text;
    for (const FileKind& row : fileKinds)
        forEachEnding(row, [&](std::string_view ending) { EXPECT_NE(help.find(ending), std::string::npos) << ending; });
    EXPECT_EQ(help.find("{surfaces}"), std::string::npos);
    EXPECT_EQ(help.find("{fields}"), std::string::npos);
}

}  // namespace
}  // namespace aeolic
