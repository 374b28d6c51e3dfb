#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aeolic/error.h"
#include "base/half.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "data/builtin_flows.h"
#include "data/builtin_surfaces.h"
#include "data/progress.h"
#include "data/scene.h"
#include "data/surface_range.h"
#include "data/surface_spec.h"
#include "data/vtk/grid_file.h"
#include "data/vtk/loaded_surface.h"

namespace aeolic {

namespace {

/// The surface from a file or built in. A surface cut out of the field comes with the field.
LoadedSurface loadSurface(const SurfaceSpec& spec, const SceneDescription& description, bool wantVectors,
                          const ProgressReport& progress)
{
    if (spec.kind == SurfaceSpec::Kind::file)
        return readSurfaceFile(spec.text, {wantVectors, description.field.vectors, description.shading.colorBy},
                               description.surface.featureAngleDeg, progress);
    if (wantVectors)
        throw InputError("surface '" + spec.text + "'", "it has no vectors of its own",
                         "a field to sample on it (--field)");
    LoadedSurface surface;
    surface.mesh = makeBuiltinSurface(spec.text);
    surface.arrays = "none";
    return surface;
}

std::string boxText(const Bounds& b)
{
    return fmt::format("{:.6g},{:.6g},{:.6g} to {:.6g},{:.6g},{:.6g}", b.lo.x, b.lo.y, b.lo.z, b.hi.x, b.hi.y, b.hi.z);
}

void requireOverlap(const Scene& scene, const std::string& fieldSpec)
{
    const Bounds box = boundsOf(*scene.field);
    if (!meets(scene.surface, box))
        throw InputError(fieldSpec, "the field, from " + boxText(box) + ", does not meet the surface",
                         "a field around the surface, from " + boxText(scene.boundsWorld));
}

std::shared_ptr<const GridField> toHalf(const std::shared_ptr<const GridField>& field,
                                        std::vector<std::string>& warnings)
{
    const std::size_t count = field->sampleCount() * std::size_t(field->components);
    requireMemory(field->name, "the field in half precision", 2 * count);
    GridField half = *field;
    const auto memory =
        std::shared_ptr<std::uint16_t[]>(new std::uint16_t[count + 2]);  // Gathers may read past the end.
    const std::size_t clamped = halvesFromFloatsParallel(field->floats(), memory.get(), count);
    if (clamped > 0) warnings.push_back(fmt::format("{}: {} values beyond 65504 were set to it", field->name, clamped));
    half.samples = std::shared_ptr<const void>(memory, memory.get());
    half.precision = FieldPrecision::float16;
    return std::make_shared<const GridField>(std::move(half));
}

void takeSurface(LoadedSurface&& surface, Scene& scene)
{
    scene.surface = std::move(surface.mesh);
    scene.boundsWorld = scene.surface.bounds();
    scene.warnings.insert(scene.warnings.end(), surface.warnings.begin(), surface.warnings.end());
    scene.hasScalar = !surface.scalarLabel.empty();
    scene.scalarName = surface.scalarLabel;
    scene.surfaceArrays = std::move(surface.offered);
}

[[noreturn]] void failColorBy(const std::string& where, const std::string& colorBy, const std::string& arrays)
{
    throw InputError(where, "no array '" + colorBy + "' to colour by", "one of: " + arrays);
}

/// Vectors on the surface itself, or a built-in flow around it.
void loadWithoutFieldFile(const SurfaceSpec& spec, const SceneDescription& description, const FieldPart& part,
                          const ProgressReport& progress, Scene& scene)
{
    if (part.split() && description.field.spec.empty())
        throw InputError("--bricks", "there is no field to split: the vectors are the surface's own", "off or auto");
    if (spec.isCut())
        throw InputError("surface '" + spec.text + "'",
                         description.field.spec.empty()
                             ? "there is no field to cut it out of"
                             : "the built-in field spans the surface and cannot be cut itself",
                         "a field from a file (--field FILE)");
    LoadedSurface surface = loadSurface(spec, description, description.field.spec.empty(), progress);
    std::string arrays = surface.arrays;
    takeSurface(std::move(surface), scene);
    const std::string& colorBy = description.shading.colorBy;
    if (!description.field.spec.empty()) {
        scene.field = makeBuiltinFlow(description.field.spec, scene.boundsWorld, part);
        if (description.field.precision == "half") scene.field = toHalf(scene.field, scene.warnings);
        if (!scene.hasScalar && colorBy == scene.field->name + ":mag") {
            scene.hasScalar = scene.colorByFieldMagnitude = true;
            scene.scalarName = "|" + scene.field->name + "|";
        }
        arrays = (arrays == "none" ? "" : arrays + ", ") + scene.field->name + ":mag";
        scene.fieldArrays = {{scene.field->name, 3}};
    }
    if (!colorBy.empty() && !scene.hasScalar) failColorBy(spec.text, colorBy, arrays);
}

/// The field from a file; the surface cut out of it, or from elsewhere.
void loadWithFieldFile(const SurfaceSpec& spec, const SceneDescription& description, const FieldPart& part,
                       const ProgressReport& progress, Scene& scene)
{
    const std::string& colorBy = description.shading.colorBy;
    std::string surfaceArrays = "none";
    if (!spec.isCut()) {
        LoadedSurface surface = loadSurface(spec, description, false, progress);
        surfaceArrays = surface.arrays;
        takeSurface(std::move(surface), scene);
    }
    GridFile grid(
        description.field.spec,
        {description.field.vectors, scene.hasScalar ? "" : colorBy, spec.array, description.field.precision == "half"},
        part, progress);
    if (!colorBy.empty() && !scene.hasScalar && !grid.hasScalar())
        failColorBy(description.field.spec, colorBy,
                    grid.arrays() + (surfaceArrays == "none" ? "" : "; on the surface: " + surfaceArrays));

    const bool carried = spec.isCut() && !grid.uniform() && !description.field.resampleSpacing;
    if (spec.isCut()) takeSurface(grid.cut(spec, description.surface.featureAngleDeg, carried, progress), scene);
    if (!carried) {
        if (!grid.uniform()) grid.resample(description.field.resampleSpacing, progress);
        if (!scene.hasScalar && grid.hasScalar()) {
            scene.hasScalar = true;
            scene.scalarName = grid.scalarLabel();
            scene.colorByFieldMagnitude = grid.scalarIsVectorLength();
            if (auto scalar = grid.takeScalar())
                scene.scalarField = std::make_shared<const GridField>(std::move(*scalar));
        }
        scene.field = std::make_shared<const GridField>(grid.takeVectors());
        requireOverlap(scene, description.field.spec);
    }
    scene.fieldArrays = grid.offered();
    scene.warnings.insert(scene.warnings.end(), grid.warnings().begin(), grid.warnings().end());
}

double longest(const std::vector<glm::vec3>& vectors)
{
    std::vector<float> lengths(vectors.size());
    parallelRanges(vectors.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) lengths[i] = glm::length(vectors[i]);
    });
    const auto range = finiteRange(lengths);
    return range ? (*range)[1] : 0.0;
}

void measure(Scene& scene)
{
    const SurfaceMesh& mesh = scene.surface;
    scene.maxVector =
        scene.field ? scene.field->maxMagnitude : std::max(longest(mesh.pointVectors), longest(mesh.cellVectors));
    if (!scene.hasScalar) return;
    const auto range = scene.colorByFieldMagnitude ? rangeOnSurface(mesh, *scene.field)
                       : scene.scalarField
                           ? rangeOnSurface(mesh, *scene.scalarField)
                           : finiteRange(mesh.pointScalars.empty() ? mesh.cellScalars : mesh.pointScalars);
    scene.scalarRangeKnown = range.has_value();
    if (range) scene.scalarRange = *range;
}

}  // namespace

Scene loadPart(const SceneDescription& description, const FieldPart& part, Progress function, void* context)
{
    const ProgressReport progress{function, context};
    const SurfaceSpec spec = parseSurfaceSpec(description.surface.spec);
    const std::string& field = description.field.spec;
    Scene scene;
    if (field.empty() || isBuiltinFlow(field))
        loadWithoutFieldFile(spec, description, part, progress, scene);
    else
        loadWithFieldFile(spec, description, part, progress, scene);
    measure(scene);
    return scene;
}

void finishScene(Scene& scene)
{
    if (scene.maxVector == 0) scene.warnings.push_back(scene.surface.name + ": all vectors are zero or masked");
    if (scene.hasScalar && !scene.scalarRangeKnown)
        scene.warnings.push_back(scene.surface.name + ": '" + scene.scalarName +
                                 "' has no finite value on the surface");
    std::vector<std::string> distinct;  // An array that serves twice is judged twice.
    for (std::string& warning : scene.warnings)
        if (std::find(distinct.begin(), distinct.end(), warning) == distinct.end())
            distinct.push_back(std::move(warning));
    scene.warnings = std::move(distinct);
}

Scene loadScene(const SceneDescription& description, Progress function, void* context)
{
    Scene scene = loadPart(description, {}, function, context);
    finishScene(scene);
    return scene;
}

std::uint64_t fieldBytesOf(const SceneDescription& description)
{
    const std::string& field = description.field.spec;
    if (field.empty()) return 0;
    const std::uint64_t bytes = isBuiltinFlow(field) ? builtinFlowBytes(field)
                                                     : gridFileBytes(field, {description.field.vectors, "", "", false});
    return description.field.precision == "half" ? bytes / 2 : bytes;
}

}  // namespace aeolic
