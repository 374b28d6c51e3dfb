#pragma once

#include <cstdint>
#include <vector>

#include "data/bricks.h"

namespace aeolic {

/// A run of a file's pieces, half-open.
struct PieceRun {
    int begin = 0, end = 0;
    bool operator==(const PieceRun&) const = default;
};

/// Deals pieces to the ranks in runs of about equal bytes, in order. Every rank finds the same runs; some ranks may get
/// no piece. `bytes`: how many each piece has.
PieceRun runOf(const FieldPart& part, const std::vector<std::uint64_t>& bytes);

}  // namespace aeolic
