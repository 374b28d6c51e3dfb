#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "data/piece_run.h"
#include "reader/openfoam/foam_case.h"
#include "reader/parts/cells_of_faces.h"

namespace aeolic {

/// Reads the cells of these regions of these folders, one folder after the other, with the fields' values in them.
/// Where the case is decomposed, points at the same place are one. `polyhedra`: they stay whole; else pyramids and
/// tetrahedra around their middle stand in their place, the first of each there, the others behind all cells of the
/// folder's region. Coordinates are floats. Throws InputError.
PartMesh readFoamVolume(const FoamCase& foam, const std::vector<std::string>& regions, double time,
                        const std::vector<FoamField>& fields, const PieceRun& run, bool polyhedra);

/// Cuts polyhedra into pyramids and tetrahedra that stand on their faces and meet in the mean of their corners, which
/// is added to the points: VTK's filters handle these better. The first takes the polyhedron's place, the others come
/// behind all cells. `cells`: all of them. Returns of which cell each of these others is a part. Both sides of a face
/// cut it in the same way.
std::vector<std::size_t> cutIntoStars(const CellsOfFaces& all, std::vector<PartCells>& cells,
                                      std::vector<glm::dvec3>& points);

}  // namespace aeolic
