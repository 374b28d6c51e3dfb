#include <fmt/format.h>

#include <utility>

#include "aeolic/error.h"
#include "data/cells_to_points.h"
#include "data/fingerprint.h"
#include "data/load/interpolate.h"
#include "data/load/loaded_scene_state.h"
#include "data/load/memory_model.h"

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

SceneChange LoadedScene::State::moveTo(double moment, const ProgressReport& progress)
{
    if (!moves()) return {};
    const Moment to = sources.around(moment);
    bool loaded = false;
    agreement.together([&] { loaded = hold(to, progress); });
    if (split.surface && sources.surface.moves()) placePieces(to);
    SceneChange change;
    if (shown != to) change = show(to, {sources.surfaceMoves(), false, sources.field.moves()});
    // All ranks load the same steps, unless one of them failed to read one before.
    if (agreement.part().split() && agreement.any(loaded))
        agreement.requireSame(fmt::format("the scene's data at time {}", moment), fingerprint(scene));
    return change;
}

SceneChange LoadedScene::State::replace(const Data& memory, double moment, const ProgressReport& progress)
{
    const Moment at = sources.around(moment);
    SceneChange change{memory.surface || (memory.grid && sources.surfaceSpec.isCut()), false, memory.grid.has_value()};
    if (shown != at) {  // Going there failed half-way.
        change.surface |= sources.surfaceMoves();
        change.field |= sources.field.moves();
    }
    const auto forget = [&] {
        forgetMemory();
        if (memory.surface) surfaces.hold({}, {});
        if (memory.grid) fields.hold({}, {});
    };
    try {
        agreement.together([&] {
            if ((memory.surface && !reader.memory.surface) || (memory.grid && !reader.memory.grid))
                throw InputError(memory.surface && !reader.memory.surface ? "surface" : "grid",
                                 "the renderer was made without one in memory", "what it was made with");
            if (memory.surface) reader.memory.surface = memory.surface;
            if (memory.grid) reader.memory.grid = memory.grid;
            if (memory.surface) surfaces.put(0, std::make_shared<const LoadedSurface>(reader.surface(0, progress)));
            if (memory.grid) fields.put(0, std::make_shared<const FieldStep>(reader.field(0, progress)));
            hold(at, progress);
        });
        if (split.surface && (memory.surface || sources.surface.moves())) placePieces(at);
        change = show(at, change);
        if (onlyStep && memory.grid) onlyStep = fields.at(0);
    } catch (...) {
        forget();
        throw;
    }
    forget();
    return change;
}

void LoadedScene::State::forgetMemory()
{
    if (reader.memory.surface) reader.memory.surface = Surface{};
    if (reader.memory.grid) reader.memory.grid = Grid{};
}

/// Brings the moment's steps into memory, and drops others. Whether any was loaded.
bool LoadedScene::State::hold(const Moment& moment, const ProgressReport& progress)
{
    bool loaded = sources.surface.moves() && surfaces.hold(moment.surface.keys(), progress);
    if (sources.field.moves() && fields.hold(moment.field.keys(), progress)) loaded = true;
    return loaded;
}

/// Puts the pieces just read in their place. All ranks have read the same steps.
void LoadedScene::State::placePieces(const Moment& moment)
{
    std::vector<std::pair<double, PieceFacts>> steps;
    for (const double key : moment.surface.keys())
        if (const LoadedSurface& piece = *surfaces.at(key); !piece.placed)
            steps.emplace_back(key, uniteFacts(agreement, factsOf(piece)));
    agreement.together([&] {
        for (const auto& [key, ofAll] : steps) {
            LoadedSurface piece = *surfaces.at(key);
            place(piece, ofAll);
            surfaces.put(key, std::make_shared<const LoadedSurface>(std::move(piece)));
        }
    });
}

/// First all that may fail, then what is shown changes. `change`: the sources that have other data.
SceneChange LoadedScene::State::show(const Moment& moment, SceneChange change)
{
    const bool otherShape = change.surface;
    if (inCells) change = {change.surface || change.field, false, false};  // The surface carries the field's values.
    LoadedSurface surface;
    std::uint64_t triangles = scene.allTriangles;
    if (otherShape) {
        const auto [first, second] = surfaceSteps(moment);
        bool meet = first == second || interpolable(*first, *second);
        if (scene.inPieces) meet = agreement.all(meet);
        agreement.together([&] { surface = surfaceAt(moment, meet); });
        triangles = surface.mesh.triangles.size();
        if (scene.inPieces) {
            triangles = std::uint64_t(agreement.sum(std::int64_t(triangles)));
            std::vector<CutFacts> cuts;
            if (sources.surfaceSpec.isCut())
                for (const double key : moment.field.keys()) cuts.push_back(factsOfCut(*fields.at(key)->cut));
            requireTriangles(std::move(cuts), triangles);
        }
    } else if (change.surface) {
        surface.mesh = plainSurface;
    }
    if (inCells && change.surface) {
        if (otherShape && !plainSurface.triangles.empty()) plainSurface = surface.mesh;
        triangles = lookUpAt(surface.mesh, moment.field);
    }
    std::optional<GridField> dealtBy;
    if (dealsToBricks() && !inCells) dealtBy = gridOf(*scene.field);
    shown.reset();
    if (change.field) agreement.together([&] { showField(moment.field); });
    shown = moment;
    if (change.surface) {
        SurfaceMesh& mesh = surface.mesh;
        change.triangles =
            mesh.triangles != scene.surface.triangles || mesh.positions.size() != scene.surface.positions.size();
        scene.surface = std::move(mesh);
        scene.allTriangles = triangles;
    }
    if (dealtBy && (change.surface || !sameBricks(*dealtBy, *scene.field))) {
        scene.surface =
            agreement.dealToBricks(std::move(scene.surface), *scene.field, change.surface ? nullptr : &*dealtBy);
        change.surface = change.triangles = true;
    }
    if (change.surface) scene.reach = reachOf(agreement, scene);
    return change;
}

/// On either side of the moment.
std::pair<const LoadedSurface*, const LoadedSurface*> LoadedScene::State::surfaceSteps(const Moment& moment) const
{
    const bool cut = sources.surfaceSpec.isCut();
    const Around& around = cut ? moment.field : moment.surface;
    const auto at = [&](double key) { return cut ? &*fields.at(key)->cut : surfaces.at(key).get(); };
    return {at(around.first), at(around.second)};
}

/// The surface at the moment, finished. `meet`: the steps on either side of it can be interpolated, on all ranks.
LoadedSurface LoadedScene::State::surfaceAt(const Moment& moment, bool meet)
{
    const bool cut = sources.surfaceSpec.isCut();
    const double weight = (cut ? moment.field : moment.surface).weight;
    const auto [first, second] = surfaceSteps(moment);
    for (const LoadedSurface* step : {first, second})
        if (step->scalarLabel != surfaceScalar)
            throw InputError(step->where,
                             surfaceScalar.empty() ? "it has an array '" + step->scalarLabel + "' to colour by"
                                                   : "no array '" + surfaceScalar + "' to colour by",
                             "the arrays of the series' first step");
    std::optional<LoadedSurface> between;
    if (weight > 0 && meet) between = interpolated(*first, *second, weight);
    if (weight > 0 && !between)
        warnOnce(warnedSurface, cut ? sources.field : sources.surface,
                 cut ? "cut into different meshes" : "different meshes");
    LoadedSurface surface = between ? std::move(*between) : *first;
    finishSurface(surface, description.surface.featureAngleDeg);
    if (description.surface.cells == CellValues::smooth) bringCellsToPoints(surface.mesh);
    setOrigin(surface.mesh, originWorld);
    return surface;
}

void LoadedScene::State::showField(const Around& around)
{
    const FieldStep &first = *fields.at(around.first), &second = *fields.at(around.second);
    if (first.cells || second.cells)
        throw InputError(sources.field.name, "its first step is on a uniform grid and others are not",
                         "steps of one kind, or --resample-spacing");
    if (!first.vectors) return;  // The cut carries them.
    const auto same = [](const auto& a, const auto& b) { return (!a && !b) || (a && b && sameGrid(*a, *b)); };
    const bool meet = same(first.vectors, second.vectors) && same(first.scalar, second.scalar);
    if (around.weight > 0 && !meet) warnOnce(warnedField, sources.field, "on different grids");
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

void LoadedScene::State::warnOnce(bool& warned, const Track& track, const char* what)
{
    if (!std::exchange(warned, true))
        scene.warnings.push_back(
            fmt::format("{}: its steps are {}: between two the earlier one is shown", track.name, what));
}

void LoadedScene::readAhead(double moment)
{
    State& s = *state_;
    if (!moves()) return;
    const Moment next = s.sources.around(moment);
    if (s.sources.surface.moves()) s.surfaces.readAhead(next.surface.keys());
    if (!s.sources.field.moves()) return;
    const auto bytes = [](const auto& field) { return field ? field->bytes() : 0; };
    if (hasMemoryToRead(bytes(s.scene.field) + bytes(s.scene.scalarField))) s.fields.readAhead(next.field.keys());
}

}  // namespace aeolic
