#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "data/bricks.h"
#include "data/loaded_surface.h"
#include "data/progress.h"

namespace aeolic {

/// Reads .vtp .pvtp .vtm .stl .ply .obj .vtk: polygons and strips of any kind as triangles, blocks appended to one
/// another. A .pvtp that is split gives this part's pieces alone, which placePiece() then puts in their place: their
/// triangles are those of the whole, in its order, with the same bits. Throws InputError.
LoadedSurface readSurfaceFile(const std::string& path, const SurfaceArrays& arrays, const ProgressReport& progress);

/// A run of a file's pieces, half-open.
struct PieceRun {
    int begin = 0, end = 0;
    bool operator==(const PieceRun&) const = default;
};

/// Deals pieces to the ranks in runs of about equal bytes, in order. Every rank finds the same runs; some ranks may get
/// no piece. `bytes`: how many each piece has.
PieceRun runOf(const FieldPart& part, const std::vector<std::uint64_t>& bytes);

/// Bytes of each file that a .pvtp names as a piece; empty for any other file. Throws InputError where one is missing.
std::vector<std::uint64_t> pieceBytesOf(const std::string& path);

/// How many points and polygons a file says it has. A polygon becomes one triangle or more, and points that no polygon
/// uses are left out later.
struct SurfaceCounts {
    std::uint64_t points = 0;  ///< 0: not told.
    std::uint64_t polygons = 0;
};

/// The counts in the header of a surface's file (.vtp, .ply, binary .stl); nothing for other files. Throws InputError
/// for a file that cannot be read.
std::optional<SurfaceCounts> surfaceCountsOf(const std::string& path);

}  // namespace aeolic
