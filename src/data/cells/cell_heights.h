#pragma once

#include "data/cells/cell_geometry.h"

/// How thin cells lie beside a surface. Boundary layers have cells a hundred thousand times as wide as they are high,
/// and the surface's normals are means of facets that may be tilted by some degrees: a height along such a normal would
/// be part of the width. So heights are measured over the cells' own faces.
namespace aeolic {

/// A face as a plane.
struct FacePlane {
    glm::dvec3 middle;
    glm::dvec3 inwards;  ///< Of unit length, towards the cell's centre; not finite where the face has no area.
};

FacePlane planeOf(const VolumeCells& cells, Corners face, const glm::dvec3& centerOfCell);

/// A face lies along a surface where the cosine between their normals is that or more. 60 degrees: at the edges and
/// corners of a body normals are means over all of its sides.
inline constexpr double kAlongSurface = 0.5;

glm::dvec3 centerOf(const VolumeCells& cells, std::uint32_t cell);

/// How far a cell reaches along a direction of unit length.
double widthOf(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& direction);

/// How far a cell reaches off its face that is under a point of a surface with this normal; where none lies along the
/// surface, along the normal. `slackWorld`: faces nearer than that to the point are equally near.
double heightOver(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& point, const glm::dvec3& normal,
                  double slackWorld);

/// Moves the place of a point in a cell onto the cell's face under it, along a surface with this normal, if that is
/// nearer than `slackWorld`: rounding of a surface's coordinates would give a wall without slip some flow.
void settleOnFace(const VolumeCells& cells, const glm::dvec3& point, const glm::dvec3& normal, double slackWorld,
                  CellPlace& place);

/// Whether a cell at a point of a surface is on the side of the direction `towards`. Not if it has no volume.
/// `slackWorld`: distances that are rounding.
bool isTowards(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& point, const glm::dvec3& towards,
               double slackWorld);

}  // namespace aeolic
