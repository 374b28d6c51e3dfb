#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>
#include <turbojpeg.h>
#include <zlib.h>

#include <cstring>
#include <random>
#include <string>

#include "stream/codec/codec.h"
#include "stream/codec/codec_testing.h"
#include "stream/wire.h"

/// Decoders against bytes that lie. With the address sanitizer these also show that no byte out of bounds is touched.
namespace aeolic::stream {
namespace {

using Bytes = std::vector<std::uint8_t>;
using test::encoded, test::noise, test::Picture, test::streaks;

/// A copy that ends where its memory ends: a sanitizer sees any byte read beyond.
Bytes exact(const Bytes& bytes)
{
    return {bytes.begin(), bytes.end()};
}

::testing::AssertionResult isRefused(Codec codec, const Bytes& bytes, int width, int rows, int channels)
{
    Bytes out;
    try {
        decode(codec, exact(bytes), width, rows, channels, out);
    } catch (const ProtocolError& error) {
        const std::string message = error.what();
        if (message.empty() || message.find('\n') != std::string::npos)
            return ::testing::AssertionFailure() << "message: " << message;
        return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure() << codecName(codec) << ": " << bytes.size() << " bytes were taken";
}

void putBigEndian(Bytes& bytes, std::size_t at, std::uint32_t value)
{
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = std::uint8_t(value >> (24 - 8 * i));
}

/// A PNG file's header says another size, with the right check sum.
Bytes withPngSize(Bytes file, std::uint32_t width, std::uint32_t rows)
{
    putBigEndian(file, 16, width);
    putBigEndian(file, 20, rows);
    putBigEndian(file, 29, crc32(std::span(file).subspan(12, 17)));
    return file;
}

Bytes pngChunk(const char* type, const Bytes& data)
{
    Bytes chunk(8 + data.size() + 4);
    putBigEndian(chunk, 0, std::uint32_t(data.size()));
    std::memcpy(chunk.data() + 4, type, 4);
    if (!data.empty()) std::memcpy(chunk.data() + 8, data.data(), data.size());
    putBigEndian(chunk, 8 + data.size(), crc32(std::span(chunk).subspan(4, 4 + data.size())));
    return chunk;
}

Bytes deflated(const Bytes& bytes)
{
    Bytes out(compressBound(bytes.size()));
    uLongf size = out.size();
    EXPECT_EQ(compress2(out.data(), &size, bytes.data(), bytes.size(), 9), Z_OK);
    out.resize(size);
    return out;
}

/// A JPEG file made by TurboJPEG, with settings that encode() never uses.
Bytes otherJpeg(const Picture& picture, int sampling, int flags)
{
    const tjhandle handle = tjInitCompress();
    unsigned char* file = nullptr;
    unsigned long size = 0;
    EXPECT_EQ(tjCompress2(handle, picture.bytes.data(), picture.width, 0, picture.rows, TJPF_RGB, &file, &size,
                          sampling, 80, flags),
              0);
    const Bytes bytes(file, file + size);
    tjFree(file);
    tjDestroy(handle);
    return bytes;
}

TEST(CodecHostile, EveryTruncationIsRefused)
{
    const Picture picture = streaks(40, 20, 3);
    for (const Codec codec : test::everyCodec()) {
        const Bytes whole = encoded(codec, picture);
        for (std::size_t size = 0; size < whole.size(); ++size)
            ASSERT_TRUE(isRefused(codec, Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size)), 40, 20, 3))
                << size;
    }
}

TEST(CodecHostile, BytesAfterTheEndAreRefused)
{
    const Picture picture = streaks(40, 20, 3);
    for (const Codec codec : test::everyCodec())
        for (const std::size_t more : {1, 2, 1000}) {
            Bytes bytes = encoded(codec, picture);
            bytes.resize(bytes.size() + more);
            EXPECT_TRUE(isRefused(codec, bytes, 40, 20, 3)) << more;
        }
}

TEST(CodecHostile, AnotherSizeThanSaidIsRefused)
{
    const Picture picture = streaks(40, 20, 3);
    for (const Codec codec : test::everyCodec()) {
        const Bytes bytes = encoded(codec, picture);
        for (const auto& [width, rows] : {std::pair{40, 19}, {40, 21}, {39, 20}, {41, 20}, {1, 1}, {4000, 2000}})
            EXPECT_TRUE(isRefused(codec, bytes, width, rows, 3)) << width << "x" << rows;
        EXPECT_EQ(bool(isRefused(codec, bytes, 40, 20, 4)), codec != Codec::jpeg)
            << codecName(codec);  // JPEG has no alpha.
    }
}

TEST(CodecHostile, SizesAndCodecsOutOfRangeAreRefused)
{
    const Bytes bytes = encoded(Codec::lz4, streaks(8, 8, 3));
    for (const Codec codec : {Codec::raw, Codec::jpeg, Codec::png, Codec::lz4, Codec::lzo, Codec(5), Codec(255)}) {
        EXPECT_TRUE(isRefused(codec, bytes, 0, 8, 3));
        EXPECT_TRUE(isRefused(codec, bytes, -8, -8, 3));
        EXPECT_TRUE(isRefused(codec, bytes, 8, 8, 0));
        EXPECT_TRUE(isRefused(codec, bytes, 8, 8, 1 << 30));
        EXPECT_TRUE(isRefused(codec, bytes, 32769, 1, 3));
        EXPECT_TRUE(isRefused(codec, bytes, 32768, 32768, 4));
        EXPECT_TRUE(isRefused(codec, bytes, 1 << 30, 1 << 30, 4));
    }
    EXPECT_TRUE(isRefused(Codec(5), bytes, 8, 8, 3));
    // Where there is LZO, another codec's block takes it no further.
    EXPECT_TRUE(isRefused(Codec::lzo, bytes, 8, 8, 3));
}

TEST(CodecHostile, FlippedBitsNeverEscape)
{
    const Picture picture = streaks(24, 12, 3);
    for (const Codec codec : test::everyCodec()) {
        const Bytes whole = encoded(codec, picture);
        int refused = 0;
        for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
            Bytes bytes = whole;
            bytes[bit / 8] ^= std::uint8_t(1 << bit % 8);
            Bytes out;
            try {
                decode(codec, bytes, 24, 12, 3, out);
                ASSERT_EQ(out.size(), picture.bytes.size());
            } catch (const ProtocolError&) {
                ++refused;
            }
        }
        // PNG has checksums of its own. For the other codecs the CRC-32 of the tile finds the damage.
        EXPECT_GE(refused, codec == Codec::png ? int(whole.size() * 8) : 0);
    }
}

TEST(CodecHostile, MutationsNeverEscape)
{
    constexpr int kSeeds = 4000;
    const Picture pictures[] = {streaks(31, 9, 3), noise(31, 9, 3), streaks(1, 1, 3)};
    for (const Codec codec : test::everyCodec()) {
        const Bytes whole[] = {encoded(codec, pictures[0]), encoded(codec, pictures[1]), encoded(codec, pictures[2])};
        for (unsigned seed = 0; seed < kSeeds; ++seed) {
            std::mt19937 random(seed);
            const auto below = [&](std::size_t limit) { return limit ? random() % limit : 0; };
            const std::size_t which = below(3);
            Bytes bytes = whole[which];
            for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
                const std::size_t at = below(bytes.size()),
                                  length = below(std::min<std::size_t>(bytes.size() - at, 40));
                const auto from = bytes.begin() + std::ptrdiff_t(at), to = from + std::ptrdiff_t(length);
                switch (below(5)) {
                    case 0:
                        if (!bytes.empty()) bytes[at] = std::uint8_t(random());
                        break;
                    case 1:
                        if (!bytes.empty()) bytes[at] = random() % 2 ? 0xFF : 0x00;
                        break;
                    case 2:
                        bytes.erase(from, to);
                        break;
                    case 3: {
                        const Bytes piece(from, to);
                        bytes.insert(bytes.begin() + std::ptrdiff_t(below(bytes.size() + 1)), piece.begin(),
                                     piece.end());
                        break;
                    }
                    default: {
                        const Bytes& other = whole[below(3)];
                        bytes.resize(at);
                        bytes.insert(bytes.end(), other.begin() + std::ptrdiff_t(std::min(at, other.size())),
                                     other.end());
                    }
                }
            }
            const Picture& picture = pictures[which];
            Bytes out;
            try {
                decode(codec, exact(bytes), picture.width, picture.rows, picture.channels, out);
                ASSERT_EQ(out.size(), picture.bytes.size()) << codecName(codec) << " seed " << seed;
            } catch (const ProtocolError&) {
            }
        }
    }
}

TEST(CodecHostile, APngHeaderOf65535x65535TakesNoMemory)
{
    const Bytes bomb = withPngSize(encoded(Codec::png, streaks(16, 16, 4)), 65535, 65535);
    EXPECT_TRUE(isRefused(Codec::png, bomb, 16, 16, 4));
    EXPECT_TRUE(isRefused(Codec::png, withPngSize(bomb, 0xFFFFFFFF, 0xFFFFFFFF), 16, 16, 4));
    EXPECT_TRUE(isRefused(Codec::png, withPngSize(bomb, 0, 16), 16, 16, 4));
}

TEST(CodecHostile, APngWithMoreRowsThanItSaysIsRefused)
{
    // 64 rows of pixels behind a header of 16.
    const Bytes bytes = withPngSize(encoded(Codec::png, streaks(16, 64, 3)), 16, 16);
    EXPECT_TRUE(isRefused(Codec::png, bytes, 16, 16, 3));
}

TEST(CodecHostile, APngsTextIsNotUnpacked)
{
    // 64 MiB of one letter in a zTXt chunk of 64 KiB.
    Bytes text{'k', 0, 0};
    const Bytes packed = deflated(Bytes(std::size_t(64) << 20, 'a'));
    text.insert(text.end(), packed.begin(), packed.end());
    const Bytes chunk = pngChunk("zTXt", text);
    const Picture picture = streaks(16, 16, 3);
    Bytes bytes = encoded(Codec::png, picture);
    bytes.insert(bytes.begin() + 33, chunk.begin(), chunk.end());
    const auto peakKiB = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss;
    };
    Bytes out;
    const long before = peakKiB();
    decode(Codec::png, bytes, 16, 16, 3, out);  // It is a valid PNG file.
    EXPECT_EQ(out, picture.bytes);
    EXPECT_LT(peakKiB() - before, 16 * 1024);
}

TEST(CodecHostile, OtherKindsOfPngAreRefused)
{
    const Bytes rgb = encoded(Codec::png, streaks(16, 16, 3));
    EXPECT_TRUE(isRefused(Codec::png, rgb, 16, 16, 4));
    for (const std::size_t field : {24, 25, 28}) {  // Bit depth, colour type, interlace.
        for (const int value : {0, 1, 2, 3, 4, 6, 8, 16}) {
            Bytes bytes = rgb;
            if (bytes[field] == value) continue;
            bytes[field] = std::uint8_t(value);
            putBigEndian(bytes, 29, crc32(std::span(bytes).subspan(12, 17)));
            EXPECT_TRUE(isRefused(Codec::png, bytes, 16, 16, 3)) << field << " " << value;
        }
    }
}

TEST(CodecHostile, AnLz4BlockThatExpandsBeyondThePixelsIsRefused)
{
    // One literal, then a match of 15 + 4 + 255 * 100000 bytes: 100 KB that would become 25 MB.
    Bytes bomb{0x1F, 0, 1, 0};
    bomb.insert(bomb.end(), 100000, 255);
    bomb.insert(bomb.end(), {0, 0x50, 0, 0, 0, 0, 0});
    EXPECT_TRUE(isRefused(Codec::lz4, bomb, 64, 64, 3));
    const Bytes beforeTheStart{0x10, 7, 9, 0, 0x50, 1, 2, 3, 4, 5};  // A match that begins 9 bytes before one byte.
    EXPECT_TRUE(isRefused(Codec::lz4, beforeTheStart, 2, 2, 3));
    EXPECT_TRUE(isRefused(Codec::lz4, {0xF0, 255, 255, 255}, 2, 2, 3));  // Literals that are not there.
    EXPECT_TRUE(isRefused(Codec::lz4, {0x00}, 1, 1, 3));
}

TEST(CodecHostile, JpegKindsThatCostDecodersDearlyAreRefused)
{
    const Picture picture = streaks(48, 32, 3);
    Bytes out;
    decode(Codec::jpeg, otherJpeg(picture, TJSAMP_422, 0), 48, 32, 3, out);  // Other encoders' samplings are welcome.
    EXPECT_TRUE(isRefused(Codec::jpeg, otherJpeg(picture, TJSAMP_420, TJFLAG_PROGRESSIVE), 48, 32, 3));
    EXPECT_TRUE(isRefused(Codec::jpeg, otherJpeg(picture, TJSAMP_GRAY, 0), 48, 32, 3));
    // 65535 x 65535 in the frame header of a small file.
    Bytes bomb = encoded(Codec::jpeg, picture);
    for (std::size_t i = 0; i + 9 < bomb.size(); ++i)
        if (bomb[i] == 0xFF && bomb[i + 1] == 0xC0) std::fill_n(bomb.begin() + std::ptrdiff_t(i) + 5, 4, 0xFF);
    EXPECT_TRUE(isRefused(Codec::jpeg, bomb, 48, 32, 3));
    EXPECT_TRUE(isRefused(Codec::jpeg, {0xFF, 0xD8, 0xFF, 0xD9}, 48, 32, 3));
    EXPECT_TRUE(isRefused(Codec::jpeg, {0xFF, 0xD8, 0xFF, 0xE0, 0xFF, 0xFF, 0xFF, 0xD9}, 48, 32, 3));
    EXPECT_TRUE(isRefused(Codec::jpeg, {0xFF, 0xD8, 0xFF, 0xE0, 0x00, 0x00, 0xFF, 0xD9}, 48, 32, 3));
}

}  // namespace
}  // namespace aeolic::stream
