#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

namespace aeolic {

/// A line of sight. A place on it is eye + depth * direction.
struct Ray {
    glm::dvec3 eye, direction;
};

struct RayHit {
    double depth = 0;
    bool isFront = false;  ///< The face is turned to the viewer.
    glm::dvec3 weight{0};  ///< Of the corners; they add up to 1.
};

/// Faces whose depths differ by no more than this share are in the same place.
inline constexpr double kSamePlace = 1e-6;

/// Of faces in the same place the one that a picture shows: that turned to the viewer, and then the first in order.
inline bool showsBefore(const RayHit& hit, std::uint64_t order, const RayHit& other, std::uint64_t otherOrder)
{
    return hit.isFront != other.isFront ? hit.isFront : order < otherOrder;
}

/// Where a line of sight meets a triangle (Möller and Trumbore 1997).
inline std::optional<RayHit> meet(const Ray& ray, const std::array<glm::dvec3, 3>& corners)
{
    constexpr double kSlack = 1e-9;  // Of the corners' weights: neighbours leave no gap.
    const glm::dvec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const glm::dvec3 across = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, across);
    if (determinant == 0) return std::nullopt;  // Seen from its edge.
    const glm::dvec3 from = ray.eye - corners[0];
    const double b = glm::dot(from, across) / determinant;
    const glm::dvec3 turned = glm::cross(from, ab);
    const double c = glm::dot(ray.direction, turned) / determinant;
    if (!(b >= -kSlack && c >= -kSlack && b + c <= 1 + kSlack)) return std::nullopt;
    return RayHit{glm::dot(ac, turned) / determinant, determinant > 0, {1 - b - c, b, c}};
}

}  // namespace aeolic
