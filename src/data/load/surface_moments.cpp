#include <fmt/format.h>

#include <utility>

#include "aeolic/error.h"
#include "data/cells_to_points.h"
#include "data/load/series/interpolate.h"
#include "data/load/surface_part.h"

namespace aeolic {
namespace {

/// A field without its samples.
GridField gridOf(const GridField& field)
{
    GridField grid = field;
    grid.samples = nullptr;
    return grid;
}

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
    return source().track.moves() && steps_.hold(around.keys(), progress);
}

/// Completes the steps just read, and puts pieces in their place. All ranks have read the same steps.
void SurfacePart::place(const Around& around)
{
    for (const double key : around.keys()) {
        if (!steps_.holds(key)) return;  // It stays as it is.
        if (steps_.at(key)->complete) continue;
        LoadedSurface surface = *steps_.at(key);
        context_.reader.complete(surface, agreement_);
        steps_.put(key, std::make_shared<const LoadedSurface>(std::move(surface)));
    }
    if (!context_.split.surface) return;
    std::vector<std::pair<double, PieceFacts>> unplaced;
    for (const double key : around.keys())
        if (const LoadedSurface& piece = *steps_.at(key); !piece.placed)
            unplaced.emplace_back(key, uniteFacts(agreement_, factsOf(piece)));
    agreement_.together([&] {
        for (const auto& [key, ofAll] : unplaced) {
            LoadedSurface piece = *steps_.at(key);
            placePiece(piece, ofAll);
            steps_.put(key, std::make_shared<const LoadedSurface>(std::move(piece)));
        }
    });
}

void SurfacePart::readAhead(const Around& around)
{
    if (source().track.moves()) steps_.readAhead(around.keys());
}

void SurfacePart::readMemory(const ProgressReport& progress)
{
    steps_.put(0, std::make_shared<const LoadedSurface>(context_.reader.surface(index_, 0, progress)));
}

/// `change`: the sources that have other data.
SurfacePart::Next SurfacePart::prepare(const Moment& moment, const SceneChange& change)
{
    Next next;
    next.change = change;
    next.triangles = scene.allTriangles;
    if (!usesField()) next.change.field = false;
    const bool otherShape = next.otherShape = change.surface;
    if (inCells_) next.change = {change.surface || change.field, false, false};  // It carries the field's values.
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
                    cuts.push_back(factsOfCut(*context_.fields.at(key)->cuts[index_]));
            requireTriangles(std::move(cuts), next.triangles);
        }
    } else if (next.change.surface) {
        surface.mesh = plainSurface_;
    }
    if (inCells_ && next.change.surface) {
        if (otherShape && !plainSurface_.triangles.empty()) plainSurface_ = surface.mesh;
        next.triangles = lookUpAt(surface.mesh, moment.field);
    }
    if (context_.dealsToBricks() && !inCells_) next.dealtBy = gridOf(*scene.field);
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
    const auto at = [&](double key) {
        return isCut() ? &*context_.fields.at(key)->cuts[index_] : steps_.at(key).get();
    };
    return {at(around.first), at(around.second)};
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
    LoadedSurface surface = between ? std::move(*between) : *first;
    finishSurface(surface, context_.description.surface.featureAngle);
    if (context_.description.surface.cells == CellValues::smooth) bringCellsToPoints(surface.mesh);
    setOrigin(surface.mesh, originWorld_);
    return surface;
}

}  // namespace aeolic
