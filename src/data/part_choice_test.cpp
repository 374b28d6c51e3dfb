#include "data/part_choice.h"

#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "data/vtk/sample_files.h"

namespace aeolic {
namespace {

TEST(PartChoice, AColonPartsFileAndParts)
{
    const FileAndParts split = splitParts("a/b.case:wing,tail*,,");
    EXPECT_EQ(split.file, "a/b.case");
    EXPECT_EQ(split.parts, (std::vector<std::string>{"wing", "tail*"}));
    EXPECT_EQ(splitParts("a/b.case").file, "a/b.case");
    EXPECT_TRUE(splitParts("a/b.case").parts.empty());
    EXPECT_EQ(splitParts(":a").file, ":a");
    EXPECT_THROW(splitParts("a:"), InputError);
    EXPECT_THROW(splitParts("a:,"), InputError);
}

TEST(PartChoice, AColonOfTheFilesNameIsNoSeparator)
{
    const test::TempFolder folder;
    test::writeBytes(folder.file("12:30.vtp"), "x");
    EXPECT_EQ(splitParts(folder.file("12:30.vtp")).file, folder.file("12:30.vtp"));
    EXPECT_EQ(splitParts(folder.file("12:30.vtp:left")).file, folder.file("12:30.vtp"));
}

TEST(PartChoice, NamesGroupsAndPatterns)
{
    const std::vector<PartName> parts{{"air/wing", {"wall"}}, {"air/tail", {"wall"}}, {"water/wing", {}}};
    const auto chosen = [&](std::vector<std::string> wanted) { return chooseParts(parts, wanted, "a"); };
    using Numbers = std::vector<std::size_t>;
    EXPECT_EQ(chosen({"wing"}), (Numbers{0, 2}));
    EXPECT_EQ(chosen({"air/wing"}), (Numbers{0}));
    EXPECT_EQ(chosen({"water/wing", "wall"}), (Numbers{0, 1, 2})) << "in the file's order, each once";
    EXPECT_EQ(chosen({"*"}), (Numbers{0, 1, 2}));
    EXPECT_EQ(chosen({"*a*l"}), (Numbers{0, 1})) << "air/tail, and the group of both";
    EXPECT_THROW(chosen({"wing", "Wing*"}), InputError) << "one of them matches nothing";
    EXPECT_THROW(chosen({""}), InputError);
}

TEST(PartChoice, APatternOfManyStarsIsSoonDone)
{
    const std::vector<PartName> parts{{std::string(4000, 'a'), {}}};
    std::string pattern;
    for (int i = 0; i < 200; ++i) pattern += "*a";
    EXPECT_THROW(chooseParts(parts, {pattern + "*b"}, "a"), InputError);
}

}  // namespace
}  // namespace aeolic
