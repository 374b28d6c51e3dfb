#pragma once

#include <string>
#include <vector>

#include "data/piece_run.h"
#include "reader/openfoam/foam_case.h"
#include "reader/parts/part_source.h"

namespace aeolic {

/// Reads the cells of these regions of these folders, one folder after the other, with the fields' values in them.
/// Where the case is decomposed, points at the same place are one. `polyhedra`: they stay whole; else pyramids and
/// tetrahedra around their middle stand in their place, the first of each there, the others behind all cells of the
/// folder's region. Coordinates are floats. Throws InputError.
PartMesh readFoamVolume(const FoamCase& foam, const std::vector<std::string>& regions, double time,
                        const std::vector<FoamField>& fields, const PieceRun& run, bool polyhedra);

}  // namespace aeolic
