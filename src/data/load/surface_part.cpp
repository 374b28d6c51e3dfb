#include "data/load/surface_part.h"

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "data/builtin/surfaces.h"
#include "data/cells_to_points.h"
#include "data/load/value_percentiles.h"
#include "data/surface_range.h"
#include "data/vtk/surface/isosurface.h"

namespace aeolic {
namespace {

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

LoadContext::LoadContext(const SceneDescription& d, const Data& m, const Split& s, Agreement& a)
    : split(s),
      agreement(a),
      reader(d, m, s.field ? a.part() : FieldPart{}, s.surface ? a.part() : FieldPart{}),
      fields([this](double key, const ProgressReport& progress) {
          return std::make_shared<const FieldStep>(reader.field(key, progress));
      })
{
    reader.ranksOnHost = split.ranksOnHost;
    reader.readsForHost = agreement.isFirstOnHost();
    if (!split.field && !m.hasField()) reader.fieldReaders = agreement.part();
    if (!split.surface && !m.surface) reader.surfaceReaders = agreement.part();
}

void LoadContext::completeSteps(const Around& around)
{
    for (const double key : around.keys()) {
        if (fields.at(key)->complete) continue;
        FieldStep step = *fields.at(key);
        try {
            reader.complete(step, agreement);
        } catch (...) {
            fields.hold({}, {});  // The data read are used up.
            throw;
        }
        fields.put(key, std::make_shared<const FieldStep>(std::move(step)));
    }
}

void LoadContext::keepStep(const std::shared_ptr<const FieldStep>& step)
{
    if (onlyStep) return;
    onlyStep = step;
    if (!reader.memory.volume || !step->cells) return;
    auto own = std::make_shared<FieldStep>(*step);
    own->cells = step->cells->copy();
    onlyStep = std::move(own);
}

SurfacePart::SurfacePart(LoadContext& context, std::size_t index)
    : context_(context), index_(index), steps_([this](double key, const ProgressReport& progress) {
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
    if (track.moves()) steps_.put(track.firstKey(), std::make_shared<const LoadedSurface>(surface));
    takeSurface(std::move(surface));
    if (inPieces) scene.boundsWorld = boundsOf(ofAll);
}

void SurfacePart::takeSurface(LoadedSurface&& surface)
{
    const SurfaceSpec& spec = source().spec;
    const SurfaceSource& options = context_.description.surface;
    finishSurface(surface, options.featureAngleDeg);
    if (options.cells == CellValues::smooth) bringCellsToPoints(surface.mesh);
    scene.surface = std::move(surface.mesh);
    scene.boundsWorld = spec.kind == SurfaceSpec::Kind::builtin ? builtinSurfaceBounds(spec.text, scene.surface)
                                                                : scene.surface.bounds();
    scene.isImage = spec.kind == SurfaceSpec::Kind::image;
    if (spec.kind == SurfaceSpec::Kind::slice) scene.planeNormal = spec.normal;
    scene.frontFacesOnly = options.faces == Faces::front;
    scene.hasScalar = !surface.scalarLabel.empty();
    scene.scalarName = surface.scalarLabel;
    scene.surfaceArrays = std::move(surface.offered);
    originWorld_ = scene.surface.originWorld;
    tallies_ = surface.tallies;
    ownWarnings_ = surface.warnings;
    append(scene.warnings, ownWarnings_);
    append(scene.tallies, tallies_);
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
    if (!scalarOfField_) return;
    scene.hasScalar = true;
    scene.scalarName = step.scalarName;
    scene.colorByFieldMagnitude = step.scalarIsLength;
    scene.scalarField = step.scalar;
}

void SurfacePart::unite()
{
    scene.allTriangles = scene.surface.triangles.size();
    if (scene.inPieces) {
        uniteBounds(agreement_, scene.boundsWorld);
        scene.allTriangles = std::uint64_t(agreement_.sum(std::int64_t(scene.allTriangles)));
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
    if (!inCells_ && !scene.field) return false;
    box = inCells_ ? fieldBox_ : boundsOf(*scene.field);
    const bool mine = inCells_ ? meetsCells_ : meets(scene.surface, box);
    return scene.inPieces ? agreement_.any(mine) : mine;
}

void SurfacePart::dealToBricks()
{
    if (context_.dealsToBricks() && !inCells_)
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

/// The blank areas of all ranks together. Every triangle's middle is in one rank's brick.
BlankAreas SurfacePart::blankAreas(const std::vector<char>& within)
{
    BlankAreas areas;
    agreement_.together([&] { areas = blankAreasOf(scene, within); });
    if (scene.bricked() || scene.inPieces)
        for (std::int64_t* area : {&areas.within, &areas.masked, &areas.still, &areas.across})
            *area = agreement_.sum(*area);
    return areas;
}

/// Nothing is said where all is at rest.
void SurfacePart::warnOfBlanks(std::int64_t area)
{
    const std::vector<char> within = std::exchange(withinField_, {});
    if (!source().item.streaks || scene.maxVector == 0) return;
    const BlankAreas areas = blankAreas(within);
    // A boundary in a volume may be a wall. What else is cut out lies where its values are.
    const bool isOnPlace = isCut() && !inCells_ && !(source().spec.kind == SurfaceSpec::Kind::boundary && scene.field);
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
    std::erase_if(scene.warnings, [&](const std::string& warning) {
        return std::find(told_.begin(), told_.end(), warning) != told_.end();
    });
    aside_ = {scene.maxVector, scene.scalarRange, scene.robustRange, scene.scalarRangeKnown, std::move(scene.warnings)};
    scene.warnings = ownWarnings_;
    scene.tallies = tallies_;
    append(scene.tallies, ofField);
}

void SurfacePart::endWarnings()
{
    finish();
    scene.maxVector = aside_.maxVector;
    scene.scalarRange = aside_.scalarRange;
    scene.robustRange = aside_.robustRange;
    scene.scalarRangeKnown = aside_.scalarRangeKnown;
    append(scene.warnings, std::exchange(aside_, {}).warnings);
}

}  // namespace aeolic
