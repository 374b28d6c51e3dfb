#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "data/cells/volume_sampler.h"
#include "data/surface_mesh.h"

namespace aeolic {

/// How a volume is looked up on a surface.
struct WallLookup {
    std::optional<double> offsetWorld;  ///< Along the normal, world units; none: by where the flow is.
    bool shear = false;                 ///< Not the vector, but how much it changes with the distance from the wall.
    bool scalar = false;                ///< The volume's scalar, too.
    bool length = false;                ///< The vector's length as the scalar.
    bool shearLength = false;           ///< With `shear`: its length as the scalar.
};

/// What a volume has on a surface.
struct WallValues {
    std::vector<glm::vec3> vectors;  ///< [points] NaN where the volume has none.
    std::vector<float> scalars;      ///< [points], or empty.
    std::vector<char> within;        ///< [points] Which are in the volume or near enough.
    std::int64_t inside = 0;         ///< How many are.
};

/// Below this part of the volume's longest vector the flow on a surface counts as none: it sticks to a wall.
inline constexpr double kAtRest = 1e-6;

/// Looks a volume up at the mesh's points. A point outside the volume takes what the nearest cell has, if that is no
/// farther than half of the cell's diagonal. With an offset each point is moved along its normal first.
///
/// Without one, a point whose flow is none (kAtRest) is moved away from the wall, as far as the centre of the cell
/// beside it: along its normal, or, where no cell with flow is there, against it; else twice, four and eight times as
/// far. The vector found there loses its part along the normal, and the scalar is taken there, too. Where nothing flows
/// the vector is zero.
///
/// `shear`: the vector found away from the wall, without its part along the normal, over the distance: the wall shear
/// stress but for the viscosity. A point on which there is flow is moved as well, and the flow on it subtracted.
///
/// Parallel; the same from any number of threads. The mesh needs normals.
WallValues lookUpNearWall(const SurfaceMesh& mesh, const VolumeSampler& sampler, const WallLookup& lookup);

/// Whether an edge of a surface is longer than the cell at its middle is wide, or near the volume and long beside it.
bool longerThanCell(const VolumeSampler& sampler, const glm::dvec3& a, const glm::dvec3& b);

}  // namespace aeolic
