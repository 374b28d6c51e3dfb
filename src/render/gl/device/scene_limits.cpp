#include "render/gl/device/scene_limits.h"

#include <algorithm>
#include <limits>
#include <string>

#include "aeolic/error.h"
#include "render/gl/device/device_errors.h"

namespace aeolic::gl {
namespace {

constexpr std::uint64_t kPointBytes = 48, kTriangleBytes = 12,
                        kNearBytes = 8,  // A triangle that may lie near an edge (Edges).
    kMostTriangles = (1u << 29) - 1;     // What shaders can count.
constexpr std::uint64_t kAnyBytes = std::numeric_limits<std::uint64_t>::max();
constexpr int kMostRanks = 65536;

std::uint64_t sampleBytes(const std::optional<GridField>& field)
{
    if (!field) return 0;
    if (field->components != 3) return 4;
    return field->precision == FieldPrecision::float16 ? 8 : 16;
}

std::uint64_t fieldBytes(const SceneSizes& sizes)
{
    std::uint64_t bytes = 0;
    for (const auto* field : {&sizes.field, &sizes.scalarField})
        if (*field) bytes += sampleBytes(*field) * (*field)->sampleCount();
    return bytes;
}

std::uint64_t meshBytes(const SceneSizes& sizes)
{
    if (!sizes.surface) return 0;
    const SceneSizes::Surface& mesh = *sizes.surface;
    return mesh.points * kPointBytes + mesh.triangles * (kTriangleBytes + kNearBytes) + mesh.cellVectors * 12 +
           mesh.cellScalars * 4;
}

const GridField& largestOf(const SceneSizes& sizes)
{
    return sizes.field ? *sizes.field : *sizes.scalarField;
}

std::string samplesText(const GridField& field)
{
    const GridIndex held = field.heldDims();
    return std::to_string(held[0]) + "x" + std::to_string(held[1]) + "x" + std::to_string(held[2]) + " samples";
}

std::string trianglesText(const SceneSizes::Surface& mesh)
{
    return std::to_string(mesh.triangles) + " triangles";
}

void requireBuffers(const SceneSizes::Surface& mesh, std::uint64_t block)
{
    if (mesh.points * kPointBytes <= block && mesh.triangles * kTriangleBytes <= block &&
        mesh.triangles <= kMostTriangles)
        return;
    throw InputError(mesh.name, trianglesText(mesh),
                     "at most " + std::to_string(std::min(block / kTriangleBytes, kMostTriangles)) + " triangles and " +
                         std::to_string(block / kPointBytes) + " points on this GPU, or --backend cpu");
}

/// That have room for the fields, each with a device like this one to itself; every rank holds the whole surface.
std::optional<int> ranksFor(const SceneSizes& sizes, const DeviceLimits& limits)
{
    if (!limits.freeBytes) return ranksEnough(sizes, limits.side, kAnyBytes);
    const std::uint64_t mesh = meshBytes(sizes);
    return *limits.freeBytes > mesh ? ranksEnough(sizes, limits.side, *limits.freeBytes - mesh) : std::nullopt;
}

void requireSides(const SceneSizes& sizes, const DeviceLimits& limits)
{
    for (const auto* field : {&sizes.field, &sizes.scalarField}) {
        if (!*field) continue;
        const GridIndex held = (*field)->heldDims();
        if (std::uint64_t(std::max({held[0], held[1], held[2]})) <= limits.side) continue;
        const auto ranks = ranksFor(sizes, limits);
        throw InputError((*field)->name, samplesText(**field) + ", more than a texture of this GPU takes",
                         "at most " + std::to_string(limits.side) + " along each side: " +
                             (ranks ? std::to_string(*ranks) + " ranks or more with --bricks on, or " : "") +
                             "--backend cpu");
    }
}

/// Each rank's share of a device's free memory.
std::optional<std::uint64_t> shareOf(const DeviceLimits& limits)
{
    if (!limits.freeBytes) return std::nullopt;
    return *limits.freeBytes / std::uint64_t(std::max(limits.ranks, 1));
}

std::string freeText(const DeviceLimits& limits)
{
    const auto share = shareOf(limits);
    if (!share) return "less: ";
    return "at most the " + megabytes(*share) + " that are free" +
           (limits.ranks > 1 ? " for each of the " + std::to_string(limits.ranks) + " ranks on this GPU: " : ": ");
}

}  // namespace

std::optional<int> ranksEnough(const SceneSizes& sizes, std::uint64_t side, std::uint64_t bytes)
{
    const std::uint64_t bytesOfSample = sampleBytes(sizes.field) + sampleBytes(sizes.scalarField);
    const GridField& field = largestOf(sizes);
    for (int ranks = 1; ranks <= kMostRanks; ranks += std::max(1, ranks / 16)) {
        const BrickTree tree(field.dims, ranks);
        bool enough = true;
        for (int r = 0; r < ranks && enough; ++r) {
            const GridIndex dims = tree.brick(r).sampleDims();
            enough = std::uint64_t(std::max({dims[0], dims[1], dims[2]})) <= side &&
                     std::uint64_t(tree.brick(r).sampleCount()) <= bytes / bytesOfSample;
        }
        if (enough) return ranks;
    }
    return std::nullopt;
}

void throwDoesNotFit(const SceneSizes& sizes, const DeviceLimits& limits)
{
    const std::uint64_t mesh = meshBytes(sizes), field = fieldBytes(sizes);
    if (field <= mesh)
        throw InputError(sizes.surface->name,
                         trianglesText(*sizes.surface) + " take " + megabytes(mesh) + " of GPU memory",
                         freeText(limits) + "fewer ranks on this GPU, or --backend cpu");
    const GridField& largest = largestOf(sizes);
    const auto ranks = limits.freeBytes ? ranksFor(sizes, limits) : std::nullopt;
    const std::string enough = ranks ? std::to_string(std::max(*ranks, 2)) + " or more GPUs" : "more GPUs";
    throw InputError(largest.name, samplesText(largest) + " take " + megabytes(field) + " of GPU memory",
                     freeText(limits) + enough + " with --bricks on, --field-precision half, or --backend cpu");
}

void requireLimits(const SceneSizes& sizes, const DeviceLimits& limits, bool fresh)
{
    if (sizes.inPieces)
        throw InputError("--backend", "gl, but a surface in pieces is drawn by processors alone",
                         "cpu or auto, or --bricks off");
    if (sizes.surface) requireBuffers(*sizes.surface, limits.block);
    requireSides(sizes, limits);
    if (const auto share = shareOf(limits); fresh && share && meshBytes(sizes) + fieldBytes(sizes) > *share)
        throwDoesNotFit(sizes, limits);
}

}  // namespace aeolic::gl
