#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "data/array_choice.h"
#include "data/bricks.h"
#include "data/mesh/surface_mesh.h"
#include "data/tally.h"
#include "description/color_by.h"

namespace aeolic {

/// What is wanted of a data set's arrays beside its geometry.
struct SurfaceArrays {
    bool wantVectors = false;
    std::string vectors;  ///< Empty: the active ones, or the only ones.
    std::string colorBy;  ///< NAME or NAME:mag, or empty. Not an error here if there is no such array.
    std::optional<double> timeInFile = std::nullopt;  ///< One of the file's time steps; none: the first.
    FieldPart part = {};                              ///< Where it is split, only this part's run of pieces is read.
    std::vector<std::uint64_t> shares =
        {};                               ///< Bytes by which pieces are dealt; empty: those of the file's own pieces.
    std::vector<std::string> parts = {};  ///< Names, groups and patterns of parts; empty: the usual ones.
    std::vector<std::uint64_t> joined = {};  ///< Bytes of each piece, where they are joined (Pieces).
};

/// Facts that must be known of all pieces of a surface before one of them can be placed. One piece tells its own share.
struct PieceFacts {
    Bounds pointsWorld;
    bool normals = true;  ///< Each point came with a direction.
};

/// How a surface lies on disk.
enum class Pieces : std::uint8_t { none, apart, joined };  ///< Joined: points of two pieces at the same place are one.

/// One moment of a surface, as it was read. Two moments can be interpolated where their points and polygons are the
/// same (data/load/series/interpolate.h). finishSurface() then makes it fit to be drawn.
struct LoadedSurface {
    SurfaceMesh mesh;            ///< Without normals unless it came with them; with triangles that have no area.
    std::uint64_t topology = 0;  ///< A hash of the polygons: equal values mean equal connections. 0: not known.
    std::vector<std::uint32_t> pointIds;   ///< [points] The polygons' own numbers for the mesh's points. Empty: equal.
    bool piece = false;                    ///< Part of a surface that is split: it may have no triangle.
    bool placed = true;                    ///< False for a piece from a file until placePiece().
    std::vector<glm::dvec3> pointsWorld;   ///< [points] Instead of the mesh's positions, as long as it is not placed.
    std::string where;                     ///< The file's name, in front of messages.
    bool cutOut = false;                   ///< Cut out of a grid: triangles without an area are no surprise.
    std::array<double, 2> cutRange{0, 0};  ///< The isosurface of a uniform grid: least and greatest value there is.
    std::string scalarLabel;               ///< Empty: `colorBy` was not found, or not asked for.
    ArrayPart ofVectors = ArrayPart::whole;  ///< Scene::ofVectors, of `colorBy`.
    std::string vectorsName;                 ///< Empty: no vectors were asked for.
    std::string arrays;                      ///< What arrays there are, for messages.
    ArrayChoices offered;                    ///< What arrays there are to choose from.
    std::vector<double> timeSteps;           ///< Those of a file that holds several.
    std::vector<std::string> warnings;
    std::vector<Tally> tallies;
    bool complete = true;        ///< False for this rank's share, until StepReader::complete() has all of them.
    Pieces lies = Pieces::none;  ///< What the shares are.
};

/// A hash as a surface's topology, which is 0 only where it is not known.
inline std::uint64_t knownTopology(std::uint64_t hash)
{
    return hash == 0 ? 1 : hash;
}

/// A hash of `topology` and where the mesh's points are: for surfaces that are the same only where these are too.
std::uint64_t withPlaces(std::uint64_t topology, const SurfaceMesh& mesh);

/// A hash of `topology` and `numbers`.
std::uint64_t withNumbers(std::uint64_t topology, std::span<const std::uint64_t> numbers);

/// What one piece tells.
PieceFacts factsOf(const LoadedSurface& piece);

/// Whether the piece has normals, or no points that could have any: PieceFacts::normals.
bool hasNormals(const LoadedSurface& piece);

/// Puts a piece in its place: positions are relative to the centre of all pieces' points. `ofAll`: the facts of all
/// pieces together.
void placePiece(LoadedSurface& piece, const PieceFacts& ofAll);

/// Leaves out triangles without an area and counts them. Computes normals where there are none; edges sharper than
/// `featureAngleDeg` stay sharp. Throws InputError if no triangle is left, unless the surface is a piece.
void finishSurface(LoadedSurface& surface, double featureAngleDeg);

}  // namespace aeolic
