#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "data/mesh/surface_mesh.h"
#include "data/vector_field.h"
#include "description/color_by.h"

namespace aeolic {

/// What a field has at a point, trilinearly.
struct FieldVector {
    bool inside = false;     ///< The point is in the field.
    bool elsewhere = false;  ///< In a cell of another rank's brick: the vector is not known here.
    glm::dvec3 vector{0};    ///< NaN where it is masked. A scalar is its x.
};

FieldVector vectorAt(const GridField& field, const glm::dvec3& pointWorld);

/// [points] The same at many points. No value is -0, as in a sum of what bricks have. Parallel.
std::vector<FieldVector> vectorsAt(const GridField& field, const std::vector<glm::dvec3>& pointsWorld);

/// vectorsAt() in a field whose bricks several ranks may hold.
using FieldLookup =
    std::function<std::vector<FieldVector>(const GridField& field, const std::vector<glm::dvec3>& pointsWorld)>;

/// Least and greatest finite value, or nothing if none is finite. Parallel; the result does not depend on how it is
/// cut.
std::optional<std::array<double, 2>> finiteRange(const std::vector<float>& values);

/// What is coloured by of a vector at a point of a surface; `normal`: its unit normal, which a length has no use for.
double valueOf(ArrayPart part, const glm::dvec3& vector, const glm::dvec3& normal);

/// The surface's unit normal within a triangle; `u`, `v`: the weights of its corners 1 and 2.
glm::dvec3 normalAt(const SurfaceMesh& mesh, std::size_t triangle, double u, double v);

/// Least and greatest finite value of the surface's own vectors' part at its points.
std::optional<std::array<double, 2>> rangeOfVectors(const SurfaceMesh& mesh, ArrayPart part);

/// Least and greatest finite value of the field on the surface; for three components, of that part of the vectors. The
/// field is sampled trilinearly at the surface's points, and within triangles larger than the field's cells at points
/// about a cell apart. Outside the field there is no value; a brick gives those in its own cells.
std::optional<std::array<double, 2>> rangeOnSurface(const SurfaceMesh& mesh, const GridField& field,
                                                    ArrayPart part = ArrayPart::length);

/// Whether any triangle's bounds meet the box.
bool meets(const SurfaceMesh& mesh, const Bounds& boxWorld);

/// The box of the whole grid, from its first sample to its last.
Bounds boundsOf(const GridField& field);

}  // namespace aeolic
