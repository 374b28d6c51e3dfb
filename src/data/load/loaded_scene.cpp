#include "data/load/loaded_scene.h"

#include <fmt/format.h>

#include <utility>

#include "aeolic/error.h"
#include "data/builtin/surfaces.h"
#include "data/cells_to_points.h"
#include "data/fingerprint.h"
#include "data/load/blank_surface.h"
#include "data/load/loaded_scene_state.h"
#include "data/surface_range.h"
#include "data/vtk/surface/isosurface.h"

namespace aeolic {
namespace {

std::string boxText(const Bounds& b)
{
    return fmt::format("{:.6g},{:.6g},{:.6g} to {:.6g},{:.6g},{:.6g}", b.lo.x, b.lo.y, b.lo.z, b.hi.x, b.hi.y, b.hi.z);
}

template <class Item>
void append(std::vector<Item>& all, const std::vector<Item>& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

/// The whole surface's bounds, as SurfaceMesh::bounds() of all pieces together finds them. Corners are stored as floats
/// for that: GCC 12 leaves out some roundings where a value is merely converted there and back.
Bounds boundsOf(const PieceFacts& ofAll)
{
    SurfaceMesh corners;
    corners.originWorld = ofAll.pointsWorld.center();
    for (const glm::dvec3& p : {ofAll.pointsWorld.lo, ofAll.pointsWorld.hi})
        corners.positions.emplace_back(p - corners.originWorld);
    return corners.bounds();
}

}  // namespace

LoadedScene::State::State(const SceneDescription& d, const Data& m, const Split& s, Agreement& a)
    : split(s),
      agreement(a),
      reader(d, m, s.field ? a.part() : FieldPart{}, s.surface ? a.part() : FieldPart{}),
      surfaces([this](double key, const ProgressReport& progress) {
          return std::make_shared<const LoadedSurface>(reader.surface(key, progress));
      }),
      fields([this](double key, const ProgressReport& progress) {
          return std::make_shared<const FieldStep>(reader.field(key, progress));
      })
{
    reader.ranksOnHost = split.ranksOnHost;
    scene.inPieces = split.surface || (split.field && sources.surfaceSpec.kind == SurfaceSpec::Kind::isosurface);
}

void LoadedScene::State::load(const ProgressReport& progress)
{
    const bool cut = sources.surfaceSpec.isCut();
    LoadedSurface surface;
    PieceFacts ofAll;
    std::shared_ptr<const FieldStep> field;
    agreement.together([&] {
        // What both have is the field's, so it is read first; a built-in flow has to know where the surface is.
        if (!sources.field.name.empty() && !sources.field.anyMoment) field = readFirstField(progress);
        if (!cut) surface = reader.surface(sources.surface.firstKey(), progress);
    });
    if (split.surface) ofAll = uniteFacts(agreement, factsOf(surface));
    agreement.together([&] {
        if (!cut) takeFirstSurface(std::move(surface), ofAll);
        if (!sources.field.name.empty() && !field) field = readFirstField(progress);
        takeFirstField(field);
    });
    if (field && (field->cells || looksUpUniform(*field))) lookUpFirst(field);
    field.reset();
    uniteFirst();
    const std::int64_t area = scene.inPieces ? agreement.sum(areaOf(scene)) : areaOf(scene);
    if (dealsToBricks() && !inCells)
        scene.surface = agreement.dealToBricks(std::move(scene.surface), *scene.field, nullptr);
    measureAll();
    warnOfBlanks(area);
    if (split.any()) {
        scene.tallies = sumTallies(agreement, scene.tallies);
        scene.warnings = agreement.distinct(scene.warnings);
    }
    if (moves() && atRest(scene)) {
        moveTo(times.back(), progress);
        measureAll();
    }
    finishScene(scene);
    if (agreement.part().split()) agreement.requireSame("the scene's data", fingerprint(scene));
    moveTo(startOf(description, times), progress);
}

void LoadedScene::State::place(LoadedSurface& piece, const PieceFacts& ofAll) const
{
    if (ofAll.pointsWorld.empty())
        throw InputError(sources.surfaceSpec.text, "no polygons in any of its pieces",
                         "a surface of at least one triangle");
    placePiece(piece, ofAll);
}

void LoadedScene::State::takeFirstSurface(LoadedSurface&& surface, const PieceFacts& ofAll)
{
    if (split.surface) place(surface, ofAll);
    sources.surface.takeStepsOf(surface.timeSteps);
    surfaceScalar = surface.scalarLabel;
    reader.surfaceArrays = surface.arrays;
    if (sources.surface.moves())
        surfaces.put(sources.surface.firstKey(), std::make_shared<const LoadedSurface>(surface));
    takeSurface(std::move(surface));
    if (split.surface) scene.boundsWorld = boundsOf(ofAll);
    reader.boundsWorld = scene.boundsWorld;
}

void LoadedScene::State::takeSurface(LoadedSurface&& surface)
{
    const SurfaceSpec& spec = sources.surfaceSpec;
    finishSurface(surface, description.surface.featureAngleDeg);
    if (description.surface.cells == CellValues::smooth) bringCellsToPoints(surface.mesh);
    scene.surface = std::move(surface.mesh);
    scene.boundsWorld = spec.kind == SurfaceSpec::Kind::builtin ? builtinSurfaceBounds(spec.text, scene.surface)
                                                                : scene.surface.bounds();
    scene.isImage = parseSurfaceSpec(description.surface.spec).kind == SurfaceSpec::Kind::image;
    scene.frontFacesOnly = description.surface.faces == Faces::front;
    scene.hasScalar = !surface.scalarLabel.empty();
    scene.scalarName = surface.scalarLabel;
    scene.surfaceArrays = std::move(surface.offered);
    append(scene.warnings, surface.warnings);
    append(scene.tallies, surface.tallies);
}

/// Whether the field has what is coloured by decides where it comes from, in all moments.
std::shared_ptr<const FieldStep> LoadedScene::State::readFirstField(const ProgressReport& progress)
{
    auto step = std::make_shared<const FieldStep>(reader.field(sources.field.firstKey(), progress));
    const bool has = step->hasScalar || (step->cut && !step->cut->scalarLabel.empty());
    reader.colorsFromField = reader.colorsFromField && has;
    reader.colorsFromSurface = reader.colorsFromSurface && !has;
    return step;
}

/// And what follows from surface and field together. `step`: null where there is no field.
void LoadedScene::State::takeFirstField(const std::shared_ptr<const FieldStep>& step)
{
    if (step) {
        sources.field.takeStepsOf(step->timeSteps);
        if (sources.field.moves()) fields.put(sources.field.firstKey(), step);
        if (step->cut) {
            surfaceScalar = step->cut->scalarLabel;
            firstCut = factsOfCut(*step->cut);
            takeSurface(LoadedSurface(*step->cut));
        }
        scene.field = step->vectors;
        scene.fieldArrays = step->offered;
        if (!scene.hasScalar && step->hasScalar) {
            scene.hasScalar = true;
            scene.scalarName = step->scalarName;
            scene.colorByFieldMagnitude = step->scalarIsLength;
            scene.scalarField = step->scalar;
        }
        const bool everyRankHasAll = split.surface && !split.field;
        if (!everyRankHasAll || agreement.part().rank == 0) append(scene.tallies, step->tallies);
    }
    if (!scene.hasScalar && !description.shading.colorBy.empty()) reader.failColorBy(step ? step->arrays : "");
    reader.firstIsRead = true;
    reader.boundsWorld = scene.boundsWorld;
    originWorld = scene.surface.originWorld;
    times = sources.times();
    const auto ownFirst = [](const Track& track) { return Around{track.firstKey(), track.firstKey(), 0}; };
    shown = Moment{ownFirst(sources.surface), ownFirst(sources.field)};
}

/// What only all parts together tell.
void LoadedScene::State::uniteFirst()
{
    scene.allTriangles = scene.surface.triangles.size();
    if (scene.inPieces) {
        uniteBounds(agreement, scene.boundsWorld);
        scene.allTriangles = std::uint64_t(agreement.sum(std::int64_t(scene.allTriangles)));
    }
    scene.reach = reachOf(agreement, scene);
    scene.fitRadius = scene.reach.radius;
    if (scene.inPieces) requireTriangles({firstCut}, scene.allTriangles);
    requireOverlap();
}

void LoadedScene::State::requireTriangles(std::vector<CutFacts> mine, std::uint64_t drawn)
{
    if (!sources.surfaceSpec.isCut()) mine.clear();
    for (CutFacts& cut : mine) cut = uniteFacts(agreement, cut);
    agreement.together([&] {
        for (const CutFacts& cut : mine)
            requireIsosurface(sources.surfaceSpec, sources.field.name, cut.range, cut.triangles);
        if (drawn == 0)
            throw InputError(sources.surfaceSpec.text, "none of its triangles has an area",
                             "at least one triangle with an area");
    });
}

/// A built-in flow is where the surface is; another field may be elsewhere.
void LoadedScene::State::requireOverlap()
{
    if (!(scene.field || inCells) || sources.field.anyMoment) return;
    const Bounds box = inCells ? fieldBox : boundsOf(*scene.field);
    bool meetsField = inCells ? meetsCells : meets(scene.surface, box);
    if (scene.inPieces) meetsField = agreement.any(meetsField);
    agreement.together([&] {
        if (!meetsField)
            throw InputError(description.field.spec, "the field, from " + boxText(box) + ", does not meet the surface",
                             "a field around the surface, from " + boxText(scene.boundsWorld));
    });
}

void LoadedScene::State::measureAll()
{
    agreement.together([&] { measure(scene); });
    if (split.any()) uniteRanges(agreement, scene);
}

/// The blank areas of all ranks together. Every triangle's middle is in one rank's brick.
BlankAreas LoadedScene::State::blankAreas(const std::vector<char>& within)
{
    BlankAreas areas;
    agreement.together([&] { areas = blankAreasOf(scene, within); });
    if (scene.bricked() || scene.inPieces)
        for (std::int64_t* area : {&areas.within, &areas.masked, &areas.still, &areas.across})
            *area = agreement.sum(*area);
    return areas;
}

/// `area`: of the whole surface. Nothing is said where all is at rest.
void LoadedScene::State::warnOfBlanks(std::int64_t area)
{
    const std::vector<char> within = std::exchange(withinField, {});
    if (scene.maxVector == 0) return;
    const BlankAreas areas = blankAreas(within);
    const std::string warning = blankWarning(sources.surfaceSpec.text, areas, area, !description.field.spec.empty());
    if (!warning.empty()) scene.warnings.push_back(warning);
}

LoadedScene::LoadedScene(const SceneDescription& description, const Split& split, Agreement& agreement,
                         const ProgressReport& progress, const Data& memory)
{
    agreement.together([&] { state_ = std::make_unique<State>(description, memory, split, agreement); });
    state_->load(progress);
    state_->forgetMemory();
}

LoadedScene::~LoadedScene() = default;
LoadedScene::LoadedScene(LoadedScene&&) noexcept = default;
LoadedScene& LoadedScene::operator=(LoadedScene&&) noexcept = default;

const Scene& LoadedScene::scene() const
{
    return state_->scene;
}

SceneChange LoadedScene::moveTo(double moment, const ProgressReport& progress)
{
    return state_->moveTo(moment, progress);
}

const std::vector<double>& LoadedScene::times() const
{
    return state_->times;
}

SceneChange LoadedScene::replace(const Data& memory, double moment, const ProgressReport& progress)
{
    return state_->replace(memory, moment, progress);
}

void LoadedScene::warn(std::string warning)
{
    state_->scene.warnings.push_back(std::move(warning));
}

std::size_t LoadedScene::held() const
{
    return state_->surfaces.held() + state_->fields.held();
}

Scene LoadedScene::take() &&
{
    return std::move(state_->scene);
}

void nameMemory(SceneDescription& description, const Data& memory)
{
    if (memory.surface) description.surface.spec = "surface in memory";
    if (memory.grid) description.field.spec = "grid in memory";
}

Scene loadScene(const SceneDescription& description, const Split& split, Agreement& agreement,
                const ProgressReport& progress)
{
    return LoadedScene(description, split, agreement, progress).take();
}

Scene loadScene(const SceneDescription& description, const ProgressReport& progress)
{
    OneRank alone;
    return loadScene(description, {}, alone, progress);
}

}  // namespace aeolic
