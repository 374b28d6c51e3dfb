#include "description/file_kinds.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "base/text.h"
#include "description/option_help.h"
#include "test_paths.h"

namespace aeolic {
namespace {

std::string docsOfFormats()
{
    std::ifstream file(AEOLIC_SOURCE_DIR "/docs/file-formats.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The table of docs/file-formats.md, in Markdown.
std::string fileKindsTable()
{
    std::string text =
        "| ending | format | for | values on | parts | times in one | read by |\n|---|---|---|---|---|---|---|\n";
    for (const FileKind& row : fileKinds) {
        if (!row.holdsData()) continue;
        const char* use = row.use == FileUse::surface ? "`--surface`"
                          : row.use == FileUse::field ? "`--field`"
                                                      : "`--surface`, `--field`";
        const auto add = [&](const std::string& ending, const char* format) {
            text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", ending, format, use, row.holds,
                                row.has(kHasParts) ? "yes" : "", row.has(kHasTimes) ? "yes" : "", row.reader);
        };
        const char* format = row.format;
        if (row.has(kIsFolder)) add("its folder", std::exchange(format, "the same, by a file in the folder"));
        for (const std::string_view ending : splitText(row.endings, ' '))
            add(fmt::format("`{}`", ending), std::exchange(format, "the same"));
    }
    return text;
}

TEST(FileKinds, TheDocsHaveTheTable)
{
    const std::string text = docsOfFormats();
    EXPECT_NE(text.find(fileKindsTable()), std::string::npos) << fileKindsTable();
}

TEST(FileKinds, EveryExtensionStandsOnce)
{
    std::set<std::string> extensions;
    for (const FileKind& row : fileKinds)
        for (const std::string_view ending : splitText(row.endings, ' ')) {
            EXPECT_TRUE(extensions.insert(std::string(ending)).second) << ending;
            EXPECT_EQ(fileKindOf("a/b." + std::string(ending)), &row) << ending;
        }
}

TEST(FileKinds, WhatIsNotReadIsKnownByItsLastEndings)
{
    EXPECT_STREQ(unreadKindOf("a/OUT.CAS.H5")->format, "Fluent's format in HDF5");
    EXPECT_STREQ(unreadKindOf("run.1.h5")->format, "HDF5 of no kind that is known");
    EXPECT_EQ(unreadKindOf("a.vtu"), nullptr);
    EXPECT_EQ(unreadKindOf("a"), nullptr);
    const std::string docs = docsOfFormats();
    for (const UnreadKind& row : unreadKinds)
        for (const std::string_view ending : splitText(row.endings, ' ')) {
            const FileKind* kind = fileKindOf("a" + std::string(ending));
            EXPECT_FALSE(kind && kind->holdsData()) << ending << " is read";
            EXPECT_NE(docs.find("`" + std::string(ending) + "`"), std::string::npos) << ending;
        }
}

TEST(FileKinds, TheHelpNamesEveryKind)
{
    std::string help;
    for (const OptionHelp& option : optionsHelp()) help += option.text;
    for (const FileKind& row : fileKinds)
        for (const std::string_view ending : splitText(row.endings, ' '))
            EXPECT_NE(help.find(ending), std::string::npos) << ending;
    EXPECT_EQ(help.find("{surfaces}"), std::string::npos);
    EXPECT_EQ(help.find("{fields}"), std::string::npos);
}

}  // namespace
}  // namespace aeolic
