#include "data/load/blank_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.h"
#include "data/surface_range.h"

namespace aeolic {
namespace {

constexpr double kStill = 1e-6;       // Of the longest vector. A wall without slip has rounding errors, too.
constexpr double kTangential = 1e-4;  // Of the vector's length: a float's normal is good to less.
constexpr double kAreaSteps = 1e12;   // Steps of area in the square of the surface's diagonal.

using Kind = std::int64_t BlankAreas::*;

/// Which kind of blank the middle of a triangle is; null where it has streaks.
Kind kindOf(const glm::dvec3& vector, const glm::dvec3& normal, double longest)
{
    const double length = glm::length(vector);
    if (!std::isfinite(length)) return &BlankAreas::masked;
    if (!(length > kStill * longest)) return &BlankAreas::still;
    return glm::length(glm::cross(vector, normal)) > kTangential * length ? nullptr : &BlankAreas::across;
}

}  // namespace

BlankAreas blankAreasOf(const Scene& scene, const std::vector<char>& withinField, bool countsOutside)
{
    const SurfaceMesh& mesh = scene.surface;
    const double perArea = kAreaSteps / std::max(1e-300, std::pow(scene.boundsWorld.diagonal(), 2));
    std::atomic<std::int64_t> all{0}, outside{0}, masked{0}, still{0}, across{0};
    parallelRanges(mesh.triangles.size(), 4096, [&](std::size_t begin, std::size_t end) {
        BlankAreas part;
        for (std::size_t i = begin; i < end; ++i) {
            const auto& [a, b, c] = mesh.triangles[i];
            const glm::dvec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c],
                             product = glm::cross(q - p, r - p);
            const double twice = glm::length(product);
            const auto area = std::int64_t(0.5 * twice * perArea);
            const glm::dvec3 normal = twice > 0 ? product / twice : glm::dvec3(0, 0, 1);
            glm::dvec3 vector;
            if (scene.field) {
                const FieldVector found = vectorAt(*scene.field, mesh.originWorld + (p + q + r) / 3.0);
                if (found.elsewhere || (!found.inside && !countsOutside)) continue;
                part.all += area;
                if (!found.inside) part.outside += area;
                if (!found.inside) continue;
                vector = found.vector;
            } else {
                part.all += area;
                if (!withinField.empty() && !withinField[a] && !withinField[b] && !withinField[c]) {
                    part.outside += area;
                    continue;
                }
                vector = mesh.cellVectors.empty()
                             ? glm::dvec3(mesh.pointVectors[a] + mesh.pointVectors[b] + mesh.pointVectors[c]) / 3.0
                             : glm::dvec3(mesh.cellVectors[i]);
            }
            if (const Kind kind = kindOf(vector, normal, scene.maxVector)) part.*kind += area;
        }
        all += part.all;
        outside += part.outside;
        masked += part.masked;
        still += part.still;
        across += part.across;
    });
    return {all, outside, masked, still, across};
}

std::string blankWarning(const std::string& surface, const BlankAreas& areas, const Scene& scene, bool hasField)
{
    const std::int64_t blank = areas.outside + areas.masked + areas.still + areas.across;
    if (2 * blank <= areas.all) return "";
    struct Cause {
        std::int64_t area;
        const char *why, *tryThis;
    };
    const char* const away = scene.bricked() ? "--bricks off" : "--offset LENGTH";
    const Cause causes[] = {
        {areas.outside, "it is outside the field", "a field around the surface, or --offset LENGTH"},
        {areas.masked, "the vectors are masked or not finite", "--vectors with another array"},
        {areas.still, "the vectors are zero, as at walls without slip",
         hasField ? away : "--field with the flow around it, or --vectors with the wall shear"},
        {areas.across, "the vectors are along its normal", "another surface, or --vectors with another array"},
    };
    const auto most = std::max_element(std::begin(causes), std::end(causes),
                                       [](const Cause& a, const Cause& b) { return a.area < b.area; });
    return fmt::format("{}: {} % of the surface has no streaks, mostly because {}; try {}", surface,
                       100 * blank / areas.all, most->why, most->tryThis);
}

}  // namespace aeolic
