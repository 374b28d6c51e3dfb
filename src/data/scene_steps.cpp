#include "data/scene_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "base/memory.h"
#include "data/builtin_flows.h"
#include "data/builtin_surfaces.h"
#include "data/interpolate.h"
#include "data/load_steps.h"
#include "data/mesh_tools.h"
#include "data/step_store.h"
#include "data/surface_range.h"
#include "data/track.h"
#include "data/vtk/isosurface.h"
#include "data/vtk/surface_pieces.h"

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
        corners.positions.push_back(glm::vec3(p - corners.originWorld));
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

struct SceneSteps::State {
    State(const SceneDescription& d, const FieldPart& p, const FieldPart& s)
        : description(d),
          part(p),
          pieces(s),
          spec(parseSurfaceSpec(d.surface.spec)),
          surfaces([this](double key, const ProgressReport& progress) {
              return std::make_shared<const LoadedSurface>(loadSurface(key, progress));
          }),
          fields([this](double key, const ProgressReport& progress) {
              return std::make_shared<const FieldStep>(loadField(key, progress));
          })
    {
    }

    LoadedSurface loadSurface(double key, const ProgressReport& progress) const;
    FieldStep loadField(double key, const ProgressReport& progress) const;
    [[noreturn]] void failColorBy(const std::string& arrays) const;
    void placeIn(const PieceFacts& ofAll, LoadedSurface& surface) const;
    void takeSurface(LoadedSurface&& surface, Scene& scene) const;
    void takeFirstField(const FieldStep& step, Scene& scene) const;
    std::pair<const LoadedSurface*, const LoadedSurface*> surfaceSteps() const;
    LoadedSurface surfaceBetween(bool meets);
    void showField(Scene& scene);
    void warnOnce(bool& warned, const Track& track, const char* what);

    std::vector<double> unplaced() const;  ///< Steps prepared whose pieces are not in their place.
    bool cutInPieces() const { return spec.kind == SurfaceSpec::Kind::isosurface && part.split(); }
    bool inPieces() const { return pieces.split() || cutInPieces(); }
    bool surfaceMoves() const { return spec.isCut() ? fieldTrack.moves() : surfaceTrack.moves(); }

    const SceneDescription description;
    const FieldPart part, pieces;
    const SurfaceSpec spec;
    Track surfaceTrack, fieldTrack;
    std::vector<double> times;

    std::optional<LoadedSurface> piece;  ///< Read, until first() takes it.
    std::vector<std::uint64_t> shares;   ///< Bytes by which the pieces of every step are dealt: the first one's.
    std::vector<double> placed;          ///< Keys of the steps in memory whose pieces are in their place.
    CutFacts firstCut;

    // Of the first moment, for all others.
    Bounds boundsWorld;
    glm::dvec3 originWorld{0};
    std::string surfaceScalar;    ///< Label of the array to colour by that the surface carries, or empty.
    bool colorsFromField = true;  ///< Unless a surface that is not cut out of it has them.
    std::string surfaceArrays = "none";

    std::optional<std::pair<Around, Around>> prepared, shown;  ///< Of surface and field.
    std::optional<LoadedSurface> made;        ///< The surface of the moment prepared, until it is shown …
    std::vector<std::string> warningsToShow;  ///< … with these.
    bool warnedSurface = false, warnedField = false;
    std::shared_ptr<GridField> vectorsBetween, scalarBetween;  ///< Memory used again from moment to moment.

    StepStore<LoadedSurface> surfaces;  // Last: their threads use the others.
    StepStore<FieldStep> fields;
};

void SceneSteps::State::failColorBy(const std::string& arrays) const
{
    const bool fromFile = !description.field.spec.empty() && !isBuiltinFlow(description.field.spec);
    throw InputError(fromFile ? description.field.spec : spec.text,
                     "no array '" + description.shading.colorBy + "' to colour by", "one of: " + arrays);
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

void SceneSteps::State::warnOnce(bool& warned, const Track& track, const char* what)
{
    if (!std::exchange(warned, true))
        warningsToShow.push_back(
            fmt::format("{}: its steps are {}: between two the earlier one is shown", track.name, what));
}

/// On either side of the moment prepared.
std::pair<const LoadedSurface*, const LoadedSurface*> SceneSteps::State::surfaceSteps() const
{
    const Around& around = spec.isCut() ? prepared->second : prepared->first;
    const auto at = [&](double key) { return spec.isCut() ? &*fields.at(key)->cut : surfaces.at(key).get(); };
    return {at(around.first), at(around.second)};
}

/// The moment of the surface that was prepared.
LoadedSurface SceneSteps::State::surfaceBetween(bool meets)
{
    const Track& track = spec.isCut() ? fieldTrack : surfaceTrack;
    const double weight = (spec.isCut() ? prepared->second : prepared->first).weight;
    const auto [first, second] = surfaceSteps();
    for (const LoadedSurface* step : {first, second})
        if (step->scalarLabel != surfaceScalar)
            throw InputError(step->where,
                             surfaceScalar.empty() ? "it has an array '" + step->scalarLabel + "' to colour by"
                                                   : "no array '" + surfaceScalar + "' to colour by",
                             "the arrays of the series' first step");
    if (weight > 0) {
        if (meets)
            if (auto between = interpolated(*first, *second, weight)) return std::move(*between);
        warnOnce(warnedSurface, track, spec.isCut() ? "cut into different meshes" : "different meshes");
    }
    return *first;
}

void SceneSteps::State::showField(Scene& scene)
{
    const Around& around = prepared->second;
    const FieldStep &first = *fields.at(around.first), &second = *fields.at(around.second);
    if (!first.vectors) return;  // The cut carries them.
    const auto same = [](const auto& a, const auto& b) { return (!a && !b) || (a && b && sameGrid(*a, *b)); };
    const bool meet = same(first.vectors, second.vectors) && same(first.scalar, second.scalar);
    if (around.weight > 0 && !meet) warnOnce(warnedField, fieldTrack, "on different grids");
    if (around.weight == 0 || !meet) {
        scene.field = first.vectors;
        scene.scalarField = first.scalar;
        return;
    }
    vectorsBetween = interpolated(*first.vectors, *second.vectors, around.weight, std::move(vectorsBetween));
    if (first.scalar)
        scalarBetween = interpolated(*first.scalar, *second.scalar, around.weight, std::move(scalarBetween));
    scene.field = vectorsBetween;
    scene.scalarField = first.scalar ? scalarBetween : nullptr;
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

bool SceneSteps::prepare(double moment, const ProgressReport& progress)
{
    State& s = *state_;
    if (!moves()) return false;
    const std::pair<Around, Around> around{s.surfaceTrack.around(moment), s.fieldTrack.around(moment)};
    s.prepared.reset();
    s.made.reset();
    s.warningsToShow.clear();
    const std::vector<double> wanted = around.first.keys();  // Also where some cannot be read: then only here, perhaps.
    std::erase_if(s.placed, [&](double key) { return std::find(wanted.begin(), wanted.end(), key) == wanted.end(); });
    bool loaded = s.surfaceTrack.moves() && s.surfaces.hold(around.first.keys(), progress);
    if (s.fieldTrack.moves() && s.fields.hold(around.second.keys(), progress)) loaded = true;
    s.prepared = around;
    return loaded;
}

std::vector<double> SceneSteps::State::unplaced() const
{
    if (!pieces.split() || !surfaceTrack.moves() || !prepared) return {};
    std::vector<double> keys = prepared->first.keys();
    std::erase_if(keys, [&](double key) { return std::find(placed.begin(), placed.end(), key) != placed.end(); });
    return keys;
}

std::vector<PieceFacts> SceneSteps::unplacedPieces() const
{
    std::vector<PieceFacts> facts;
    for (const double key : state_->unplaced()) facts.push_back(factsOf(*state_->surfaces.at(key)));
    return facts;
}

void SceneSteps::placePieces(const std::vector<PieceFacts>& ofAllPieces)
{
    State& s = *state_;
    const std::vector<double> keys = s.unplaced();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        LoadedSurface surface = *s.surfaces.at(keys[i]);
        s.placeIn(ofAllPieces.at(i), surface);
        s.surfaces.put(keys[i], std::make_shared<const LoadedSurface>(std::move(surface)));
        s.placed.push_back(keys[i]);
    }
}

bool SceneSteps::surfaceMeets() const
{
    const State& s = *state_;
    if (!s.surfaceMoves() || !s.prepared) return true;
    const auto [first, second] = s.surfaceSteps();
    return first == second || interpolable(*first, *second);
}

std::optional<std::size_t> SceneSteps::make(bool meets)
{
    State& s = *state_;
    if (!s.surfaceMoves() || !s.prepared || s.prepared == s.shown) return std::nullopt;
    LoadedSurface surface = s.surfaceBetween(meets);
    finishSurface(surface, s.description.surface.featureAngleDeg);
    setOrigin(surface.mesh, s.originWorld);
    s.made = std::move(surface);
    return s.made->mesh.triangles.size();
}

bool SceneSteps::dealsToBricks() const
{
    return state_->pieces.split() && state_->part.split();
}

SceneChange SceneSteps::show(Scene& scene)
{
    State& s = *state_;
    SceneChange change;
    if (!s.prepared || s.prepared == s.shown) return change;
    s.shown.reset();
    if (s.surfaceMoves() && !s.made) make(surfaceMeets());
    if (s.fieldTrack.moves()) {
        s.showField(scene);
        change.field = true;
    }
    if (s.surfaceMoves()) {  // Nothing can fail any more.
        SurfaceMesh& mesh = s.made->mesh;
        change.surface = true;
        change.triangles =
            mesh.triangles != scene.surface.triangles || mesh.positions.size() != scene.surface.positions.size();
        scene.surface = std::move(mesh);
        scene.allTriangles = scene.surface.triangles.size();
        s.made.reset();
    }
    append(scene.warnings, std::exchange(s.warningsToShow, {}));
    s.shown = s.prepared;
    return change;
}

void SceneSteps::readAhead(double moment)
{
    State& s = *state_;
    if (!moves() || !s.prepared) return;
    if (s.surfaceTrack.moves()) s.surfaces.readAhead(s.surfaceTrack.around(moment).keys());
    if (!s.fieldTrack.moves()) return;
    constexpr double readingOverhead = 1.3;  // Conversions, the file's own cache.
    const double needed = readingOverhead * double(s.fields.at(s.prepared->second.first)->bytes());
    if (needed > double(availableMemoryBytes())) return;
    s.fields.readAhead(s.fieldTrack.around(moment).keys());
}

std::size_t SceneSteps::held() const
{
    return state_->surfaces.held() + state_->fields.held();
}

}  // namespace aeolic
