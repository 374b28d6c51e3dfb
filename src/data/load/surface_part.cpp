#include "data/load/surface_part.h"

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "base/append.h"
#include "data/builtin/surfaces.h"
#include "data/cells_to_points.h"
#include "data/load/blank_surface.h"
#include "data/load/value_percentiles.h"
#include "data/named_file.h"
#include "data/surface_range.h"
#include "data/vtk/surface/isosurface.h"
#include "description/scene_surfaces.h"

namespace aeolic {
namespace {

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

/// OpenFOAM's wall shear stress is the wall's force on the flow.
bool pointsAgainstFlow(const Track& track, const std::string& vectors)
{
    return vectors == "wallShearStress" && !track.series.steps.empty() &&
           namedKindHas(track.series.steps.front().path, kIsFolder);
}

}  // namespace

SurfacePart::SurfacePart(LoadContext& context, std::size_t index)
    : context_(context),
      index_(index),
      lookup_(context, index, scene),
      steps_(source().track, [this](double key, const ProgressReport& progress) {
          return std::make_shared<const LoadedSurface>(context_.reader.surface(index_, key, progress));
      })
{
    const Split& split = context.split;
    scene.inPieces = split.surface || (split.field && source().spec.kind == SurfaceSpec::Kind::isosurface);
}

LoadedSurface SurfacePart::readFirst(const ProgressReport& progress)
{
    return context_.reader.surface(index_, source().track.firstKey(), progress);
}

void SurfacePart::placePiece(LoadedSurface& piece, const PieceFacts& ofAll) const
{
    if (ofAll.pointsWorld.empty())
        throw InputError(source().spec.text, "no polygons in any of its pieces", "a surface of at least one triangle");
    aeolic::placePiece(piece, ofAll);
}

void SurfacePart::takeFirst(LoadedSurface&& surface, const PieceFacts& ofAll)
{
    const bool inPieces = context_.split.surface;
    Track& track = source().track;
    if (inPieces) placePiece(surface, ofAll);
    track.takeStepsOf(surface.timeSteps);
    ownScalar_ = surface.scalarLabel;
    ask().arrays = surface.arrays;
    if (track.moves()) steps_.put(track.firstKey(), LoadedSurface(surface));
    takeSurface(std::move(surface));
    if (inPieces) scene.boundsWorld = boundsOf(ofAll);
}

void SurfacePart::takeSurface(LoadedSurface&& surface)
{
    const SurfaceSpec& spec = source().spec;
    const SurfaceSource& options = context_.description.surface;
    finishShape(surface);
    scene.surface = std::move(surface.mesh);
    scene.boundsWorld = spec.kind == SurfaceSpec::Kind::builtin ? builtinSurfaceBounds(spec.text, scene.surface)
                                                                : scene.surface.bounds();
    scene.isImage = spec.kind == SurfaceSpec::Kind::image;
    if (spec.kind == SurfaceSpec::Kind::slice) scene.planeNormal = vectorOf(spec.normal);
    scene.frontFacesOnly = options.faces == Faces::front;
    scene.hasScalar = !surface.scalarLabel.empty();
    scene.scalarName = surface.scalarLabel;
    scene.ofVectors = surface.ofVectors;
    scene.vectorsName = surface.vectorsName;
    scene.againstFlow.reset();
    if (pointsAgainstFlow(source().track, surface.vectorsName)) scene.againstFlow = {spec.text, surface.vectorsName};
    scene.surfaceArrays = std::move(surface.offered);
    originWorld_ = scene.surface.originWorld;
    tallies_ = surface.tallies;
    ownWarnings_ = surface.warnings;
    appendAll(scene.warnings, ownWarnings_);
    appendAll(scene.tallies, tallies_);
}

/// Where the vectors' part along the normal is drawn, that of a slice is its own, whichever way its cells lie, and that
/// of an isosurface leads to higher values. VTK winds triangles the other way.
void SurfacePart::finishShape(LoadedSurface& surface) const
{
    const SurfaceSource& options = context_.description.surface;
    const bool isWound = surface.mesh.normals.empty();
    finishSurface(surface, options.featureAngle);
    if (options.cells == CellValues::smooth) bringCellsToPoints(surface.mesh);
    if (!needsNormal(parseArray(ask().colorBy.name).part)) return;
    const SurfaceSpec& spec = source().spec;
    const glm::vec3 plane(vectorOf(spec.normal));
    for (glm::vec3& normal : surface.mesh.normals) {
        const bool isBehind = spec.kind == SurfaceSpec::Kind::slice && glm::dot(normal, plane) < 0;
        if (isBehind || (spec.kind == SurfaceSpec::Kind::isosurface && isWound)) normal = -normal;
    }
}

void SurfacePart::takeFirstField(const FieldStep& step)
{
    if (isCut()) {
        const LoadedSurface& cut = *step.cuts[index_];
        ownScalar_ = cut.scalarLabel;
        firstCut_ = factsOfCut(cut);
        takeSurface(LoadedSurface(cut));
    }
    scalarOfField_ = !scene.hasScalar && ask().colorsFromField;
    scene.fieldArrays = step.offered;
    if (usesField()) scene.field = step.vectors;
    if (ask().fieldVectors) scene.vectorsName = step.vectorsName;
    if (!scalarOfField_) return;
    if (needsNormal(step.ofVectors) && !ask().fieldVectors)
        throw InputError(source().spec.text, "'" + step.scalarName + "' to colour by, but no streaks that follow it",
                         "the vectors that the surface's streaks follow");
    scene.hasScalar = true;
    scene.scalarName = step.scalarName;
    scene.ofVectors = step.ofVectors;
    scene.scalarField = step.scalar;
}

void SurfacePart::lookUp(const std::shared_ptr<const FieldStep>& step)
{
    lookup_.lookUpFirst(step, scalarOfField_);
}

void SurfacePart::unite()
{
    scene.allTriangles = scene.surface.triangles.size();
    if (scene.inPieces) {
        uniteBounds(agreement_, scene.boundsWorld);
        scene.allTriangles = std::uint64_t(agreement_.sum(std::int64_t(scene.allTriangles)));
        // A rank without a triangle may not know it.
        const std::string& own = scene.vectorsName;
        const auto names = agreement_.distinct(own.empty() ? std::vector<std::string>{} : std::vector{own});
        if (names.size() == 1) scene.vectorsName = names.front();
    }
    scene.reach = reachOf(agreement_, scene);
    scene.fitRadius = scene.reach.radius;
    if (scene.inPieces) requireTriangles({firstCut_}, scene.allTriangles);
}

void SurfacePart::requireTriangles(std::vector<CutFacts> mine, std::uint64_t drawn)
{
    const SurfaceSpec& spec = source().spec;
    if (!isCut()) mine.clear();
    for (CutFacts& cut : mine) cut = uniteFacts(agreement_, cut);
    agreement_.together([&] {
        for (const CutFacts& cut : mine) requireIsosurface(spec, context_.sources.field.name, cut.range, cut.triangles);
        if (drawn == 0)
            throw InputError(spec.text, "none of its triangles has an area", "at least one triangle with an area");
    });
}

bool SurfacePart::meetsField(Bounds& box) const
{
    if (isLookedUp()) {
        box = lookup_.box();
        return lookup_.meets();
    }
    if (!scene.field) return false;
    box = boundsOf(*scene.field);
    const bool mine = meets(scene.surface, box);
    return scene.inPieces ? agreement_.any(mine) : mine;
}

void SurfacePart::dealToBricks()
{
    if (context_.dealsToBricks() && !isLookedUp())
        scene.surface = agreement_.dealToBricks(std::move(scene.surface), *scene.field, nullptr);
}

void SurfacePart::measureScene()
{
    agreement_.together([&] { measure(scene); });
    if (context_.split.any()) uniteRanges(agreement_, scene);
    if (!scene.hasScalar || !scene.scalarRangeKnown) return;
    const bool shared = scene.inPieces || scene.bricked();
    const auto robust = robustRangeOf(scene, shared ? &agreement_ : nullptr);
    scene.robustRange = robust && (*robust)[0] < (*robust)[1] ? *robust : scene.scalarRange;
}

std::int64_t SurfacePart::area() const
{
    return areaOf(scene);
}

/// Nothing is said where all is at rest.
void SurfacePart::warnOfBlanks(std::int64_t area)
{
    const std::vector<char> within = lookup_.takeWithin();
    if (!source().item.streaks || scene.maxVector == 0) return;
    const BlankAreas areas = blankAreasOf(scene, within, agreement_);
    // A boundary in a volume may be a wall. What else is cut out lies where its values are.
    const bool isBoundary = source().spec.kind == SurfaceSpec::Kind::boundary;
    const bool isOnPlace = isCut() && !isLookedUp() && !(isBoundary && scene.field);
    const VectorsFrom from = !ask().fieldVectors                             ? VectorsFrom::surface
                             : isOnPlace                                     ? VectorsFrom::cut
                             : context_.description.field.offset.has_value() ? VectorsFrom::fieldAtOffset
                                                                             : VectorsFrom::field;
    const std::string warning = blankWarning(source().spec.text, areas, area, from);
    if (!warning.empty()) scene.warnings.push_back(warning);
}

void SurfacePart::finish()
{
    finishScene(scene, source().item.streaks);
    told_ = scene.warnings;
}

void SurfacePart::beginWarnings(const std::vector<Tally>& ofField)
{
    std::erase_if(scene.warnings,
                  [&](const std::string& warning) { return std::ranges::find(told_, warning) != told_.end(); });
    rangesAside_ = static_cast<const SceneRanges&>(scene);
    warningsAside_ = std::move(scene.warnings);
    scene.warnings = ownWarnings_;
    scene.tallies = tallies_;
    appendAll(scene.tallies, ofField);
}

void SurfacePart::endWarnings()
{
    finish();
    static_cast<SceneRanges&>(scene) = rangesAside_;
    appendAll(scene.warnings, std::exchange(warningsAside_, {}));
}

}  // namespace aeolic
