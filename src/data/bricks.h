#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace aeolic {

using GridIndex = std::array<std::int64_t, 3>;

/// The part of a grid that one rank holds: the cells it owns, half-open in global cell coordinates, and the samples it
/// needs to interpolate in them. Cell i lies between samples i and i + 1, so beside the samples at its cells' lower
/// ends a brick holds one layer at the upper faces, which are the neighbour's own: the ghost samples. Its lower faces
/// need none.
struct Brick {
    GridIndex cellLo{0, 0, 0}, cellHi{0, 0, 0};

    bool empty() const { return cellLo[0] >= cellHi[0] || cellLo[1] >= cellHi[1] || cellLo[2] >= cellHi[2]; }
    bool owns(const GridIndex& cell) const
    {
        return cell[0] >= cellLo[0] && cell[0] < cellHi[0] && cell[1] >= cellLo[1] && cell[1] < cellHi[1] &&
               cell[2] >= cellLo[2] && cell[2] < cellHi[2];
    }
    /// Samples held, ghosts included: [cellLo, cellLo + sampleDims) in global sample coordinates. Zeros for an empty
    /// brick.
    GridIndex sampleDims() const;
    std::int64_t sampleCount() const;
    /// Whether this rank counts a sample when samples of some kind are counted over all ranks; `dims`: of the whole
    /// grid. Every sample is counted by exactly one rank: by the owner of the cell whose lower corner it is, and on the
    /// grid's upper faces by the owner of the last cell. So ghosts are counted by their owners.
    bool counts(const GridIndex& sample, const GridIndex& dims) const;
    /// This brick with one layer of the neighbours' cells on every side, as far as the grid goes; `dims`: its samples.
    /// An empty brick stays empty.
    Brick grown(const GridIndex& dims) const;
    bool operator==(const Brick&) const = default;
};

/// A block of samples in memory, and which of them this rank counts.
struct CountedSamples {
    GridIndex dims{0, 0, 0};                  ///< Samples of the whole grid.
    GridIndex first{0, 0, 0}, held{0, 0, 0};  ///< The block: its first sample, how many.
    Brick own;                                ///< The cells whose samples count.

    bool operator()(std::int64_t sample) const  ///< An index into the block, x fastest.
    {
        const std::int64_t layer = held[0] * held[1];
        return own.counts({first[0] + sample % held[0], first[1] + sample % layer / held[0], first[2] + sample / layer},
                          dims);
    }
    std::int64_t count() const;  ///< How many of the block this rank counts.
};

/// Which rank of how many reads a field or a surface. A single rank reads all of it.
struct FieldPart {
    int rank = 0, ranks = 1;
    bool split() const { return ranks > 1; }
};

struct GridField;

/// The brick of `part` in a field whose dims are known.
Brick brickOf(const GridField& field, const FieldPart& part);

/// A grid split among ranks by a k-d tree (bachthaler2006parallel, section 6). Every cell is owned exactly once, so a
/// visible pixel belongs to exactly one rank: no cracks, nothing drawn twice.
class BrickTree {
public:
    /// Halves the side of most cells, by a plane between them, with the ranks: bricks as cubic as can be hold fewest
    /// ghosts. An odd group gives the larger part to the larger half. `dims`: samples, each at least 2. With more ranks
    /// than cells some bricks are empty. The same arguments give the same tree on every rank. Cost: linear in the
    /// ranks.
    BrickTree(const GridIndex& dims, int ranks);

    int ranks() const { return int(bricks_.size()); }
    const Brick& brick(int rank) const { return bricks_[std::size_t(rank)]; }

    /// The rank that owns `cell`, which must be one of the grid's. Cost: log ranks.
    int ownerOf(const GridIndex& cell) const;

private:
    struct Node {
        int axis = 0;
        std::int64_t cut = 0;        // Cells below it are in the first child.
        std::array<int, 2> child{};  // A node, or ~rank.
    };
    int split(const Brick& box, int firstRank, int ranks);

    std::vector<Brick> bricks_;
    std::vector<Node> nodes_;
    int root_ = 0;
};

}  // namespace aeolic
