#include "render/lic/noise.h"

#include <cmath>
#include <vector>

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

constexpr std::size_t kTexels = std::size_t(NoisePyramid::kSize) * NoisePyramid::kSize * NoisePyramid::kSize;

std::vector<bool> whiteTexels(std::uint32_t key)
{
    std::vector<bool> white(kTexels);
    for (std::size_t i = 0; i < kTexels; ++i) white[i] = (hash(std::uint32_t(i) ^ key) >> 31) != 0;
    return white;
}

/// Texels in an order without a pattern, each once; one becomes a grain where none is near (Cook 1986, darts).
std::vector<bool> grainTexels(std::uint32_t key)
{
    constexpr int reach = 2, mask = NoisePyramid::kSize - 1;
    constexpr std::uint32_t all = std::uint32_t(kTexels) - 1;
    static_assert((kTexels & all) == 0 && reach * reach < grains::kApart2 && 3 * 3 >= grains::kApart2);
    std::vector<bool> grain(kTexels), taken(kTexels);
    for (std::uint32_t i = 0; i <= all; ++i) {
        // A permutation of 18 bits: odd factors and shifts to the right have an inverse each.
        std::uint32_t texel = (i * 0x2c1b3u + key) & all;
        texel = ((texel ^ texel >> 9) * 0x1d2a5u) & all;
        texel = ((texel ^ texel >> 7) * 0x3335bu) & all;
        texel ^= texel >> 10;
        if (taken[texel]) continue;
        grain[texel] = true;
        const int x = int(texel & mask), y = int(texel >> 6 & mask), z = int(texel >> 12);
        for (int dz = -reach; dz <= reach; ++dz)
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx)
                    if (dx * dx + dy * dy + dz * dz < grains::kApart2)
                        taken[NoisePyramid::index(std::size_t((x + dx) & mask), std::size_t((y + dy) & mask),
                                                  std::size_t((z + dz) & mask))] = true;
    }
    return grain;
}

}  // namespace

NoisePyramid::NoisePyramid(std::uint32_t theSeed, Style theStyle)
    : cells(kTexels + kPadding), style(theStyle), seed(theSeed)
{
    constexpr std::size_t mask = kSize - 1;
    const std::uint32_t key = hash(seed ^ 0x9e3779b9u);
    const std::vector<bool> texels = style == Style::oriented ? grainTexels(key) : whiteTexels(key);
    for (std::size_t z = 0; z < kSize; ++z)
        for (std::size_t y = 0; y < kSize; ++y)
            for (std::size_t x = 0; x < kSize; ++x) {
                std::uint32_t cell = 0;
                for (std::size_t c = 0; c < 8; ++c) {
                    const std::size_t texel =
                        index((x + (c & 1)) & mask, (y + (c >> 1 & 1)) & mask, (z + (c >> 2)) & mask);
                    cell |= std::uint32_t(texels[texel]) << c;
                }
                cells[index(x, y, z)] = std::uint8_t(cell);
            }
}

NoiseLookup makeNoiseLookup(double sceneDiagonal, double noiseScale, Style style)
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
    if (style == Style::oriented) {
        lookup.grains = GrainValue::height;
        lookup.levelFromFootprint *= grains::kTexelPx;
    }
    return lookup;
}

}  // namespace aeolic
