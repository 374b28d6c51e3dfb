#pragma once

#include <array>
#include <glm/glm.hpp>

namespace aeolic::cpu {

/// A triangle cut by half-spaces has at most this many corners: one more per plane.
inline constexpr int kMaxClippedCorners = 3 + 5;

/// Cuts a triangle given in eye space (x right, y up, z depth) at the near plane and at four planes of a wide guard
/// band |x| <= slopeX * z, |y| <= slopeY * z (Sutherland & Hodgman 1974). Returns the number of corners left in `out`.
/// New corners are always computed from the inner to the outer end of an edge: two triangles that share the edge get
/// the same bits, hence no gap.
int clipTriangle(const std::array<glm::dvec3, 3>& corners, double nearDepth, double slopeX, double slopeY,
                 std::array<glm::dvec3, kMaxClippedCorners>& out);

}  // namespace aeolic::cpu
