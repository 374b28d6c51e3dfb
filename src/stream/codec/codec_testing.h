#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "stream/codec/codec.h"

/// What several suites about tiles share.
namespace aeolic::stream::test {

/// A picture with its memory.
struct Picture {
    int width, rows, channels;
    std::vector<std::uint8_t> bytes;

    Pixels pixels() const { return {bytes.data(), width, rows, channels}; }
};

/// Streaks across a colour that changes slowly, beside an empty background: what tiles look like.
inline Picture streaks(int width, int rows, int channels, unsigned seed = 1)
{
    Picture picture{width, rows, channels, {}};
    std::mt19937 random(seed);
    double light = 0.5;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < width; ++x) {
            light += 0.2 * (double(random() % 1000) / 999 - light);
            const bool covered = x < width * 2 / 3 + 1;
            const double color[3] = {200.0 * x / width, 120, 255.0 * y / rows};
            for (const double c : color)
                picture.bytes.push_back(covered ? std::uint8_t(std::lround(c * light)) : std::uint8_t(255));
            if (channels == 4) picture.bytes.push_back(covered ? 255 : 0);
        }
    return picture;
}

/// What no codec can make smaller.
inline Picture noise(int width, int rows, int channels, unsigned seed = 1)
{
    Picture picture{width, rows, channels, {}};
    std::mt19937 random(seed);
    picture.bytes.resize(picture.pixels().bytes());
    for (std::uint8_t& byte : picture.bytes) byte = std::uint8_t(random());
    return picture;
}

inline std::vector<std::uint8_t> encoded(Codec codec, const Picture& picture, int quality = 80)
{
    std::vector<std::uint8_t> out;
    encode(codec, picture.pixels(), quality, out);
    return out;
}

/// Every lossless codec of this build.
inline std::vector<Codec> losslessCodecs()
{
    std::vector<Codec> codecs;
    for (const Codec codec : {Codec::raw, Codec::png, Codec::lz4, Codec::lzo})
        if (available(codec)) codecs.push_back(codec);
    return codecs;
}

inline std::vector<Codec> everyCodec()
{
    std::vector<Codec> codecs = losslessCodecs();
    codecs.push_back(Codec::jpeg);
    return codecs;
}

}  // namespace aeolic::stream::test
