#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "reader/parts/cells_of_faces.h"

namespace aeolic {

/// Cuts polyhedra into pyramids and tetrahedra that stand on their faces and meet in the mean of their corners, which
/// is added to the points: VTK's filters handle these better. The first takes the polyhedron's place, the others come
/// behind all cells. `cells`: all of them. Returns of which cell each of these others is a part. Both sides of a face
/// cut it in the same way.
std::vector<std::size_t> cutIntoStars(const CellsOfFaces& all, std::vector<PartCells>& cells,
                                      std::vector<glm::dvec3>& points);

}  // namespace aeolic
