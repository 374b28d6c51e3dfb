#pragma once

/// Small Fluent files for the tests; compiled into the tests only.

#include <glm/glm.hpp>
#include <string>

namespace aeolic::test {

/// A box of 4^3 hexahedra, [0, 4]^3, as the fluid "air", with the walls "floor" (z = 0) and "lid" (z = 4), the
/// velocity-inlet "inlet" (x = 0) and the outlet "rest". The cells have VELOCITY = fluentFlow() of their middles and
/// PRESSURE = their number from 0; the floor has WALL_SHEAR = (the face's number from 0, 0, 1).
struct SampleFluent {
    enum class Form { text, floats, doubles };
    Form form = Form::text;
    bool bigEndian = false;
    bool data = true;   ///< The .dat beside it.
    bool names = true;  ///< What zones are called.
    bool flat = false;  ///< 4^2 squares at z = 0 instead, with edges "floor" (y = 0), "lid", "inlet" and "rest".
    bool shapes =
        false;  ///< Instead: a hexahedron, a wedge, a pyramid, a tetrahedron, and a prism of five sides, apart.
};

glm::dvec3 fluentFlow(const glm::dvec3& point);

/// Writes PATH, which ends in .cas or .msh, and the .dat.
void writeSampleFluent(const std::string& path, const SampleFluent& sample = {});

}  // namespace aeolic::test
