#pragma once

#include <glm/glm.hpp>

#include "render/overlay/panel.h"

namespace aeolic {

/// How a view is turned: its axes in the world, of unit length.
struct Orientation {
    glm::dvec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0};
};

/// Draws the world's axes x, y and z as they are turned in the view, with their letters, on a panel that fills the
/// square `box`. Farther axes lie behind nearer ones. Only the part in these rows is drawn.
void drawOrientationAxes(const PictureRows& picture, const Box& box, const Orientation& view, double em, Inks inks);

}  // namespace aeolic
