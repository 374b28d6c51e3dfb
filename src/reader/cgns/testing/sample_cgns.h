#pragma once

/// Small CGNS files for the tests, by the CGNS library; compiled into the tests only.

#include <glm/glm.hpp>
#include <string>

#include "reader/parts/testing/sample_surface.h"

namespace aeolic::test {

/// A box of 4^3 cells, [0, 4]^3, in a zone "box" of the base "Base". It has VelocityX … = cgnsFlow() and Density = x +
/// 10 y
/// + 100 z on its points, Pressure = the cell's number from 0 in its cells. Its boundaries are "floor" (z = 0), a
/// BCWallViscous of the family "ground", "lid" (z = 4), a BCWall, and "inlet" (x = 0), a BCInflow.
struct SampleCgns {
    enum class Cells { structured, hexahedra, mixed, polyhedra };
    Cells cells = Cells::structured;
    bool doubles = true;
    bool rind = false;      ///< A layer more of points and cells all around values, and of points around coordinates.
    bool parents = true;    ///< Faces say which cells they belong to.
    bool faces = true;      ///< Without, boundaries must be points: there are cells alone.
    bool turned = false;    ///< Of polyhedra: faces at x, y or z = 0 are seen from inside, and cells turn them around.
    bool lists = false;     ///< Boundaries are lists of faces instead of ranges.
    bool byPoints = false;  ///< Boundaries are lists of points.
    bool vertexOnly = false;  ///< No Pressure.
    bool onFaces = false;     ///< The floor has values of its own in a ZoneSubRegion: Shear, and Pressure = 1000 more.
    bool shortPointers = false;  ///< The zone names only the ends of its solutions' names.
    int steps = 0;               ///< Times 0, 0.5, 1 …: VelocityX and Pressure grow by 1 each. 0: no times.
    bool secondZone = false;     ///< One more, "other", shifted by (4, 0, 0), without boundaries.
    bool secondBase = false;     ///< One more, "Sheets", of a zone "sheet": [0, 4]^2 at z = 5, of quads.
    std::string grid = {};       ///< The box stands in this file, and here is a link to it.
};

glm::dvec3 cgnsFlow(const glm::dvec3& point);

void writeSampleCgns(const std::string& path, const SampleCgns& sample = {});

/// The zone "Surface", without structure.
void writeCgnsSurface(const std::string& path, const SampleSurface& surface);

}  // namespace aeolic::test
