#include <gtest/gtest.h>
#include <sys/stat.h>

#include <stdexcept>

#include "aeolic/picture.h"
#include "data/vtk/testing/sample_files.h"

namespace aeolic {
namespace {

using namespace test;

Picture gradient(int width, int height, int channels)
{
    Picture picture{width, height, channels, {}};
    for (int i = 0; i < width * height * channels; ++i)
        picture.pixels.push_back(static_cast<std::uint8_t>(7 * i + i / 256));
    return picture;
}

TEST(Png, EveryByteSurvivesAtOddSizes)
{
    const TempFolder folder;
    for (const int channels : {3, 4})
        for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {1, 300}, {801, 3}}) {
            const Picture picture = gradient(width, height, channels);
            writePng(picture, folder.file("a.png"));
            const DecodedPng decoded = readPng(folder.file("a.png"));
            EXPECT_EQ(decoded.width, width);
            EXPECT_EQ(decoded.height, height);
            EXPECT_EQ(decoded.channels, channels);
            EXPECT_EQ(decoded.pixels, picture.pixels);
        }
}

TEST(Png, OverwritesAndLeavesNothingElse)
{
    const TempFolder folder;
    writePng(gradient(3, 3, 3), folder.file("a.png"));
    writePng(gradient(5, 4, 3), folder.file("a.png"));
    EXPECT_EQ(readPng(folder.file("a.png")).width, 5);
    int files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
    EXPECT_EQ(files, 1);
}

TEST(Png, AMissingFolderIsNamed)
{
    try {
        writePng(gradient(3, 3, 3), "/no-such-folder/a.png");
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("/no-such-folder/a.png"), std::string::npos);
    }
}

TEST(Png, AFolderInTheWayIsAnErrorThatLeavesNothing)
{
    const TempFolder folder;
    std::filesystem::create_directory(folder.file("target"));
    EXPECT_THROW(writePng(gradient(3, 3, 3), folder.file("target")), std::runtime_error)
        << "a folder stands in the way";
    int files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
    EXPECT_EQ(files, 1) << "the temporary file is gone";
}

TEST(Png, WhatIsNoFileIsNotReplaced)
{
    const TempFolder folder;
    ASSERT_EQ(mkfifo(folder.file("pipe.png").c_str(), 0600), 0);
    EXPECT_THROW(writePng(gradient(3, 3, 3), folder.file("pipe.png")), std::runtime_error);
    EXPECT_TRUE(std::filesystem::is_fifo(folder.file("pipe.png")));
}

TEST(Png, PixelsThatDoNotFitTheSizeAreRefused)
{
    const TempFolder folder;
    Picture picture = gradient(4, 4, 3);
    picture.pixels.pop_back();
    EXPECT_THROW(writePng(picture, folder.file("a.png")), std::runtime_error);
    EXPECT_FALSE(std::filesystem::exists(folder.file("a.png")));
}

}  // namespace
}  // namespace aeolic
