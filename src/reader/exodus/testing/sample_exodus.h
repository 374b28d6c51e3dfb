#pragma once

/// Small Exodus files for the tests, by the Exodus library; compiled into the tests only.

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "reader/parts/testing/sample_surface.h"

namespace aeolic::test {

/// A box of 4^3 hexahedra, [0, 4]^3, in two blocks, "low" (z < 2) and "high", with the times 0, 0.5 … Nodes have vel_x
/// … = exodusFlow() + (step, 0, 0) and temp = x + 10 y + 100 z, elements pressure = their number from 0 + step. The
/// side sets are "floor" (z = 0), "lid" (z = 4) and "inlet" (x = 0). The floor has shear = the side's number from 0.
struct SampleExodus {
    enum class Form { classic, offsets64, data64, netcdf4 };
    Form form = Form::offsets64;
    bool doubles = true, names = true, values = true;
    bool polyhedra = false;  ///< The high block is of polyhedra.
    bool split = false;      ///< The high block has nodes of its own, also where it touches the low one.
    bool shells = false;     ///< One more block, "sheet": quads at z = 5.
    bool moves = false;      ///< Nodes have disp_x … = (0, 0, step).
    int steps = 2;
};

glm::dvec3 exodusFlow(const glm::dvec3& point);

void writeSampleExodus(const std::string& path, const SampleExodus& sample = {});

/// One element of each kind, apart from each other, and a side set "all" of all their sides: a hexahedron of 27 nodes,
/// a tetrahedron of 10, a wedge of 6, a pyramid of 5, a shell of 4 and one of 3 nodes.
void writeExodusElements(const std::string& path);

/// The corners of every side of "all", as the library knows them.
std::vector<std::vector<int>> exodusSides(const std::string& path);

/// The block "Surface" of shells; values are those of the time 0.
void writeExodusSurface(const std::string& path, const SampleSurface& surface,
                        SampleExodus::Form form = SampleExodus::Form::offsets64);

}  // namespace aeolic::test
