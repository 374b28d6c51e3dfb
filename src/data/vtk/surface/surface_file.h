#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "data/loaded_surface.h"
#include "data/progress.h"

namespace aeolic {

/// Reads .vtp .pvtp .vtm .stl .ply .obj .vtk: polygons and strips of any kind as triangles, blocks appended to one
/// another. A .pvtp that is split gives this part's pieces alone, which placePiece() then puts in their place: their
/// triangles are those of the whole, in its order, with the same bits. Throws InputError.
LoadedSurface readSurfaceFile(const std::string& path, const SurfaceArrays& arrays, const ProgressReport& progress);

/// Bytes of each file that a .pvtp names as a piece; empty for any other file. Throws InputError where one is missing.
std::vector<std::uint64_t> pieceBytesOf(const std::string& path);

/// How a surface lies on disk: a .pvtp, and patches of one region of a decomposed case, can be read piece by piece.
Pieces piecesOfSurface(const std::string& path, const std::vector<std::string>& parts);

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
