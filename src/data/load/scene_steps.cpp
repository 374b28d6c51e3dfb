#include "data/load/scene_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "data/builtin/flows.h"
#include "data/builtin/surfaces.h"
#include "data/load/scene_steps_state.h"
#include "data/mesh_tools.h"
#include "data/surface_range.h"
#include "data/vtk/surface/isosurface.h"
#include "data/vtk/surface/surface_pieces.h"

namespace aeolic {

namespace {

std::string boxText(const Bounds& b)
{
    return fmt::format("{:.6g},{:.6g},{:.6g} to {:.6g},{:.6g},{:.6g}", b.lo.x, b.lo.y, b.lo.z, b.hi.x, b.hi.y, b.hi.z);
}

[[noreturn]] void failOverlap(const Scene& scene, const std::string& fieldSpec)
{
    throw InputError(fieldSpec, "the field, from " + boxText(boundsOf(*scene.field)) + ", does not meet the surface",
                     "a field around the surface, from " + boxText(scene.boundsWorld));
}

template <class Item>
void append(std::vector<Item>& all, const std::vector<Item>& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

CutFacts cutFactsOf(const LoadedSurface& cut)
{
    return {cut.cutRange, cut.mesh.triangles.size()};
}

/// Of the whole surface, as SurfaceMesh::bounds() of all pieces together: of corners that are floats in memory, for GCC
/// 12 leaves out the rounding of some where it is but a conversion there and back.
Bounds boundsOf(const PieceFacts& ofAll)
{
    SurfaceMesh corners;
    corners.originWorld = ofAll.pointsWorld.center();
    for (const glm::dvec3& p : {ofAll.pointsWorld.lo, ofAll.pointsWorld.hi})
        corners.positions.emplace_back(p - corners.originWorld);
    return corners.bounds();
}

void checkSources(const SurfaceSpec& spec, const SceneDescription& description, const FieldPart& part)
{
    const std::string& field = description.field.spec;
    if (!field.empty() && !isBuiltinFlow(field)) return;
    if (part.split() && field.empty())
        throw InputError("--bricks", "there is nothing to split: no field, and a surface that is not in pieces",
                         "off or auto");
    if (spec.isCut())
        throw InputError("surface '" + spec.text + "'",
                         field.empty() ? "there is no field to cut it out of"
                                       : "the built-in field spans the surface and cannot be cut itself",
                         "a field from a file (--field FILE)");
    if (spec.kind == SurfaceSpec::Kind::builtin && field.empty())
        throw InputError("surface '" + spec.text + "'", "it has no vectors of its own",
                         "a field to sample on it (--field)");
}

}  // namespace

void SceneSteps::State::failColorBy(const std::string& arrays) const
{
    const bool fromFile = !description.field.spec.empty() && !isBuiltinFlow(description.field.spec);
    throw InputError(fromFile ? description.field.spec : spec.text,
                     "no array '" + description.shading.colorBy + "' to colour by",
                     "one of: " + arrays + nearestArray(description.shading.colorBy, arraysListed(arrays)));
}

LoadedSurface SceneSteps::State::loadSurface(double key, const ProgressReport& progress) const
{
    if (spec.kind == SurfaceSpec::Kind::file)
        return loadSurfaceFile(surfaceTrack.file(key), description, description.field.spec.empty(), pieces, shares,
                               progress);
    LoadedSurface surface;
    surface.mesh = makeBuiltinSurface(spec.text, key);
    surface.where = surface.mesh.name;
    surface.arrays = "none";
    return surface;
}

FieldStep SceneSteps::State::loadField(double key, const ProgressReport& progress) const
{
    const std::string colorBy = colorsFromField ? description.shading.colorBy : "";
    if (fieldTrack.anyMoment) return makeFieldStep(description, boundsWorld, part, key, colorBy);
    FieldStep step = loadFieldFile(fieldTrack.file(key), description, spec, part, colorBy, progress);
    if (!colorBy.empty() && !step.vectors && !step.cut)
        failColorBy(step.arrays + (surfaceArrays == "none" ? "" : "; on the surface: " + surfaceArrays));
    return step;
}

void SceneSteps::State::placeIn(const PieceFacts& ofAll, LoadedSurface& surface) const
{
    if (ofAll.pointsWorld.empty())
        throw InputError(spec.text, "no polygons in any of its pieces", "a surface of at least one triangle");
    placePiece(surface, ofAll);
}

void SceneSteps::State::takeSurface(LoadedSurface&& surface, Scene& scene) const
{
    finishSurface(surface, description.surface.featureAngleDeg);
    scene.surface = std::move(surface.mesh);
    scene.boundsWorld = spec.kind == SurfaceSpec::Kind::builtin ? builtinSurfaceBounds(spec.text, scene.surface)
                                                                : scene.surface.bounds();
    scene.hasScalar = !surface.scalarLabel.empty();
    scene.scalarName = surface.scalarLabel;
    scene.surfaceArrays = std::move(surface.offered);
    append(scene.warnings, surface.warnings);
    append(scene.tallies, surface.tallies);
}

void SceneSteps::State::takeFirstField(const FieldStep& step, Scene& scene) const
{
    if (step.cut) takeSurface(LoadedSurface(*step.cut), scene);
    scene.field = step.vectors;
    scene.fieldArrays = step.offered;
    if (!scene.hasScalar && step.hasScalar) {
        scene.hasScalar = true;
        scene.scalarName = step.scalarName;
        scene.colorByFieldMagnitude = step.scalarIsLength;
        scene.scalarField = step.scalar;
    }
    append(scene.tallies, step.tallies);
    if (scene.field && !fieldTrack.anyMoment && !inPieces() && !meets(scene.surface, boundsOf(*scene.field)))
        failOverlap(scene, description.field.spec);
}

SceneSteps::SceneSteps(const SceneDescription& description, const FieldPart& part, const FieldPart& pieces)
    : state_(std::make_unique<State>(description, part, pieces))
{
    State& s = *state_;
    checkSources(s.spec, description, part);
    if (s.spec.kind == SurfaceSpec::Kind::file) s.surfaceTrack = fileTrack(s.spec.text);
    if (s.spec.kind == SurfaceSpec::Kind::builtin)
        s.surfaceTrack = builtinTrack(s.spec.text, builtinSurfaceTimes(s.spec.text));
    const std::string& field = description.field.spec;
    if (!field.empty())
        s.fieldTrack = isBuiltinFlow(field) ? builtinTrack(field, builtinFlowTimes(field)) : fileTrack(field);
}

SceneSteps::~SceneSteps() = default;

PieceFacts SceneSteps::readPieces(const ProgressReport& progress)
{
    State& s = *state_;
    if (!s.pieces.split()) return {};
    const double key = s.surfaceTrack.firstKey();
    s.shares = pieceBytesOf(s.surfaceTrack.file(key).path);
    s.piece = s.loadSurface(key, progress);
    return factsOf(*s.piece);
}

std::vector<CutFacts> SceneSteps::cuts() const
{
    const State& s = *state_;
    if (!s.cutInPieces()) return {};
    if (!s.prepared) return {s.firstCut};
    std::vector<CutFacts> facts;
    for (const double key : s.prepared->second.keys()) facts.push_back(cutFactsOf(*s.fields.at(key)->cut));
    return facts;
}

void SceneSteps::requireTriangles(const std::vector<CutFacts>& ofAllPieces, std::uint64_t drawn) const
{
    const State& s = *state_;
    for (const CutFacts& cut : ofAllPieces) requireIsosurface(s.spec, s.fieldTrack.name, cut.range, cut.triangles);
    if (drawn == 0)
        throw InputError(s.spec.text, "none of its triangles has an area", "at least one triangle with an area");
}

void SceneSteps::requireOverlap(const Scene& scene, bool meets) const
{
    if (scene.field && !state_->fieldTrack.anyMoment && !meets) failOverlap(scene, state_->description.field.spec);
}

Scene SceneSteps::first(const ProgressReport& progress, const PieceFacts& ofAllPieces)
{
    State& s = *state_;
    Scene scene;
    if (!s.spec.isCut()) {
        const double key = s.surfaceTrack.firstKey();
        LoadedSurface surface = s.piece ? std::move(*s.piece) : s.loadSurface(key, progress);
        if (s.piece) s.placeIn(ofAllPieces, surface);
        s.surfaceTrack.takeStepsOf(surface.timeSteps);
        s.surfaceArrays = surface.arrays;
        s.surfaceScalar = surface.scalarLabel;
        s.colorsFromField = surface.scalarLabel.empty();
        if (s.surfaceTrack.moves()) s.surfaces.put(key, std::make_shared<const LoadedSurface>(surface));
        s.placed = {key};
        s.takeSurface(std::move(surface), scene);
        if (s.piece) scene.boundsWorld = boundsOf(ofAllPieces);
        s.piece.reset();
        s.boundsWorld = scene.boundsWorld;
    }
    if (!s.description.field.spec.empty()) {
        const double key = s.fieldTrack.firstKey();
        const auto step = std::make_shared<const FieldStep>(s.loadField(key, progress));
        s.fieldTrack.takeStepsOf(step->timeSteps);
        s.takeFirstField(*step, scene);
        if (step->cut) s.surfaceScalar = step->cut->scalarLabel;
        if (step->cut) s.firstCut = cutFactsOf(*step->cut);
        if (s.fieldTrack.moves()) s.fields.put(key, step);
        if (!scene.hasScalar && !s.description.shading.colorBy.empty())
            s.failColorBy((s.surfaceArrays == "none" ? "" : s.surfaceArrays + ", ") + step->arrays);
    } else if (!s.description.shading.colorBy.empty() && !scene.hasScalar) {
        s.failColorBy(s.surfaceArrays);
    }
    s.boundsWorld = scene.boundsWorld;
    s.originWorld = scene.surface.originWorld;
    scene.fitRadius = radiusAbout(scene.surface, scene.boundsWorld.center());
    scene.inPieces = s.inPieces();
    scene.allTriangles = scene.surface.triangles.size();
    if (s.surfaceTrack.moves() || s.fieldTrack.moves()) s.times = mergedTimes(s.surfaceTrack.times, s.fieldTrack.times);
    const auto ownFirst = [](const Track& track) { return Around{track.firstKey(), track.firstKey(), 0}; };
    s.shown = {ownFirst(s.surfaceTrack), ownFirst(s.fieldTrack)};
    measure(scene);
    return scene;
}

const std::vector<double>& SceneSteps::times() const
{
    return state_->times;
}

}  // namespace aeolic
