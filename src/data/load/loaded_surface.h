#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "data/array_choice.h"
#include "data/bricks.h"
#include "data/load/progress.h"
#include "data/surface_mesh.h"
#include "data/tally.h"

namespace aeolic {

/// What is wanted of a data set's arrays beside its geometry.
struct SurfaceArrays {
    bool wantVectors = false;
    std::string vectors;  ///< Empty: the active ones, or the only ones.
    std::string colorBy;  ///< NAME or NAME:mag, or empty. Not an error here if there is no such array.
    std::optional<double> timeInFile = std::nullopt;  ///< Of a file with several time steps; else the first.
    FieldPart part = {};                              ///< Where it is split: only this part's run of its pieces …
    std::vector<std::uint64_t> shares = {};           ///< … by these bytes of each instead of the file's own.
};

/// What only all pieces of a surface together tell; of one of them, what it tells.
struct PieceFacts {
    Bounds pointsWorld;
    bool normals = true;  ///< Each point came with a direction.
};

/// A surface as it was read: one moment of it, where it moves. Two such moments can be interpolated where their points
/// and polygons are the same (data/interpolate.h); finishSurface() then makes it fit to be drawn.
struct LoadedSurface {
    SurfaceMesh mesh;            ///< Without normals unless it came with them; with triangles that have no area.
    std::uint64_t topology = 0;  ///< Of the polygons it was made of: the same value, the same connections. 0: unknown.
    std::vector<std::uint32_t>
        pointIds;        ///< [points] The polygons' own numbers for the mesh's points; or empty: equal.
    bool piece = false;  ///< Of a surface that is split: may have no triangle.
    std::vector<glm::dvec3> pointsWorld;   ///< [points] Of a piece from a file, before placePiece(): no positions yet.
    std::string where;                     ///< The file's name, in front of messages.
    bool cutOut = false;                   ///< Of a grid: then triangles without an area are no surprise.
    std::array<double, 2> cutRange{0, 0};  ///< Of an isosurface of a uniform grid: least and greatest value there is.
    std::string scalarLabel;               ///< Empty: `colorBy` was not found, or not asked for.
    std::string arrays;                    ///< What there is, for messages …
    ArrayChoices offered;                  ///< … and to choose from.
    std::vector<double> timeSteps;         ///< Of a file with several.
    std::vector<std::string> warnings;
    std::vector<Tally> tallies;
};

/// Reads .vtp .pvtp .vtm .stl .ply .obj .vtk: polygons and strips of any kind as triangles, blocks appended to one
/// another. Of a .pvtp that is split only this part's pieces, which placePiece() then puts in their place: their
/// triangles are those of the whole, in its order, with the same bits. Throws InputError.
LoadedSurface readSurfaceFile(const std::string& path, const SurfaceArrays& arrays, const ProgressReport& progress);

/// What a piece tells of all …
PieceFacts factsOf(const LoadedSurface& piece);

/// … and what all together tell it: positions are relative to the centre of all points.
void placePiece(LoadedSurface& piece, const PieceFacts& ofAll);

/// Leaves out triangles without an area, with a counted warning, and computes normals where there are none, edges
/// sharper than `featureAngleDeg` staying sharp. Throws InputError if no triangle is left of what is no piece.
void finishSurface(LoadedSurface& surface, double featureAngleDeg);

}  // namespace aeolic
