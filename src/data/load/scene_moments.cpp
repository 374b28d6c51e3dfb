#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "base/memory.h"
#include "data/load/interpolate.h"
#include "data/load/scene_steps_state.h"

namespace aeolic {

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
    for (std::string& warning : s.warningsToShow) scene.warnings.push_back(std::move(warning));
    s.warningsToShow.clear();
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
