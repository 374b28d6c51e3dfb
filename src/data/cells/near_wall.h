#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "data/cells/volume_sampler.h"
#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// Away from a wall flow is looked for so many times.
inline constexpr int kWallTries = 4;

/// How a volume is looked up on a surface.
struct WallLookup {
    std::optional<double> offsetWorld;  ///< To `side`, world units; none: by where the flow is.
    double side = 1;                    ///< 1: the volume is where normals point to, -1: on the other side.
    bool shear = false;                 ///< Not the vector, but how much it changes with the distance from the wall.
    bool scalar = false;                ///< The volume's scalar, too.
    bool length = false;                ///< The vector's length as the scalar.
    bool shearLength = false;           ///< With `shear`: its length as the scalar.
    int tries = kWallTries;             ///< How many times the flow is looked for away from a wall.
};

/// What a volume has on a surface.
struct WallValues {
    std::vector<glm::vec3> vectors;  ///< [points] NaN where the volume has none.
    std::vector<float> scalars;      ///< [points], or empty.
    std::vector<char> within;        ///< [points] Which are in the volume or near enough.
    std::vector<char> atRest;        ///< [points] Which found no flow away from the wall.
    std::int64_t inside = 0;         ///< How many are.
};

/// Below this part of the volume's longest vector the flow on a surface counts as none: it sticks to a wall.
inline constexpr double kAtRest = 1e-6;

/// Looks a volume up at the mesh's points. A point outside the volume takes the nearest cell's values, if it is no
/// farther than half of the cell's diagonal, and all that follows starts at that place. A point between cells on both
/// sides takes that of `side`. With an offset each point is moved first, to `side` by that much.
///
/// Without one, a point whose flow is zero (kAtRest) or masked is moved away from the wall, half as far as the cell
/// beside it reaches, VolumeSampler::heightOver(): to `side`, or, where no cell with flow is there, to the other side;
/// else twice, four and eight times as far. The vector found there loses its part along the normal, and the scalar is
/// taken there, too. Where nothing flows the vector is zero, or masked.
///
/// `shear`: the vector found away from the wall, without its part along the normal, over the distance: the wall shear
/// stress but for the viscosity. A point on which there is flow is moved as well, and the flow on it subtracted. But
/// where vectors are means of cells, those on the wall are the adjacent cells': the distance is that of the cells'
/// centres from the wall's faces, VolumeSampler::meanDistanceOfCenters(), and the wall counts as at rest.
///
/// Parallel; the same from any number of threads. The mesh needs normals.
WallValues lookUpNearWall(const SurfaceMesh& mesh, const VolumeSampler& sampler, const WallLookup& lookup);

/// [points] How far from each of the mesh's points lookUpNearWall() and pointsTowardsVolume() ask for values and cells,
/// world units: `sampler` need only know the cells that touch the surface. Parallel. The mesh needs normals.
std::vector<double> lookUpReach(const SurfaceMesh& mesh, const VolumeSampler& sampler, const WallLookup& lookup);

/// On how many more of the mesh's points there is a flow beside the surface only where the normal points to than only
/// on the other side. Parallel. The mesh needs normals.
std::int64_t pointsTowardsVolume(const SurfaceMesh& mesh, const VolumeSampler& sampler);

/// Whether an edge of a surface is longer than the cell at its middle is wide, or near the volume and long beside it.
bool longerThanCell(const VolumeSampler& sampler, const glm::dvec3& a, const glm::dvec3& b);

}  // namespace aeolic
