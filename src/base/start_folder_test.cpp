#include "base/start_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace aeolic {
namespace {

TEST(StartFolder, ARelativeNameLeadsToTheSameFileAnywhere)
{
    const StartFolder folder;
    const std::string found = folder.absolute("a b/c_%04d.vti");
    EXPECT_EQ(std::filesystem::path(found).lexically_normal(), std::filesystem::current_path() / "a b/c_%04d.vti");
    EXPECT_EQ(folder.absolute("/a/b.vti"), "/a/b.vti");
    EXPECT_EQ(folder.absolute(""), "");
}

TEST(StartFolder, MessagesHaveNamesAsTheyWereGiven)
{
    const StartFolder folder;
    const std::string message = folder.absolute("a.pvd") + ": " + folder.absolute("../b.vti") + " is missing";
    EXPECT_EQ(folder.asGiven(message), "a.pvd: ../b.vti is missing");
    const std::string typed = (std::filesystem::current_path() / "a.vti").string() + ": is missing";
    EXPECT_EQ(folder.asGiven(typed), typed);
}

}  // namespace
}  // namespace aeolic
