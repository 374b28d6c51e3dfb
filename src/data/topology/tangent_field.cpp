#include "data/topology/tangent_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "data/topology/surface_place.h"

namespace aeolic {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr double kPi = std::numbers::pi;

/// Below this part of the longest vector a point is at rest.
constexpr double kAtRest = 1e-9;

double from0To2Pi(double rad)
{
    const double positive = rad < 0 ? rad + 2 * kPi : rad;
    return positive < 2 * kPi ? positive : 0;
}

class FanFrame {
public:
    FanFrame(const SurfaceMesh& mesh, const SurfaceFans& fans, std::uint32_t fan) : mesh_(mesh), fans_(fans), fan_(fan)
    {
        forEachCorner(fans, fan, [&](std::uint32_t c) { normal_ += glm::cross(side(c, 1), side(c, 2)); });
        const std::uint32_t first = fans.firstCorner[fan];
        if (!(glm::length(normal_) > 0)) normal_ = glm::cross(side(first, 1), side(first, 2));
        normal_ = glm::normalize(normal_);
        glm::dvec3 ahead = along(side(first, 1));
        if (!(glm::length(ahead) > 0)) ahead = along(side(first, 2));
        ahead_ = glm::normalize(ahead);
        left_ = glm::cross(normal_, ahead_);
    }

    glm::dvec3 along(const glm::dvec3& vector) const { return vector - normal_ * glm::dot(normal_, vector); }

    /// The angle of a tangential vector: between the edges on either side of it, which are scaled.
    double radOf(const glm::dvec3& vector) const
    {
        const double seen = seenRad(vector);
        double lowSeen = 0, lowRad = 0, highSeen = 2 * kPi, highRad = 2 * kPi;
        forEachCorner(fans_, fan_, [&](std::uint32_t c) {
            const double edge = c == fans_.firstCorner[fan_] ? 0 : seenRad(side(c, 1));
            take(edge, fans_.edgeRad[c], seen, lowSeen, lowRad, highSeen, highRad);
            if (fans_.nextCorner(c) == SurfaceFans::kNone)
                take(seenRad(side(c, 2)), fans_.secondEdgeRad(c), seen, lowSeen, lowRad, highSeen, highRad);
        });
        if (!(highSeen > lowSeen)) return lowRad;
        return lowRad + (highRad - lowRad) * (seen - lowSeen) / (highSeen - lowSeen);
    }

private:
    static void take(double edge, double edgeRad, double seen, double& lowSeen, double& lowRad, double& highSeen,
                     double& highRad)
    {
        if (edge <= seen && edge >= lowSeen) lowSeen = edge, lowRad = edgeRad;
        if (edge > seen && edge < highSeen) highSeen = edge, highRad = edgeRad;
    }

    /// From the corner to the triangle's next (1) or last (2) point.
    glm::dvec3 side(std::uint32_t corner, std::uint32_t which) const
    {
        const auto& t = mesh_.triangles[corner / 3];
        return glm::dvec3(mesh_.positions[t[(corner + which - corner / 3 * 3) % 3]]) -
               glm::dvec3(mesh_.positions[t[corner % 3]]);
    }
    double seenRad(const glm::dvec3& vector) const
    {
        return from0To2Pi(std::atan2(glm::dot(vector, left_), glm::dot(vector, ahead_)));
    }

    const SurfaceMesh& mesh_;
    const SurfaceFans& fans_;
    std::uint32_t fan_;
    glm::dvec3 normal_{0}, ahead_{0}, left_{0};
};

}  // namespace

TangentField tangentField(const SurfaceMesh& mesh, const SurfaceFans& fans, const std::vector<glm::vec3>& vectors)
{
    TangentField field{std::vector<double>(fans.fans()), std::vector<double>(fans.fans()),
                       std::vector<std::uint8_t>(mesh.triangles.size())};
    double longest = 0;
    for (const Triangle& triangle : mesh.triangles)  // Points that none has may differ among ranks.
        for (const std::uint32_t point : triangle)
            if (const double length = glm::length(glm::dvec3(vectors[point])); std::isfinite(length))
                longest = std::max(longest, length);
    parallelRanges(fans.fans(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (auto fan = std::uint32_t(begin); fan < end; ++fan) {
            glm::dvec3 sum(0);
            double angles = 0;
            forEachCorner(fans, fan, [&](std::uint32_t c) {
                const glm::dvec3 own(vectors[mesh.triangles[c / 3][c % 3]]);
                if (!std::isfinite(glm::length(own))) return;
                sum += fans.cornerRad[c] * own;
                angles += fans.cornerRad[c];
            });
            const glm::dvec3 vector = sum / angles;  // NaN where none is finite.
            const FanFrame frame(mesh, fans, fan);
            const glm::dvec3 along = frame.along(vector);
            const double length = glm::length(along);
            field.length[fan] = length <= kAtRest * longest ? 0 : length;
            field.rad[fan] = std::isfinite(length) && field.length[fan] > 0 ? frame.radOf(along) : 0;
        }
    });
    parallelRanges(mesh.triangles.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            for (const std::uint32_t corner : mesh.triangles[t])
                field.masked[t] |= std::uint8_t(!std::isfinite(glm::length(glm::dvec3(vectors[corner]))));
    });
    return field;
}

std::vector<std::uint8_t> sharpFans(const SurfaceMesh& mesh, const SurfaceFans& fans)
{
    constexpr double leastCosine = 0.85;
    const auto normalOf = [&](std::uint32_t corner) { return glm::normalize(areaVector(mesh, corner / 3)); };
    std::vector<std::uint8_t> sharp(fans.fans());
    parallelRanges(fans.fans(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (auto fan = std::uint32_t(begin); fan < end; ++fan) {
            glm::dvec3 mean(0);
            forEachCorner(fans, fan, [&](std::uint32_t c) { mean += fans.cornerRad[c] * normalOf(c); });
            const double length = glm::length(mean);
            forEachCorner(fans, fan, [&](std::uint32_t c) {
                if (!(glm::dot(mean, normalOf(c)) >= leastCosine * length)) sharp[fan] = 1;
            });
        }
    });
    return sharp;
}

}  // namespace aeolic
