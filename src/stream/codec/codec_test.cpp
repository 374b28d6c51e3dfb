#include "stream/codec/codec.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>

#include "stream/codec/codec_testing.h"
#include "stream/wire.h"
#include "version.h"

namespace aeolic::stream {
namespace {

using Bytes = std::vector<std::uint8_t>;
using test::encoded, test::noise, test::Picture, test::streaks;

Bytes decoded(Codec codec, const Bytes& bytes, const Picture& like)
{
    Bytes out;
    decode(codec, bytes, like.width, like.rows, like.channels, out);
    return out;
}

double psnrDb(const Bytes& a, const Bytes& b)
{
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(double(a[i]) - double(b[i]), 2);
    return 10 * std::log10(255.0 * 255.0 * double(a.size()) / squares);
}

TEST(Codec, NamesAndNumbersAreThoseOfTheWire)
{
    const std::pair<int, const char*> onTheWire[] = {{0, "raw"}, {1, "jpeg"}, {2, "png"}, {3, "lz4"}, {4, "lzo"}};
    for (const auto& [number, name] : onTheWire) {
        EXPECT_EQ(codecName(Codec(number)), name);
        EXPECT_EQ(codecFromName(name), Codec(number));
    }
    for (const char* name : {"", "LZ4", "lz4 ", "jpg", "unknown"}) EXPECT_EQ(codecFromName(name), std::nullopt) << name;
    EXPECT_EQ(codecName(Codec(5)), "unknown");
    for (int number = 0; number < 256; ++number) {
        EXPECT_EQ(available(Codec(number)), number < 4 || (number == 4 && builtWithLzo)) << number;
    }
}

TEST(Codec, Crc32IsThatOfZlibAndPng)
{
    const std::string check = "123456789";  // The catalogued check value of CRC-32/ISO-HDLC.
    EXPECT_EQ(crc32({reinterpret_cast<const std::uint8_t*>(check.data()), check.size()}), 0xCBF43926u);
    EXPECT_EQ(crc32({}), 0u);
}

TEST(Codec, Lz4BytesOfATinyTile)
{
    // Too short for a match: one token, 12 literals, which are the filtered rows.
    const Picture picture{2, 2, 3, {10, 20, 30, 13, 18, 30, 1, 2, 3, 0, 0, 0}};
    EXPECT_EQ(encoded(Codec::lz4, picture), (Bytes{0xC0, 20, 254, 246, 5, 10, 2, 2, 254, 255, 1, 1, 255}));
    // A block with a match, written by hand: 3 literals, 8 bytes from 3 before (token 0x34), 5 literals. Filtered
    // planes 1 2 3 1 | 2 3 1 2 | 3 1 2 4 | 5 6 7 8, that is green 1 3 6 7, red less green 2 5 6 8 and so on.
    const Bytes repeated{0x34, 1, 2, 3, 3, 0, 0x50, 4, 5, 6, 7, 8};
    EXPECT_EQ(decoded(Codec::lz4, repeated, {4, 1, 4, {}}),
              (Bytes{3, 1, 4, 5, 8, 3, 7, 11, 12, 6, 12, 18, 15, 7, 17, 26}));
}

TEST(Codec, RawBytesAreThePixels)
{
    const Picture picture = noise(5, 3, 3);
    EXPECT_EQ(encoded(Codec::raw, picture), picture.bytes);
    EXPECT_EQ(decoded(Codec::raw, picture.bytes, picture), picture.bytes);
}

TEST(Codec, LosslessOnesComeBackAtEveryOddSize)
{
    const int sizes[][2] = {{1, 1}, {1, 7}, {2, 1}, {3, 5}, {17, 16}, {101, 33}, {32768, 1}, {1, 32768}, {32768, 3}};
    for (const Codec codec : test::losslessCodecs())
        for (const auto& size : sizes)
            for (const int channels : {3, 4})
                for (const Picture& picture :
                     {streaks(size[0], size[1], channels), noise(size[0], size[1], channels)}) {
                    const Bytes bytes = encoded(codec, picture);
                    ASSERT_EQ(decoded(codec, bytes, picture), picture.bytes)
                        << codecName(codec) << " " << size[0] << "x" << size[1] << "x" << channels;
                }
}

TEST(Codec, TheLargestTileComesBack)
{
    Picture picture{kLongestTileSide, 512, 4, {}};
    ASSERT_EQ(picture.pixels().bytes(), kLargestTileBytes);
    picture.bytes.assign(kLargestTileBytes, 255);
    for (std::size_t i = 0; i < kLargestTileBytes; i += 97) picture.bytes[i] = std::uint8_t(i);
    for (const Codec codec : {Codec::raw, Codec::lz4, Codec::lzo})
        ASSERT_TRUE(!available(codec) || decoded(codec, encoded(codec, picture), picture) == picture.bytes);
    EXPECT_EQ(decoded(Codec::jpeg, encoded(Codec::jpeg, picture), picture).size(), kLargestTileBytes);
}

TEST(Codec, LosslessOnesShrinkStreaks)
{
    const Picture picture = streaks(400, 64, 3);
    for (const Codec codec : test::losslessCodecs()) {
        if (codec == Codec::raw) continue;
        EXPECT_LT(encoded(codec, picture).size(), picture.bytes.size() * 3 / 4) << codecName(codec);
    }
}

TEST(Codec, JpegIsNearAndNearerWithMoreQuality)
{
    for (const auto& [width, rows] : {std::pair{400, 64}, {401, 33}, {16, 1}, {1, 16}, {32768, 2}}) {
        const Picture picture = streaks(width, rows, 3);
        double last = 0;
        std::size_t lastSize = 0;
        for (const int quality : {30, 60, 89, 100}) {
            const Bytes bytes = encoded(Codec::jpeg, picture, quality);
            const double psnr = psnrDb(decoded(Codec::jpeg, bytes, picture), picture.bytes);
            EXPECT_GT(psnr, last) << width << "x" << rows << " quality " << quality;
            EXPECT_GT(bytes.size(), lastSize);
            last = psnr, lastSize = bytes.size();
        }
        EXPECT_GT(last, 40);
    }
}

TEST(Codec, JpegOfOneColourIsThatColour)
{
    Picture picture{40, 24, 3, {}};
    for (int i = 0; i < 40 * 24; ++i) picture.bytes.insert(picture.bytes.end(), {200, 90, 30});
    const Bytes back = decoded(Codec::jpeg, encoded(Codec::jpeg, picture, 90), picture);
    for (std::size_t i = 0; i < back.size(); ++i) ASSERT_NEAR(back[i], picture.bytes[i], 3) << i;
}

TEST(Codec, JpegLeavesAlphaOut)
{
    const Picture rgb = streaks(33, 20, 3), rgba = streaks(33, 20, 4);
    const Bytes bytes = encoded(Codec::jpeg, rgba);
    EXPECT_EQ(bytes, encoded(Codec::jpeg, rgb));
    const Bytes back = decoded(Codec::jpeg, bytes, rgba);
    for (std::size_t i = 3; i < back.size(); i += 4) ASSERT_EQ(back[i], 255);
}

TEST(Codec, AnotherReaderReadsThePng)
{
    const Picture picture = streaks(61, 40, 4);
    const Bytes bytes = encoded(Codec::png, picture);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size())) << image.message;
    EXPECT_EQ(image.width, 61u);
    EXPECT_EQ(image.height, 40u);
    image.format = PNG_FORMAT_RGBA;
    Bytes back(PNG_IMAGE_SIZE(image));
    ASSERT_TRUE(png_image_finish_read(&image, nullptr, back.data(), 0, nullptr)) << image.message;
    EXPECT_EQ(back, picture.bytes);
}

TEST(Codec, EncodeKeepsWhatIsThereAndAllocatesNothingWhereThereIsRoom)
{
    const Picture picture = streaks(50, 20, 3);
    for (const Codec codec : test::everyCodec()) {
        const Bytes alone = encoded(codec, picture);
        Bytes out{1, 2, 3};
        out.reserve(3 + alone.size());
        const std::uint8_t* memory = out.data();
        encode(codec, picture.pixels(), 80, out);
        EXPECT_EQ(out.data(), memory) << codecName(codec);
        Bytes expected{1, 2, 3};
        expected.insert(expected.end(), alone.begin(), alone.end());
        EXPECT_EQ(out, expected) << codecName(codec);
    }
}

TEST(Codec, SameBytesFromManyThreadsAtOnce)
{
    const Picture picture = streaks(200, 64, 3);
    for (const Codec codec : test::everyCodec()) {
        const Bytes expected = encoded(codec, picture);
        std::vector<std::thread> threads;
        std::vector<int> same(4);
        for (int t = 0; t < 4; ++t)
            threads.emplace_back([&, t] {
                for (int i = 0; i < 10; ++i) same[std::size_t(t)] += encoded(codec, picture) == expected;
            });
        for (std::thread& thread : threads) thread.join();
        EXPECT_EQ(same, (std::vector<int>(4, 10))) << codecName(codec);
    }
}

TEST(Codec, EncodeRefusesWhatNoTileMayBe)
{
    const Bytes memory(64);
    Bytes out{7};
    const auto refused = [&](Codec codec, int width, int rows, int channels, int quality = 80) {
        EXPECT_THROW(encode(codec, {memory.data(), width, rows, channels}, quality, out), std::invalid_argument);
        EXPECT_EQ(out, Bytes{7});
    };
    for (const Codec codec : test::everyCodec()) {
        refused(codec, 0, 1, 3);
        refused(codec, 1, 0, 3);
        refused(codec, -1, -1, 3);
        refused(codec, 1, 1, 1);
        refused(codec, 1, 1, 5);
        refused(codec, kLongestTileSide + 1, 1, 3);
        refused(codec, kLongestTileSide, kLongestTileSide, 3);
    }
    refused(Codec::jpeg, 1, 1, 3, 0);
    refused(Codec::jpeg, 1, 1, 3, 101);
    refused(Codec(9), 1, 1, 3);
    if (!available(Codec::lzo)) refused(Codec::lzo, 1, 1, 3);
}

}  // namespace
}  // namespace aeolic::stream
