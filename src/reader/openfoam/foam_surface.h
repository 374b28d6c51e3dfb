#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "data/piece_run.h"
#include "reader/openfoam/foam_case.h"

namespace aeolic {

/// A patch of the whole case, whatever folders its faces lie in.
struct FoamPart {
    std::string region, patch, type;
    std::vector<std::string> groups;
    std::uint64_t faces = 0;
    std::string name() const { return region.empty() ? patch : region + "/" + patch; }
};

/// All patches but those between processors, in the order of the files. `time`: that of the mesh, where it changes.
std::vector<FoamPart> foamParts(const FoamCase& foam, double time);

/// Which of `parts` are wanted: those that `wanted` names, else the walls. Throws InputError where there is none, or
/// where none of them has a face.
std::vector<FoamPart> chooseFoamParts(const FoamCase& foam, const std::vector<FoamPart>& parts,
                                      const std::vector<std::string>& wanted);

/// Polygons of some patches with values on them.
struct FoamSurface {
    std::vector<glm::dvec3> points;
    std::vector<std::size_t> begins{0};  ///< [polygons + 1] Where each one's corners begin.
    std::vector<std::uint32_t> corners;
    std::map<std::string, std::vector<float>> values;  ///< By the fields' names.
    /// [polygons] Where each stands among those of the whole case; two may stand at the same place.
    std::vector<std::uint64_t> places;
};

/// Reads the patches in the order of the mesh's faces, whatever order the parts are in. The faces of a decomposed case
/// come in the order that they have in the whole mesh, where each processor says it (faceProcAddressing), else one
/// processor after the other, and points that lie at the same place are one: the surface is that of the case put
/// together again. `run`: only the faces of these folders, perhaps none; joined by their places they are those of all.
/// Throws InputError.
FoamSurface readFoamSurface(const FoamCase& foam, const std::vector<FoamPart>& parts, double time,
                            const std::vector<FoamField>& fields, const PieceRun& run);

}  // namespace aeolic
