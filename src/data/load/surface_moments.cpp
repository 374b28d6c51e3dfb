#include <fmt/format.h>

#include <utility>

#include "aeolic/error.h"
#include "data/load/series/interpolate.h"
#include "data/load/surface_part.h"

namespace aeolic {
namespace {

bool sameBricks(const GridField& a, const GridField& b)
{
    return a.dims == b.dims && a.originWorld == b.originWorld && a.spacingWorld == b.spacingWorld;
}

}  // namespace

std::string earlierIsShown(const std::string& name, const char* what)
{
    return fmt::format("{}: its steps are {}: between two the earlier one is shown", name, what);
}

bool SurfacePart::hold(const Around& around, const ProgressReport& progress)
{
    return steps_.hold(around, progress);
}

/// Completes the steps just read, and puts pieces in their place. All ranks have read the same steps.
void SurfacePart::place(const Around& around)
{
    steps_.complete(around, [&](LoadedSurface& surface) { context_.reader.complete(surface, agreement_); });
    if (!context_.split.surface || !steps_.holds(around.first)) return;  // Else it stays as it is.
    std::vector<std::pair<double, PieceFacts>> unplaced;
    for (const double key : around.keys())
        if (const LoadedSurface& piece = *steps_.step(key); !piece.placed)
            unplaced.emplace_back(key, uniteFacts(agreement_, factsOf(piece)));
    agreement_.together([&] {
        for (const auto& [key, ofAll] : unplaced) {
            LoadedSurface piece = *steps_.step(key);
            placePiece(piece, ofAll);
            steps_.put(key, std::move(piece));
        }
    });
}

void SurfacePart::readAhead(const Around& around)
{
    steps_.readAhead(around);
}

void SurfacePart::readMemory(const ProgressReport& progress)
{
    steps_.put(0, context_.reader.surface(index_, 0, progress));
}

/// `change`: the sources that have other data.
SurfacePart::Next SurfacePart::prepare(const Moment& moment, const SceneChange& change)
{
    Next next;
    next.change = change;
    next.triangles = scene.allTriangles;
    if (!usesField()) next.change.field = false;
    const bool otherShape = next.otherShape = change.surface;
    if (isLookedUp()) next.change = {change.surface || change.field, false, false};  // It carries the field's values.
    LoadedSurface& surface = next.surface;
    if (otherShape) {
        const auto [first, second] = stepsAround(moment);
        bool meet = first == second || interpolable(*first, *second);
        if (scene.inPieces) meet = agreement_.all(meet);
        agreement_.together([&] { surface = surfaceAt(moment, meet); });
        next.triangles = surface.mesh.triangles.size();
        if (scene.inPieces) {
            next.triangles = std::uint64_t(agreement_.sum(std::int64_t(next.triangles)));
            std::vector<CutFacts> cuts;
            if (isCut())
                for (const double key : moment.field.keys())
                    cuts.push_back(factsOfCut(*context_.fields.step(key)->cuts[index_]));
            requireTriangles(std::move(cuts), next.triangles);
        }
    } else if (next.change.surface) {
        surface.mesh = lookup_.plain();
    }
    if (isLookedUp() && next.change.surface) {
        if (otherShape) lookup_.keepPlain(surface.mesh);
        next.triangles = lookup_.lookUpAt(surface.mesh, moment.field);
    }
    if (context_.dealsToBricks() && !isLookedUp()) next.dealtBy = withoutSamples(*scene.field);
    return next;
}

SceneChange SurfacePart::take(Next&& next, const ShownField& field)
{
    SceneChange& change = next.change;
    if (change.field) {
        scene.field = field.vectors;
        if (scalarOfField_) scene.scalarField = field.scalar;
    }
    if (change.surface) {
        if (next.otherShape) tallies_ = std::move(next.surface.tallies);
        SurfaceMesh& mesh = next.surface.mesh;
        change.triangles =
            mesh.triangles != scene.surface.triangles || mesh.positions.size() != scene.surface.positions.size();
        scene.surface = std::move(mesh);
        scene.allTriangles = next.triangles;
    }
    if (next.dealtBy && (change.surface || !sameBricks(*next.dealtBy, *scene.field))) {
        scene.surface =
            agreement_.dealToBricks(std::move(scene.surface), *scene.field, change.surface ? nullptr : &*next.dealtBy);
        change.surface = change.triangles = true;
    }
    if (change.surface) scene.reach = reachOf(agreement_, scene);
    return change;
}

/// On either side of the moment.
std::pair<const LoadedSurface*, const LoadedSurface*> SurfacePart::stepsAround(const Moment& moment) const
{
    const Around& around = aroundOf(moment);
    if (!isCut()) return steps_.at(around);
    const auto [first, second] = context_.fields.at(around);
    return {&*first->cuts[index_], &*second->cuts[index_]};
}

/// The surface at the moment, finished. `meet`: the steps on either side of it can be interpolated, on all ranks.
LoadedSurface SurfacePart::surfaceAt(const Moment& moment, bool meet)
{
    const double weight = aroundOf(moment).weight;
    const auto [first, second] = stepsAround(moment);
    for (const LoadedSurface* step : {first, second})
        if (step->scalarLabel != ownScalar_)
            throw InputError(step->where,
                             ownScalar_.empty() ? "it has an array '" + step->scalarLabel + "' to colour by"
                                                : "no array '" + ownScalar_ + "' to colour by",
                             "the arrays of the series' first step");
    std::optional<LoadedSurface> between;
    if (weight > 0 && meet) between = interpolated(*first, *second, weight);
    if (weight > 0 && !between && !std::exchange(warned_, true))
        scene.warnings.push_back(earlierIsShown(isCut() ? context_.sources.field.name : source().track.name,
                                                isCut() ? "cut into different meshes" : "different meshes"));
    if (!between) between = *first;
    LoadedSurface& surface = *between;
    finishShape(surface);
    setOrigin(surface.mesh, originWorld_);
    return std::move(surface);
}

}  // namespace aeolic
