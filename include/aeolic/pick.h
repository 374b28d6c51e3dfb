#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "aeolic/scene_description.h"

namespace aeolic {

/// What a picture shows at a pixel: the nearest place of the surface on the line of sight through the pixel's middle.
struct PickedPlace {
    Vec3 position{0, 0, 0};      ///< World units.
    double depth = 0;            ///< World units from the eye along the direction of view.
    Vec3 normal{0, 0, 0};        ///< Of the triangle, towards the viewer; unit length.
    std::uint64_t triangle = 0;  ///< Which of the surface as it is drawn, from 0.
    std::string surface;         ///< Which of several; else the only one's name.
    std::string vectorName;      ///< The array's that streaks follow; empty where surfaces have several.
    /// The vector as the data have it, and its part along the surface, in the data's unit. Nothing where there is none:
    /// outside of a field, in masked data, on plain surfaces.
    std::optional<Vec3> vector, tangential;
    std::string scalarName;        ///< What the surface is coloured by; empty where there is none.
    std::optional<double> scalar;  ///< Its value there, in the data's unit.
};

}  // namespace aeolic
