#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "data/bricks.h"

namespace aeolic {

/// A run of a file's pieces, half-open.
struct PieceRun {
    int begin = 0, end = 0;
    bool operator==(const PieceRun&) const = default;
};

/// Deals pieces to the ranks in runs of about equal bytes, in order: the same on every rank, and perhaps none for some.
/// `bytes`: of each piece.
PieceRun runOf(const FieldPart& part, const std::vector<std::uint64_t>& bytes);

/// Bytes of each file that a .pvtp names as a piece; empty for any other file. Throws InputError where one is missing.
std::vector<std::uint64_t> pieceBytesOf(const std::string& path);

}  // namespace aeolic
