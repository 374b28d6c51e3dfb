#include "render/lic/noise.h"

#include <cmath>

namespace aeolic {
namespace {

// Integer hash with full avalanche (Wang/Murmur finaliser); the tile is a pure function of seed and texel.
std::uint32_t hash(std::uint32_t x)
{
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

}  // namespace

NoisePyramid::NoisePyramid(std::uint32_t theSeed) : cells(std::size_t(kSize) * kSize * kSize + kPadding), seed(theSeed)
{
    constexpr std::size_t mask = kSize - 1;
    const std::uint32_t key = hash(seed ^ 0x9e3779b9u);
    const auto texel = [&](std::size_t x, std::size_t y, std::size_t z) {
        return hash(std::uint32_t(index(x & mask, y & mask, z & mask)) ^ key) >> 31;
    };
    for (std::size_t z = 0; z < kSize; ++z)
        for (std::size_t y = 0; y < kSize; ++y)
            for (std::size_t x = 0; x < kSize; ++x) {
                std::uint32_t cell = 0;
                for (std::size_t c = 0; c < 8; ++c) cell |= texel(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)) << c;
                cells[index(x, y, z)] = std::uint8_t(cell);
            }
}

NoiseLookup makeNoiseLookup(double sceneDiagonal, double noiseScale)
{
    // Euler angles without rational relations: no axis-aligned or diagonal plane meets the tile's period.
    const double a = 0.6180339887, b = 0.7548776662, c = 0.5698402910;
    const glm::dmat3 rx(1, 0, 0, 0, std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a));
    const glm::dmat3 ry(std::cos(b), 0, -std::sin(b), 0, 1, 0, std::sin(b), 0, std::cos(b));
    const glm::dmat3 rz(std::cos(c), std::sin(c), 0, -std::sin(c), std::cos(c), 0, 0, 0, 1);
    const double base = (sceneDiagonal > 0 ? sceneDiagonal : 1.0) / 1024.0;
    NoiseLookup lookup;
    lookup.texelFromLocal = rz * ry * rx;
    for (int i = 0; i < 3; ++i) lookup.texelFromLocal[i] /= base;
    lookup.levelFromFootprint = NoisePyramid::kTexelPerPixel / (base * noiseScale);
    return lookup;
}

}  // namespace aeolic
