#include "output/animation.h"

#include <gtest/gtest.h>
#include <turbojpeg.h>
#include <webp/decode.h>
#include <webp/demux.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>

#include "aeolic/error.h"
#include "data/vtk/testing/sample_files.h"
#include "output/picture_files.h"

namespace aeolic {
namespace {

using namespace test;

Picture noise(int width, int height, int channels, std::uint32_t seed)
{
    Picture picture{width, height, channels, {}};
    for (int i = 0; i < width * height * channels; ++i) {
        seed = seed * 1664525u + 1013904223u;
        picture.pixels.push_back(std::uint8_t(seed >> 24));
    }
    return picture;
}

std::string textOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::uint32_t numberAt(const std::string& bytes, std::size_t at)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return value;
}

struct Chunk {
    std::string type, data;
};

/// The chunks, each with a right checksum.
std::vector<Chunk> chunksOf(const std::string& file)
{
    std::vector<Chunk> chunks;
    for (std::size_t at = 8; at < file.size();) {
        const std::uint32_t bytes = numberAt(file, at);
        const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(file.data() + at + 4), bytes + 4);
        EXPECT_EQ(numberAt(file, at + 8 + bytes), std::uint32_t(sum));
        chunks.push_back({file.substr(at + 4, 4), file.substr(at + 8, bytes)});
        at += bytes + 12;
    }
    return chunks;
}

TEST(PictureFormats, WebpKeepsEveryByteAlsoWhereItIsTransparent)
{
    const TempFolder folder;
    for (const int channels : {3, 4})
        for (const auto& [width, height] : {std::pair{1, 1}, {16, 16}, {123, 45}}) {
            const Picture picture = noise(width, height, channels, 5);
            writePicture(picture, folder.file("a.webp"));
            const std::string file = textOf(folder.file("a.webp"));
            const auto* bytes = reinterpret_cast<const std::uint8_t*>(file.data());
            int w = 0, h = 0;
            std::uint8_t* pixels =
                channels == 4 ? WebPDecodeRGBA(bytes, file.size(), &w, &h) : WebPDecodeRGB(bytes, file.size(), &w, &h);
            ASSERT_TRUE(pixels);
            EXPECT_EQ(w, width);
            EXPECT_EQ(h, height);
            EXPECT_TRUE(std::equal(picture.pixels.begin(), picture.pixels.end(), pixels)) << channels;
            WebPFree(pixels);
        }
}

TEST(PictureFormats, JpegIsNearAndKeepsColours)
{
    const TempFolder folder;
    Picture picture = noise(64, 48, 3, 5);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)  // Rows of one colour each, as in a legend.
        picture.pixels[i] = std::uint8_t((i / 192) * 5 + 80 * (i % 3));
    writePicture(picture, folder.file("a.jpg"));
    const std::string file = textOf(folder.file("a.jpg"));
    Picture decoded = noise(64, 48, 3, 6);
    tjhandle jpeg = tjInitDecompress();
    ASSERT_EQ(tjDecompress2(jpeg, reinterpret_cast<const unsigned char*>(file.data()), file.size(),
                            decoded.pixels.data(), 64, 0, 48, TJPF_RGB, 0),
              0);
    tjDestroy(jpeg);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) EXPECT_NEAR(decoded.pixels[i], picture.pixels[i], 8) << i;
}

TEST(PictureFormats, WhatAFormatHasNotIsRefused)
{
    const TempFolder folder;
    EXPECT_THROW(writePicture(noise(4, 4, 4, 1), folder.file("a.jpg")), InputError);
    EXPECT_THROW(writePicture(noise(16384, 1, 3, 1), folder.file("a.webp")), InputError);
    EXPECT_THROW(writePicture(noise(4, 4, 3, 1), folder.file("a.gif")), InputError);
    EXPECT_THROW(writePicture(noise(4, 4, 3, 1), folder.file("a.mp4")), InputError);
    EXPECT_THROW(writePicture(Picture{4, 4, 3, {}}, folder.file("a.webp")), std::runtime_error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Animation, ApngHoldsTheFramesPngsDataInOrder)
{
    const TempFolder folder;
    std::vector<Picture> frames;
    for (std::uint32_t i = 0; i < 3; ++i) frames.push_back(noise(37, 23, 4, i));
    const auto apng = makeApng({folder.file("a.apng"), 3, 12.5, "ffffff"});
    for (const Picture& frame : frames) apng->add(frame);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "nothing before it is complete";
    apng->complete();
    const std::vector<Chunk> chunks = chunksOf(textOf(folder.file("a.apng")));
    ASSERT_EQ(chunks[0].type, "IHDR");
    ASSERT_EQ(chunks[1].type, "acTL");
    EXPECT_EQ(numberAt(chunks[1].data, 0), 3u);
    EXPECT_EQ(chunks.back().type, "IEND");
    std::uint32_t sequence = 0;
    std::vector<std::string> data;  // Of each frame, unpacked.
    for (const Chunk& chunk : chunks) {
        if (chunk.type == "fcTL") {
            EXPECT_EQ(numberAt(chunk.data, 0), sequence++);
            EXPECT_EQ(numberAt(chunk.data, 4), 37u);
            EXPECT_EQ(numberAt(chunk.data, 8), 23u);
            EXPECT_EQ(numberAt(chunk.data, 20), 80u << 16 | 1000u) << "80 ms";
            data.emplace_back();
        } else if (chunk.type == "fdAT") {
            EXPECT_EQ(numberAt(chunk.data, 0), sequence++);
            data.back() += chunk.data.substr(4);
        } else if (chunk.type == "IDAT") {
            ASSERT_EQ(data.size(), 1u) << "the first frame is the picture of viewers that know no animations";
            data.back() += chunk.data;
        }
    }
    ASSERT_EQ(data.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {  // A PNG made of the frame's data shows the frame.
        const std::vector<Chunk> single = chunksOf(pngOf(frames[i], "x"));
        std::string expected;
        for (const Chunk& chunk : single)
            if (chunk.type == "IDAT") expected += chunk.data;
        EXPECT_EQ(data[i], expected) << i;
    }
}

TEST(Animation, WebpShowsEveryFrameForItsTime)
{
    const TempFolder folder;
    const auto webp = makeWebpAnimation({folder.file("a.webp"), 3, 8, "ffffff"});
    for (std::uint32_t i = 0; i < 3; ++i) webp->add(noise(40, 30, 3, i));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    webp->complete();
    const std::string file = textOf(folder.file("a.webp"));
    const WebPData data{reinterpret_cast<const std::uint8_t*>(file.data()), file.size()};
    WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, nullptr);
    ASSERT_TRUE(decoder);
    std::vector<int> ends;
    while (WebPAnimDecoderHasMoreFrames(decoder)) {
        std::uint8_t* pixels = nullptr;
        int endMs = 0;
        ASSERT_TRUE(WebPAnimDecoderGetNext(decoder, &pixels, &endMs));
        ends.push_back(endMs);
    }
    WebPAnimDecoderDelete(decoder);
    EXPECT_EQ(ends, (std::vector<int>{125, 250, 375}));
}

TEST(LoopPage, IsOneFileThatPlaysTheCycleInTheTimeOfAllFrames)
{
    const TempFolder folder;
    const std::string path = folder.file("a.html");
    SceneDescription scene;
    scene.lic.flow = FlowMotion::loop;
    scene.output.fps = 20;
    scene.shading.title = "<Wing> & \"tail\"";
    EXPECT_EQ(drawnFor("a.png", scene).output.frames, 1);
    EXPECT_EQ(drawnFor("a.webp", scene).output.frames, 48);
    EXPECT_EQ(drawnFor(path, scene).output.frames, 8);
    scene.output.frames = 60;
    EXPECT_EQ(drawnFor("a.webp", scene).output.frames, 60);
    EXPECT_EQ(drawnFor(path, scene).output.frames, 8);

    PictureFiles files(path, scene);
    for (std::uint32_t k = 0; k < 8; ++k) files.write(noise(40, 30, 3, k));
    EXPECT_FALSE(std::filesystem::exists(path));
    files.complete();
    const std::string text = textOf(path);
    EXPECT_NE(text.find("<title>&lt;Wing> &amp; &quot;tail&quot;</title>"), text.npos);
    EXPECT_NE(text.find("const SECONDS = 3;"), text.npos);
    for (const char* part : {"class GpuPlayer", "class CyclePainter", "const playerFor"})
        EXPECT_NE(text.find(part), text.npos) << part;
    EXPECT_EQ(text.find("import {"), text.npos);
    EXPECT_NE(text.find("background: #ffffff"), text.npos);
    for (const char* name : {"@TITLE@", "@BACKGROUND@", "@WIDTH@", "@HEIGHT@", "@COUNT@", "@SECONDS@", "@PLAYER@",
                             "@PICTURES@", "http:", "https:"})
        EXPECT_EQ(text.find(name), text.npos) << name;
    int pictures = 0;
    for (std::size_t at = 0; (at = text.find("'data:image/webp;base64,UklGR", at)) != text.npos; ++at) ++pictures;
    EXPECT_EQ(pictures, 8);
}

TEST(Animation, WhatIsGivenUpLeavesTheOldFile)
{
    const TempFolder folder;
    for (const char* name : {"a.apng", "a.webp"}) {
        std::ofstream(folder.file(name)) << "old";
        const AnimationPlan plan{folder.file(name), 2, 25, "ffffff"};
        const auto animation = name[2] == 'a' ? makeApng(plan) : makeWebpAnimation(plan);
        animation->add(noise(8, 8, 3, 1));
    }
    EXPECT_EQ(textOf(folder.file("a.apng")), "old");
    EXPECT_EQ(textOf(folder.file("a.webp")), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

}  // namespace
}  // namespace aeolic
