#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "reader/openfoam/foam_case.h"

namespace aeolic {

/// Some faces of one folder's mesh, with their own copy of their points.
struct FoamFaces {
    std::vector<std::uint64_t> numbers;  ///< [faces] Among all faces of this folder's mesh, increasing.
    std::vector<std::size_t> begins;     ///< [faces + 1] Where each one's corners begin.
    std::vector<std::uint32_t> corners;  ///< Which of `points`.
    std::vector<glm::dvec3> points;
    std::uint64_t inMesh = 0;  ///< How many faces this folder's mesh has.

    std::size_t count() const { return numbers.size(); }
    glm::dvec3 normal(std::size_t face) const;  ///< Of unit length; zero where the face has no area.
};

/// The faces of these patches, in the order of the mesh. `patches` are sorted by their first face. Nothing else of the
/// mesh is kept: `faces` and `points` are read in pieces. Throws InputError for corners beyond the points, and damaged
/// files. Patches may go beyond the mesh's faces: the caller compares.
FoamFaces readFoamFaces(const std::string& folder, const std::string& region, double time,
                        const std::vector<FoamPatch>& patches);

/// The numbers that stand in a file of labels (owner, faceProcAddressing) for these faces.
std::vector<std::int64_t> readFoamLabels(const std::string& path, const std::vector<std::uint64_t>& faces);

/// A field's values on the faces of `patches`, `components` each, in the order of `faces`. They are those of the
/// field's boundaryField. Where that has none, as in zeroGradient or empty, they are those of the cells behind, without
/// the normal component of vectors where the patch is a slip or symmetry; noSlip is zero. Throws InputError for a field
/// that is damaged, has no entry for a patch, or another number of values than the patch has faces.
std::vector<float> readFoamValues(const FoamCase& foam, const std::string& folder, const std::string& region,
                                  double time, const FoamField& field, const std::vector<FoamPatch>& patches,
                                  const FoamFaces& faces);

}  // namespace aeolic
