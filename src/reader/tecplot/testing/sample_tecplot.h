#pragma once

/// Small Tecplot files for the tests; compiled into the tests only.

#include <string>

#include "reader/parts/testing/sample_surface.h"

namespace aeolic::test {

/// A box of 4^3 cells, [0, 4]^3, in the zone "box", and a sheet of 4^2 quads at z = 5 in the zone "sheet". Both have U
/// V W = tecplotFlow() and T = x + 10 y + 100 z on their points, and p = the cell's number from 0 in the cells.
struct SampleTecplot {
    bool ordered = true;   ///< Else of bricks and quadrilaterals.
    bool block = true;     ///< Variable after variable. Point after point there is no p.
    bool shared = false;   ///< The sheet's numbers stand in a zone before it, "hidden", of lines.
    bool repeats = false;  ///< Equal numbers are written once, with how often they come.
    int steps = 0;         ///< Each zone once more for the times 0.5, 1 …, where U and p are more by 1 each.
};

glm::dvec3 tecplotFlow(const glm::dvec3& point);

void writeSampleTecplot(const std::string& path, const SampleTecplot& sample = {});
void writeTecplotSurface(const std::string& path, const SampleSurface& surface);

}  // namespace aeolic::test
