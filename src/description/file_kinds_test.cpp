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
    for (const FileKind& row : fileKinds) EXPECT_TRUE(extensions.insert(row.extension).second) << row.extension;
}

TEST(FileKinds, TheHelpNamesEveryKind)
{
    std::string help;
    for (const OptionHelp& option : optionsHelp()) help += option.text;
    for (const FileKind& row : fileKinds) EXPECT_NE(help.find(row.extension), std::string::npos) << row.extension;
    EXPECT_EQ(help.find("{surfaces}"), std::string::npos);
    EXPECT_EQ(help.find("{fields}"), std::string::npos);
}

}  // namespace
}  // namespace aeolic
