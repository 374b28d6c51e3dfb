#include "data/part_choice.h"

#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "data/vtk/testing/sample_files.h"
#include "description/scene_surfaces.h"

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

/// Names of parts may have colons and commas, as in assemblies of CAD programs.
TEST(PartChoice, NamesMayHaveColonsAndCommas)
{
    const test::TempFolder folder;
    test::writeBytes(folder.file("a.e"), "x");
    for (const std::string& file : {folder.file("a.e"), std::string("none.cgns")}) {
        const FileAndParts split = splitParts(file + ":wing:left,tail");
        EXPECT_EQ(split.file, file);
        EXPECT_EQ(split.parts, (std::vector<std::string>{"wing:left", "tail"}));
    }
    const std::vector<PartInfo> parts{
        {"body", "", {}}, {"body, upper", "", {}}, {"a,b,c", "", {"x,y"}}, {"tail", "", {}}};
    const auto chosen = [&](const std::string& wanted) {
        return chooseParts(parts, splitParts(folder.file("a.e") + ":" + wanted).parts, "a");
    };
    using Numbers = std::vector<std::size_t>;
    EXPECT_EQ(chosen("body, upper"), (Numbers{1}));
    EXPECT_EQ(chosen("body,tail"), (Numbers{0, 3}));
    EXPECT_EQ(chosen("tail,a,b,c,body"), (Numbers{0, 2, 3}));
    EXPECT_EQ(chosen("x,y"), (Numbers{2}));
    EXPECT_EQ(chosen("body*"), (Numbers{0, 1}));
    EXPECT_THROW(chosen("a,b"), InputError);
}

TEST(PartChoice, NamesGroupsAndPatterns)
{
    const std::vector<PartInfo> parts{{"air/wing", "", {"wall"}}, {"air/tail", "", {"wall"}}, {"water/wing", "", {}}};
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
    const std::vector<PartInfo> parts{{std::string(4000, 'a'), "", {}}};
    std::string pattern;
    for (int i = 0; i < 200; ++i) pattern += "*a";
    EXPECT_THROW(chooseParts(parts, {pattern + "*b"}, "a"), InputError);
}

}  // namespace
}  // namespace aeolic
