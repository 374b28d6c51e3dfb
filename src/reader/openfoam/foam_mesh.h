#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "reader/openfoam/foam_case.h"
#include "reader/parts/cells_of_faces.h"

namespace aeolic {

/// Some faces of one folder's mesh, with their own copy of their points.
struct FoamFaces {
    std::vector<std::uint64_t> numbers;  ///< [faces] Among all faces of this folder's mesh, increasing.
    MeshFaces faces;                     ///< Corners are numbers of `points`; cells are not told.
    std::vector<glm::dvec3> points;
    std::uint64_t inMesh = 0;  ///< How many faces this folder's mesh has.

    glm::dvec3 normal(std::size_t face) const;  ///< Of unit length; zero where the face has no area.
};

/// The faces of these patches, in the order of the mesh. `patches` are sorted by their first face. Nothing else of the
/// mesh is kept. Throws InputError for corners beyond the points, and damaged files. Patches may go beyond the mesh's
/// faces: the caller compares.
FoamFaces readFoamFaces(const FoamPath& folder, const std::string& region, double time,
                        const std::vector<FoamPatch>& patches);

/// The numbers that stand in a file of labels (owner, faceProcAddressing) for these faces.
std::vector<std::int64_t> readFoamLabels(const FoamPath& file, const std::vector<std::uint64_t>& faces);

/// The float that is nearest, as a double. GCC 12 leaves this rounding out where it converts two numbers at once.
inline double nearestFloat(double value)
{
    const volatile float rounded = float(value);
    return double(rounded);
}

/// All of one folder's mesh. Coordinates are those of floats.
struct FoamMesh {
    std::vector<glm::dvec3> points;
    MeshFaces faces;
    std::size_t cells = 0;
};

/// Throws InputError for corners that are no points, coordinates beyond 1e30, and another number of owners than faces.
FoamMesh readFoamMesh(const FoamPath& folder, const std::string& region, double time);

/// A field's values on the faces of `patches`, `components` each, in the order of `faces`. They are those of the
/// field's boundaryField. Where that has none, as in zeroGradient or empty, they are those of the cells behind, without
/// the normal component of vectors where the patch is a slip or symmetry; noSlip is zero. Throws InputError
/// for a field that is damaged, has no entry for a patch, or another number of values than the patch has faces.
std::vector<float> readFoamValues(const FoamPath& folder, const std::string& region, double time,
                                  const FoamField& field, const std::vector<FoamPatch>& patches,
                                  const FoamFaces& faces);

/// A field's values in all `cells` cells, `components` each. Throws InputError where there are more or fewer.
std::vector<float> readFoamCells(const FoamPath& file, const FoamField& field, std::size_t cells);

}  // namespace aeolic
