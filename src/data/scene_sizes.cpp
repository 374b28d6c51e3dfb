#include "data/scene_sizes.h"

#include <algorithm>
#include <numeric>

#include "data/builtin_flows.h"
#include "data/builtin_surfaces.h"
#include "data/surface_spec.h"
#include "data/time_series.h"
#include "data/vtk/grid_file.h"
#include "data/vtk/surface_header.h"
#include "data/vtk/surface_pieces.h"

namespace aeolic {
namespace {

constexpr std::uint64_t kStepsInMemory = 4;  // Two, what lies between them, and one read ahead.

GridField withoutSamples(const GridField& field)
{
    GridField sizes = field;
    sizes.samples.reset();
    return sizes;
}

/// The file, or the first of the series.
std::string firstFileOf(const std::string& spec)
{
    return namesSeries(spec) ? readTimeSeries(spec).steps.front().path : spec;
}

/// Vectors and what is coloured by, as they are kept in memory.
GridOutline outlineOf(const SceneDescription& description, const std::string& colorBy)
{
    const std::string& field = description.field.spec;
    GridOutline outline;
    if (field.empty()) return outline;
    if (isBuiltinFlow(field))
        outline.vectors = outlineOfBuiltinFlow(field);
    else
        outline = outlineOfGridFile(firstFileOf(field), {description.field.vectors, colorBy, "", false});
    if (outline.vectors && description.field.precision == "half") outline.vectors->precision = FieldPrecision::float16;
    return outline;
}

std::optional<SceneSizes::Surface> surfaceSize(const SurfaceSpec& spec)
{
    if (spec.kind == SurfaceSpec::Kind::builtin) {
        const std::uint64_t triangles = builtinSurfaceTriangles(spec.text);
        return SceneSizes::Surface{spec.text, triangles / 2, triangles};
    }
    if (spec.kind != SurfaceSpec::Kind::file) return std::nullopt;
    const auto counts = surfaceCountsOf(firstFileOf(spec.text));
    if (!counts) return std::nullopt;
    return SceneSizes::Surface{spec.text, std::min(counts->points, 3 * counts->polygons), counts->polygons};
}

}  // namespace

SceneSizes sizesOf(const Scene& scene)
{
    const SurfaceMesh& mesh = scene.surface;
    SceneSizes sizes;
    sizes.surface = {mesh.name, mesh.positions.size(), mesh.triangles.size(), mesh.cellVectors.size(),
                     mesh.cellScalars.size()};
    sizes.inPieces = scene.inPieces;
    if (scene.field) sizes.field = withoutSamples(*scene.field);
    if (scene.scalarField) sizes.scalarField = withoutSamples(*scene.scalarField);
    return sizes;
}

SceneSizes sizesOf(const SceneDescription& description, const FieldPart& part)
{
    const SurfaceSpec spec = parseSurfaceSpec(description.surface.spec);
    SceneSizes sizes;
    sizes.surface = surfaceSize(spec);
    const bool mayHaveOwnScalar = spec.kind == SurfaceSpec::Kind::file;
    const GridOutline outline = outlineOf(description, mayHaveOwnScalar ? "" : description.shading.colorBy);
    sizes.field = outline.vectors;
    sizes.scalarField = outline.scalar;
    if (part.split())
        for (auto* field : {&sizes.field, &sizes.scalarField})
            if (*field) (*field)->brick = brickOf(**field, part);
    return sizes;
}

std::uint64_t fieldBytesOf(const SceneDescription& description)
{
    const std::string& field = description.field.spec;
    const std::optional<GridField> vectors = outlineOf(description, "").vectors;
    if (!vectors) return 0;
    const bool changes = isBuiltinFlow(field) ? !builtinFlowTimes(field).empty() : namesSeries(field);
    return (changes ? kStepsInMemory : 1) * vectors->bytes();
}

std::uint64_t pieceFileBytesOf(const SceneDescription& description)
{
    const SurfaceSpec spec = parseSurfaceSpec(description.surface.spec);
    if (spec.kind != SurfaceSpec::Kind::file) return 0;
    const std::vector<std::uint64_t> bytes = pieceBytesOf(firstFileOf(spec.text));
    if (bytes.size() < 2) return 0;
    return (namesSeries(spec.text) ? kStepsInMemory : 1) *
           std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{0});
}

}  // namespace aeolic
