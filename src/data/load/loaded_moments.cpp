#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "data/fingerprint.h"
#include "data/load/join_scenes.h"
#include "data/load/loaded_scene_state.h"
#include "data/load/memory_model.h"
#include "data/load/series/interpolate.h"

namespace aeolic {
namespace {

/// Throws InputError unless all of `memory` was there from the start.
void requireReplaceable(const Data& memory, const Data& first)
{
    const auto require = [](bool given, bool had, const char* what) {
        if (given && !had)
            throw InputError(what, "the renderer was made without one in memory", "what it was made with");
    };
    require(memory.surface.has_value(), first.surface.has_value(), "surface");
    require(memory.grid.has_value(), first.grid.has_value(), "grid");
    require(memory.volume.has_value(), first.volume.has_value(), "volume");
}

}  // namespace

SceneChange LoadedScene::State::moveTo(double moment, const ProgressReport& progress)
{
    if (!moves()) return {};
    const Moment to = sources.around(moment);
    bool loaded = false;
    try {
        context.read([&] { loaded = hold(to, progress); });
    } catch (...) {
        forgetSteps();
        throw;
    }
    complete(to);
    std::vector<SceneChange> changes;
    for (const auto& part : parts) changes.push_back({part->moves(), false, sources.field.moves()});
    SceneChange change;
    if (shown != to) change = show(to, changes);
    // All ranks load the same steps, unless one of them failed to read one before.
    if (agreement.part().split() && agreement.any(loaded))
        agreement.requireSame(fmt::format("the scene's data at time {}", moment), fingerprint(scene()));
    return change;
}

SceneChange LoadedScene::State::replace(const Data& memory, double moment, const ProgressReport& progress)
{
    const Moment at = sources.around(moment);
    const bool halfWay = shown != at;  // Going there failed.
    StepReader& reader = context.reader;
    SurfacePart& first = *parts.front();
    std::vector<SceneChange> changes;
    for (const auto& part : parts) {
        const bool isCut = part->source().spec.isCut();
        changes.push_back(
            {(memory.surface && part == parts.front()) || (memory.hasField() && isCut) || (halfWay && part->moves()),
             false, memory.hasField() || (halfWay && sources.field.moves())});
    }
    const auto forget = [&] {
        forgetMemory();
        if (memory.surface) first.forgetMemory();
        if (memory.hasField()) context.fields.forget();
    };
    SceneChange change;
    try {
        agreement.together([&] {
            requireReplaceable(memory, reader.memory);
            if (memory.surface) reader.memory.surface = memory.surface;
            if (memory.grid) reader.memory.grid = memory.grid;
            if (memory.volume) reader.memory.volume = memory.volume;
            if (memory.surface) first.readMemory(progress);
            if (memory.hasField()) context.fields.put(0, reader.field(0, progress));
            hold(at, progress);
        });
        complete(at);
        change = show(at, changes);
        if (memory.hasField()) keepTallies(*context.fields.step(0));
        warnAnew();
        if (memory.hasField() && std::exchange(context.onlyStep, nullptr)) context.keepStep(context.fields.step(0));
    } catch (...) {
        forget();
        forgetSteps();
        throw;
    }
    forget();
    return change;
}

/// Warns of the data that are shown now, in the place of those before. Ranges stay those of the first.
void LoadedScene::State::warnAnew()
{
    std::vector<std::int64_t> areas;
    for (const auto& part : parts) {
        std::erase_if(joined.warnings, [&](const std::string& warning) {
            return std::find(part->told().begin(), part->told().end(), warning) != part->told().end();
        });
        part->beginWarnings(part == parts.front() ? fieldTallies : std::vector<Tally>{});
        // Triangles that several bricks share would count several times. Of no area nothing is blank.
        const std::int64_t mine = context.dealsToBricks() ? 0 : part->area();
        areas.push_back(part->scene.inPieces ? agreement.sum(mine) : mine);
        part->measureScene();
    }
    takeWarnings(areas);
    for (const auto& part : parts) part->endWarnings();
    if (parts.size() > 1) joinWarnings();
}

/// Where one rank could not read a step, each of the others has read some or none of the steps behind it. They all
/// begin anew, because all ranks complete a step together.
void LoadedScene::State::forgetSteps()
{
    for (const auto& part : parts)
        if (part->moves()) part->forgetMemory();
    if (sources.field.moves()) context.fields.forget();
}

void LoadedScene::State::forgetMemory()
{
    Data& memory = context.reader.memory;
    if (memory.surface) memory.surface = Surface{};
    if (memory.grid) memory.grid = Grid{};
    if (memory.volume) memory.volume = Volume{};
}

/// Brings the moment's steps into memory, and drops others. Whether any was loaded.
bool LoadedScene::State::hold(const Moment& moment, const ProgressReport& progress)
{
    bool loaded = false;
    for (const auto& part : parts) loaded = part->hold(moment.surfaces[part->index()], progress) || loaded;
    return context.fields.hold(moment.field, progress) || loaded;
}

void LoadedScene::State::complete(const Moment& moment)
{
    if (sources.field.moves()) context.completeSteps(moment.field);
    for (const auto& part : parts) part->place(moment.surfaces[part->index()]);
}

bool LoadedScene::State::samplesPixels() const
{
    return std::ranges::any_of(parts, [](const auto& part) { return part->samplesVectors() || part->samplesScalar(); });
}

/// First come all calls that may fail. Then the shown data change.
SceneChange LoadedScene::State::show(const Moment& moment, const std::vector<SceneChange>& changes)
{
    std::vector<SurfacePart::Next> next;
    for (const auto& part : parts) next.push_back(part->prepare(moment, changes[part->index()]));
    shown.reset();
    if (changes.front().field && samplesPixels()) agreement.together([&] { showField(moment.field); });
    shown = moment;
    SceneChange all;
    for (const auto& part : parts) {
        const SceneChange change = part->take(std::move(next[part->index()]), field);
        all.surface = all.surface || change.surface;
        all.triangles = all.triangles || change.triangles;
        all.field = all.field || change.field;
    }
    if (parts.size() > 1 && all.any()) joinSurfaces();
    return all;
}

void LoadedScene::State::showField(const Around& around)
{
    const FieldStep &first = *context.fields.step(around.first), &second = *context.fields.step(around.second);
    if (first.cells || second.cells)
        throw InputError(sources.field.name, "its first step is on a uniform grid and others are not",
                         "steps of one kind, or --resample-spacing");
    const auto same = [](const auto& a, const auto& b) { return (!a && !b) || (a && b && sameGrid(*a, *b)); };
    const bool meet = same(first.vectors, second.vectors) && same(first.scalar, second.scalar);
    if (around.weight > 0 && !meet && !std::exchange(warnedField, true))
        scene().warnings.push_back(earlierIsShown(sources.field.name, "on different grids"));
    if (around.weight == 0 || !meet) {
        field = {first.vectors, first.scalar};
        return;
    }
    vectorsBetween = interpolated(*first.vectors, *second.vectors, around.weight, std::move(vectorsBetween));
    if (first.scalar)
        scalarBetween = interpolated(*first.scalar, *second.scalar, around.weight, std::move(scalarBetween));
    field = {vectorsBetween, first.scalar ? scalarBetween : nullptr};
}

SceneChange LoadedScene::setShown(const std::vector<bool>& shown)
{
    State& s = *state_;
    if (s.parts.size() == 1 || shown == s.visible) return {};
    s.visible = shown;
    s.joinSurfaces();
    uniteRanges(s.measured, s.joined);
    return {true, true, false};
}

void LoadedScene::readAhead(double moment)
{
    State& s = *state_;
    if (!moves()) return;
    const Moment next = s.sources.around(moment);
    for (const auto& part : s.parts) part->readAhead(next.surfaces[part->index()]);
    if (!s.sources.field.moves()) return;
    const auto bytes = [](const auto& field) { return field ? field->bytes() : 0; };
    const Scene& scene = s.scene();
    if (hasMemoryToRead(bytes(scene.field) + bytes(scene.scalarField))) s.context.fields.readAhead(next.field);
}

}  // namespace aeolic
