#pragma once

/// A surface that the tests write in every format; compiled into the tests only.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace aeolic::test {

struct SampleSurface {
    std::vector<glm::dvec3> points;
    std::vector<std::array<std::int64_t, 3>> triangles;
    std::vector<glm::dvec3> vectors;  ///< Called "Vector".
    std::vector<double> scalars;      ///< Called "Scalar".
    bool onCells = false;             ///< Values are on the triangles, else on the points.
    bool doubles = true;              ///< Numbers have 64 bits, else 32.
};

}  // namespace aeolic::test
