#include "data/load/value_percentiles.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <vector>

#include "base/parallel.h"
#include "data/load/blank_surface.h"
#include "data/surface_range.h"

namespace aeolic {
namespace {

constexpr std::int64_t kShareOutside = 50;  // A fiftieth at either end.
constexpr int kMostSubdivisions = 64;       // 4096 values of one triangle are enough.
constexpr std::size_t kBins = std::size_t{1} << 11;

/// Finite floats as whole numbers in the same order.
std::uint32_t keyOf(float value)
{
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

float valueOf(std::uint32_t key)
{
    return std::bit_cast<float>(key & 0x80000000u ? key & 0x7FFFFFFFu : ~key);
}

/// Calls take(value, area) for shares of a triangle's area, unless their value is not finite or another rank has it.
template <class Take>
void forEachShare(const Scene& scene, const GridField* field, std::size_t triangle, const Take& take)
{
    const SurfaceMesh& mesh = scene.surface;
    const std::int64_t area = areaOfTriangle(scene, triangle);
    const auto give = [&](float value, std::int64_t share) {
        if (std::isfinite(value)) take(value, share);
    };
    const std::array<std::uint32_t, 3>& corners = mesh.triangles[triangle];
    const ArrayPart part = scene.ofVectors;
    if (!field && part != ArrayPart::whole) {
        for (const std::uint32_t corner : corners) {
            const glm::vec3& vector = mesh.cellVectors.empty() ? mesh.pointVectors[corner] : mesh.cellVectors[triangle];
            give(float(valueOf(part, glm::dvec3(vector), glm::dvec3(mesh.normals[corner]))), area / 3);
        }
        return;
    }
    if (!field) {
        if (!mesh.cellScalars.empty()) return give(mesh.cellScalars[triangle], area);
        for (const std::uint32_t corner : corners) give(mesh.pointScalars[corner], area / 3);
        return;
    }
    const glm::dvec3 a = mesh.originWorld + glm::dvec3(mesh.positions[corners[0]]),
                     ab = glm::dvec3(mesh.positions[corners[1]]) - glm::dvec3(mesh.positions[corners[0]]),
                     ac = glm::dvec3(mesh.positions[corners[2]]) - glm::dvec3(mesh.positions[corners[0]]);
    const double cell = std::min({field->spacingWorld.x, field->spacingWorld.y, field->spacingWorld.z}),
                 longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
    const int n = int(std::clamp(std::ceil(longest / cell), 1.0, double(kMostSubdivisions)));
    const auto look = [&](double u, double v) {
        const FieldVector found = vectorAt(*field, a + (u / n) * ab + (v / n) * ac);
        if (!found.inside || found.elsewhere) return;
        const glm::dvec3 normal = needsNormal(part) ? normalAt(mesh, triangle, u / n, v / n) : glm::dvec3(0);
        give(float(field->components == 1 ? found.vector.x : valueOf(part, found.vector, normal)), area / n / n);
    };
    for (int u = 0; u < n; ++u)
        for (int v = 0; u + v < n; ++v) {
            look(u + 1.0 / 3, v + 1.0 / 3);
            if (u + v + 1 < n) look(u + 2.0 / 3, v + 2.0 / 3);
        }
}

/// One of the percentiles that are looked for, from its key's highest bits to its lowest.
struct Percentile {
    std::uint32_t prefix = 0;  // The bits found so far.
    std::int64_t below = 0;    // The area of lower keys.
    std::vector<double> bins = {};
};

/// The areas of each percentile's keys by their next bits. `shift`: how many bits follow those.
void fillBins(const Scene& scene, const GridField* field, int shift, std::array<Percentile, 2>& ends)
{
    std::mutex adding;
    for (Percentile& end : ends) end.bins.assign(kBins, 0);
    parallelRanges(scene.surface.triangles.size(), std::size_t{1} << 15, [&](std::size_t begin, std::size_t end) {
        std::array<std::vector<std::int64_t>, 2> some{std::vector<std::int64_t>(kBins),
                                                      std::vector<std::int64_t>(kBins)};
        for (std::size_t i = begin; i < end; ++i)
            forEachShare(scene, field, i, [&](float value, std::int64_t area) {
                const std::uint64_t bits = std::uint64_t(keyOf(value)) >> shift;
                for (std::size_t e = 0; e < 2; ++e)
                    if (bits / kBins == ends[e].prefix) some[e][bits % kBins] += area;
            });
        const std::lock_guard lock(adding);  // Whole numbers below 2^53: their sums are exact in any order.
        for (std::size_t e = 0; e < 2; ++e)
            for (std::size_t bin = 0; bin < kBins; ++bin) ends[e].bins[bin] += double(some[e][bin]);
    });
}

}  // namespace

std::optional<std::array<double, 2>> robustRangeOf(const Scene& scene, Agreement* shared)
{
    const GridField* field = scene.ofVectors != ArrayPart::whole ? scene.field.get() : scene.scalarField.get();
    std::array<Percentile, 2> ends;
    std::int64_t all = 0;
    const auto findBin = [](Percentile& end, std::int64_t wanted) {
        std::size_t bin = 0;
        for (; bin + 1 < kBins && end.below + std::int64_t(end.bins[bin]) <= wanted; ++bin)
            end.below += std::int64_t(end.bins[bin]);
        end.prefix = std::uint32_t(std::uint64_t(end.prefix) * kBins + bin);
    };
    for (const int shift : {22, 11, 0}) {  // 33 bits, of which the first is zero.
        OneRank alone;
        Agreement& ranks = shared ? *shared : alone;
        ranks.together([&] { fillBins(scene, field, shift, ends); });
        for (Percentile& end : ends) ranks.sum(std::span<double>(end.bins));
        if (shift == 22)
            for (const double area : ends[0].bins) all += std::int64_t(area);
        if (all == 0) return std::nullopt;
        findBin(ends[0], all / kShareOutside);
        findBin(ends[1], all - all / kShareOutside - 1);
    }
    return std::array{double(valueOf(ends[0].prefix)), double(valueOf(ends[1].prefix))};
}

}  // namespace aeolic
