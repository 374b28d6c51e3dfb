#include <bit>

#include "data/hdf5/hdf5_store.h"

namespace aeolic {

/// hashlittle() of lookup3.c, by Bob Jenkins, who put it into the public domain. It begins with 0.
std::uint32_t hdf5Checksum(std::span<const std::uint8_t> bytes)
{
    std::uint32_t a = 0xdeadbeef + std::uint32_t(bytes.size()), b = a, c = a;
    const auto add = [&](std::size_t at, std::size_t count) {
        std::uint32_t* words[] = {&a, &b, &c};
        for (std::size_t i = 0; i < count; ++i) *words[i / 4] += std::uint32_t(bytes[at + i]) << (8 * (i % 4));
    };
    std::size_t at = 0;
    for (; bytes.size() - at > 12; at += 12) {
        add(at, 12);
        const auto mix = [](std::uint32_t& x, std::uint32_t& y, std::uint32_t& z, int bits) {
            x -= z;
            x ^= std::rotl(z, bits);
            z += y;
        };
        mix(a, b, c, 4);
        mix(b, c, a, 6);
        mix(c, a, b, 8);
        mix(a, b, c, 16);
        mix(b, c, a, 19);
        mix(c, a, b, 4);
    }
    if (at == bytes.size()) return c;
    add(at, bytes.size() - at);
    const auto finish = [](std::uint32_t& x, std::uint32_t y, int bits) {
        x ^= y;
        x -= std::rotl(y, bits);
    };
    finish(c, b, 14);
    finish(a, c, 11);
    finish(b, a, 25);
    finish(c, b, 16);
    finish(a, c, 4);
    finish(b, a, 14);
    finish(c, b, 24);
    return c;
}

}  // namespace aeolic
