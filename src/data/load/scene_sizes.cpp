#include "data/load/scene_sizes.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "data/builtin/flows.h"
#include "data/builtin/surfaces.h"
#include "data/load/memory_model.h"
#include "data/load/scene_sources.h"
#include "data/named_file.h"
#include "data/reading/file_questions.h"
#include "data/vtk/grid/grid_outline.h"
#include "description/color_by.h"
#include "description/scene_surfaces.h"
#include "description/vectors_text.h"

namespace aeolic {
namespace {

std::optional<SceneSizes::Surface> surfaceSize(const SurfaceSpec& spec, const std::string& file)
{
    if (spec.kind == SurfaceSpec::Kind::builtin) {
        const std::uint64_t triangles = builtinSurfaceTriangles(spec.text);
        return SceneSizes::Surface{spec.text, triangles / 2, triangles};
    }
    if (spec.kind != SurfaceSpec::Kind::file) return std::nullopt;
    const auto counts = surfaceCountsOf(file);
    if (!counts) return std::nullopt;
    return SceneSizes::Surface{spec.text, std::min(counts->points, 3 * counts->polygons), counts->polygons};
}

/// Together with another surface.
void add(std::optional<SceneSizes::Surface>& all, const std::optional<SceneSizes::Surface>& more)
{
    if (!all || !more) {
        if (more) all = more;
        return;
    }
    all->name += ", " + more->name;
    all->points = all->points && more->points ? all->points + more->points : 0;
    all->triangles += more->triangles;
}

/// The field's vectors and the colours' array, as they are kept in memory. `file`: the field's, unless it is built in.
GridOutline outlineOf(const SceneDescription& description, const std::string& file, const std::string& colorBy)
{
    const std::string& field = description.field.spec;
    GridOutline outline;
    if (field.empty()) return outline;
    if (isBuiltinFlow(field))
        outline.vectors = outlineOfBuiltinFlow(field);
    else
        outline = outlineOfGridFile(file, {parseFieldVectors(description.field.vectors).name, colorBy, {}, false});
    if (outline.vectors) outline.vectors->precision = description.field.precision;
    return outline;
}

/// The step of a file that is shown at a moment: between two steps on different grids that is the earlier. Built-in
/// data have the same size at all moments.
double keyAt(const Track& track, double moment)
{
    return track.anyMoment ? 0 : track.around(moment).first;
}

/// The surfaces' keys, then the field's.
using Keys = std::vector<double>;

Keys keysAt(const SceneSources& sources, double moment)
{
    Keys keys;
    for (const SurfaceTrack& surface : sources.surfaces) keys.push_back(keyAt(surface.track, moment));
    keys.push_back(keyAt(sources.field, moment));
    return keys;
}

/// What of the field surfaces may be coloured by: one array for all of them.
std::string fieldColorsOf(const SceneDescription& description)
{
    for (const SurfaceItem& item : surfacesOf(description)) {
        const ColorBy colorBy = parseColorBy(colorByOf(item, description));
        if (colorBy.mayBeOfField() && !colorBy.name.empty()) return colorBy.name;
    }
    return "";
}

/// Empty where it is no file.
std::string fileOf(const Track& track, double key)
{
    return track.series.steps.empty() ? "" : track.file(key).path;
}

SceneSizes sizesAt(const SceneDescription& description, const FieldPart& part, const SceneSources& sources,
                   const Keys& steps)
{
    SceneSizes sizes;
    for (std::size_t i = 0; i < sources.surfaces.size(); ++i) {
        const auto& [item, spec, track] = sources.surfaces[i];
        add(sizes.surface, surfaceSize(spec, fileOf(track, steps[i])));
        if (track.series.steps.empty()) continue;
        for (const std::string& other : track.file(steps[i]).others) add(sizes.surface, surfaceSize(spec, other));
    }
    const GridOutline outline = outlineOf(description, fileOf(sources.field, steps.back()), fieldColorsOf(description));
    sizes.field = outline.vectors;
    sizes.scalarField = outline.scalar;
    if (part.split())
        for (auto* field : {&sizes.field, &sizes.scalarField})
            if (*field) (*field)->brick = brickOf(**field, part);
    return sizes;
}

/// The file of the scene's surface; empty where it is none, or where there are several.
std::string onlySurfaceFile(const SceneDescription& description)
{
    const std::vector<SurfaceItem> items = surfacesOf(description);
    const SurfaceSpec spec = parseSurfaceSpec(items.front().spec);
    return items.size() == 1 && spec.kind == SurfaceSpec::Kind::file ? splitParts(spec.text).file : "";
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
    const SceneSources sources(description);
    const double start = startOf(description, sources.times());
    return sizesAt(description, part, sources, keysAt(sources, start));
}

void forEachStepShown(const SceneDescription& description, const FieldPart& part,
                      const std::function<void(const SceneSizes&)>& take)
{
    const auto& range = description.time.range;
    if (!range) return take(sizesOf(description, part));
    const SceneSources sources(description);
    std::set<Keys> taken;
    for (int i = 0; i < description.output.frames; ++i) {
        const auto steps = keysAt(sources, momentOfFrame(*range, i, description.output.frames));
        if (taken.insert(steps).second) take(sizesAt(description, part, sources, steps));
    }
}

std::uint64_t fieldBytesOf(const SceneDescription& description)
{
    const std::string& field = description.field.spec;
    if (field.empty()) return 0;
    const bool builtin = isBuiltinFlow(field),
               changes = builtin ? !builtinFlowTimes(field).empty() : namesSeries(field);
    const std::optional<GridField> vectors =
        outlineOf(description, builtin ? "" : firstFileOf(splitField(field).file), "").vectors;
    if (!vectors) return 0;
    return (changes ? kStepsInMemory : 1) * vectors->bytes();
}

std::uint64_t pieceFileBytesOf(const SceneDescription& description)
{
    const std::string file = onlySurfaceFile(description);
    if (file.empty()) return 0;
    const std::vector<std::uint64_t> bytes = pieceBytesOf(firstFileOf(file));
    if (bytes.size() < 2) return 0;
    return (namesSeries(file) ? kStepsInMemory : 1) * std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{0});
}

void requireListOfPieces(const SceneDescription& description)
{
    const std::string file = onlySurfaceFile(description);
    if (file.empty() || namesSeries(file)) return;
    const FileKind* kind = namedKind(file);
    if (kind && kind->use == FileUse::surface && kind->pieces == FilePieces::apart) checkReadableFile(file);
}

}  // namespace aeolic
