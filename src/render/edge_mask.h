#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/extent.h"
#include "render/coverage_bits.h"

namespace aeolic {

/// Which pixels of some rows lie at an edge: a silhouette, a crease, a line where two surfaces cross.
struct EdgeMask {
    Extent rows;        ///< Global pixels, all columns of the image.
    CoverageBits bits;  ///< Row 0 is rows.y0.

    void clear(const Extent& all)
    {
        rows = all;
        bits.clear(all.width(), all.height());
    }
    std::uint64_t* row(int y) { return &bits.words[std::size_t(y - rows.y0) * bits.wordsPerRow]; }
    const std::uint64_t* row(int y) const { return &bits.words[std::size_t(y - rows.y0) * bits.wordsPerRow]; }
};

/// Quick answers to whether a box may have pixels of a mask. Local. Cost: a pass over the mask's words.
class MarkedBoxes {
public:
    explicit MarkedBoxes(const EdgeMask& mask) : mask_(mask), words_(mask.bits.wordsPerRow)
    {
        const int blockRows = (mask.rows.height() + kBlock - 1) / kBlock;
        near_.assign(std::size_t(blockRows + 1) * words_, 0);
        for (int y = mask.rows.y0; y < mask.rows.y1; ++y)
            for (std::size_t w = 0; w < words_; ++w)
                near_[std::size_t((y - mask.rows.y0) / kBlock) * words_ + w] |= mask.row(y)[w];
        // A byte is a block's eight columns. It takes those of the next blocks, too.
        for (std::size_t i = 0; i + words_ < near_.size(); ++i) near_[i] |= near_[i + words_];
        for (std::size_t i = 0; i < near_.size(); ++i) {
            const bool isLast = i % words_ + 1 == words_;
            near_[i] |= (near_[i] >> kBlock) | (isLast ? 0 : near_[i + 1] << (kWord - kBlock));
        }
    }

    /// Whether a pixel of the box, which is not empty and lies within the mask's rows, may be marked. Of large boxes,
    /// which are rare, nothing is looked at.
    bool mayHave(const Extent& box) const
    {
        const int column = box.x0 / kBlock, row = (box.y0 - mask_.rows.y0) / kBlock;
        const bool isSmall = box.x1 <= (column + 2) * kBlock && box.y1 - mask_.rows.y0 <= (row + 2) * kBlock;
        if (!isSmall) return box.width() > kWord || box.height() > kWord || looksMarked(box);
        const std::uint64_t word = near_[std::size_t(row) * words_ + std::size_t(box.x0 / kWord)];
        return ((word >> (column * kBlock % kWord)) & 0xFFu) != 0 && looksMarked(box);
    }

    /// Whether mayHave() of such a box can say yes. Its first pixel lies in the mask's columns, and not above its rows.
    /// It may be empty or lie below them. No jump depends on the answer.
    bool mayBeNear(int x0, int y0, int x1, int y1) const
    {
        const unsigned column = unsigned(x0) / kBlock, row = unsigned(y0 - mask_.rows.y0) / kBlock;
        const bool isLarge = (x1 > int(column + 2) * kBlock) | (y1 - mask_.rows.y0 > int(row + 2) * kBlock);
        const std::size_t at = std::size_t(row) * words_ + unsigned(x0) / kWord;
        const std::uint64_t word = near_[std::min(at, near_.size() - 1)];
        return isLarge | (((word >> (column * kBlock % kWord)) & 0xFFu) != 0);
    }

private:
    static constexpr int kBlock = 8, kWord = 64;

    bool looksMarked(const Extent& box) const
    {
        const int first = box.x0 / kWord, last = (box.x1 - 1) / kWord;
        const std::uint64_t fromFirst = ~std::uint64_t{0} << (box.x0 % kWord),
                            toLast = ~std::uint64_t{0} >> (kWord - 1 - (box.x1 - 1) % kWord);
        for (int y = box.y0; y < box.y1; ++y) {
            const std::uint64_t* words = mask_.row(y);
            const std::uint64_t some =
                first == last ? words[first] & fromFirst & toLast : (words[first] & fromFirst) | (words[last] & toLast);
            if (some != 0) return true;
        }
        return false;
    }

    const EdgeMask& mask_;
    std::size_t words_;
    std::vector<std::uint64_t> near_;  // Row after row of blocks.
};

}  // namespace aeolic
