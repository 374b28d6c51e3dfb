#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace aeolic {

/// A bit for each pixel of an image: whether something covers it.
struct CoverageBits {
    int height = 0;
    std::size_t wordsPerRow = 0;
    std::vector<std::uint64_t> words;  ///< [height][wordsPerRow], bit x % 64 of word x / 64; beyond the width 0.

    /// The bytes that the words of an image so large take.
    static std::int64_t bytes(int width, int rows) { return std::int64_t(width + 63) / 64 * 8 * rows; }

    /// Nothing is covered.
    void clear(int width, int rows)
    {
        height = rows;
        wordsPerRow = std::size_t(width + 63) / 64;
        words.assign(std::size_t(rows) * wordsPerRow, 0);
    }

    std::int64_t pixels(int row) const
    {
        std::int64_t count = 0;
        for (std::size_t i = 0; i < wordsPerRow; ++i) count += std::popcount(words[std::size_t(row) * wordsPerRow + i]);
        return count;
    }

    /// Covered pixels of every row, [height].
    std::vector<std::int64_t> pixelsPerRow() const
    {
        std::vector<std::int64_t> covered;
        covered.reserve(std::size_t(height));
        for (int y = 0; y < height; ++y) covered.push_back(pixels(y));
        return covered;
    }

    /// How many times covered pixels begin in each row, [height].
    std::vector<std::int64_t> runsPerRow() const
    {
        std::vector<std::int64_t> runs(std::size_t(height), 0);
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::uint64_t before = i % wordsPerRow > 0 ? words[i - 1] >> 63 : 0;
            runs[i / wordsPerRow] += std::popcount(words[i] & ~(words[i] << 1 | before));
        }
        return runs;
    }
};

}  // namespace aeolic
