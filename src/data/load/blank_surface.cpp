#include "data/load/blank_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

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

/// A triangle's area in whole steps, and which way it is turned.
struct Facet {
    std::int64_t area;
    glm::dvec3 normal;
};

Facet facetOf(const SurfaceMesh& mesh, std::size_t triangle, double perArea)
{
    const auto& [a, b, c] = mesh.triangles[triangle];
    const glm::dvec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c],
                     product = glm::cross(q - p, r - p);
    const double twice = glm::length(product);
    return {std::int64_t(0.5 * twice * perArea), twice > 0 ? product / twice : glm::dvec3(0, 0, 1)};
}

double stepsPerArea(const Scene& scene)
{
    return kAreaSteps / std::max(1e-300, std::pow(scene.boundsWorld.diagonal(), 2));
}

/// The vector in a triangle's middle; nothing where this rank's part of the field has none.
std::optional<glm::dvec3> vectorIn(const Scene& scene, const std::vector<char>& withinField, std::size_t triangle)
{
    const SurfaceMesh& mesh = scene.surface;
    const auto& [a, b, c] = mesh.triangles[triangle];
    if (scene.field) {
        const glm::dvec3 sum =
            glm::dvec3(mesh.positions[a]) + glm::dvec3(mesh.positions[b]) + glm::dvec3(mesh.positions[c]);
        const FieldVector found = vectorAt(*scene.field, mesh.originWorld + sum / 3.0);
        if (found.elsewhere || !found.inside) return {};
        return found.vector;
    }
    if (!withinField.empty() && !withinField[a] && !withinField[b] && !withinField[c]) return {};
    if (!mesh.cellVectors.empty()) return mesh.cellVectors[triangle];
    return glm::dvec3(mesh.pointVectors[a] + mesh.pointVectors[b] + mesh.pointVectors[c]) / 3.0;
}

}  // namespace

std::int64_t areaOf(const Scene& scene)
{
    const double perArea = stepsPerArea(scene);
    return parallelSum(scene.surface.triangles.size(), 4096,
                       [&](std::size_t i) { return facetOf(scene.surface, i, perArea).area; });
}

std::int64_t areaOfTriangle(const Scene& scene, std::size_t triangle)
{
    return facetOf(scene.surface, triangle, stepsPerArea(scene)).area;
}

BlankAreas blankAreasOf(const Scene& scene, const std::vector<char>& withinField)
{
    const double perArea = stepsPerArea(scene);
    std::atomic<std::int64_t> within{0}, masked{0}, still{0}, across{0};
    parallelRanges(scene.surface.triangles.size(), 4096, [&](std::size_t begin, std::size_t end) {
        BlankAreas part;
        for (std::size_t i = begin; i < end; ++i) {
            const auto vector = vectorIn(scene, withinField, i);
            if (!vector) continue;
            const Facet facet = facetOf(scene.surface, i, perArea);
            part.within += facet.area;
            if (const Kind kind = kindOf(*vector, facet.normal, scene.maxVector)) part.*kind += facet.area;
        }
        within += part.within;
        masked += part.masked;
        still += part.still;
        across += part.across;
    });
    return {within, masked, still, across};
}

BlankAreas blankAreasOf(const Scene& scene, const std::vector<char>& withinField, Agreement& agreement)
{
    BlankAreas areas;
    agreement.together([&] { areas = blankAreasOf(scene, withinField); });
    if (scene.bricked() || scene.inPieces)
        for (std::int64_t* area : {&areas.within, &areas.masked, &areas.still, &areas.across})
            *area = agreement.sum(*area);
    return areas;
}

std::string blankWarning(const std::string& surface, const BlankAreas& areas, std::int64_t all, VectorsFrom from)
{
    const std::int64_t outside = all - areas.within, blank = outside + areas.masked + areas.still + areas.across;
    if (2 * blank <= all) return "";
    struct Cause {
        std::int64_t area;
        const char* why;
        std::string tryThis;
    };
    const bool atOffset = from == VectorsFrom::fieldAtOffset;
    const bool isCut = from == VectorsFrom::cut;  // No offset moves it.
    const std::string offset = atOffset ? "another --offset, or auto" : "--offset LENGTH";
    const std::string otherArray = "--vectors with another array";
    const Cause causes[] = {
        {outside, "it is outside the field",
         "a field around the surface" + (isCut ? ", or another surface" : ", or " + offset)},
        {areas.masked, "the vectors are masked or not finite", atOffset ? offset : otherArray},
        {areas.still, isCut ? "the vectors are zero" : "the vectors are zero, as at walls without slip",
         isCut                          ? "another surface, or " + otherArray
         : from == VectorsFrom::surface ? "--field with the flow around it, or --vectors with the wall shear"
                                        : offset},
        {areas.across, "the vectors are along its normal", "another surface, or " + otherArray},
    };
    const auto most = std::max_element(std::begin(causes), std::end(causes),
                                       [](const Cause& a, const Cause& b) { return a.area < b.area; });
    return fmt::format("{}: {} % of the surface has no streaks, mostly because {}; try {}", surface, 100 * blank / all,
                       most->why, most->tryThis);
}

}  // namespace aeolic
