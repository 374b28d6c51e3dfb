#include "data/load/loaded_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "base/append.h"
#include "data/fingerprint.h"
#include "data/load/ask_once.h"
#include "data/load/join_scenes.h"
#include "data/load/loaded_scene_state.h"
#include "description/scene_surfaces.h"

namespace aeolic {
namespace {

std::string boxText(const Bounds& b)
{
    return fmt::format("{:.6g},{:.6g},{:.6g} to {:.6g},{:.6g},{:.6g}", b.lo.x, b.lo.y, b.lo.z, b.hi.x, b.hi.y, b.hi.z);
}

}  // namespace

LoadedScene::State::State(const SceneDescription& d, const Data& m, const Split& s, Agreement& a) : context(d, m, s, a)
{
    for (std::size_t i = 0; i < sources.surfaces.size(); ++i) {
        parts.push_back(std::make_unique<SurfacePart>(context, i));
        visible.push_back(sources.surfaces[i].item.shown);
    }
}

void LoadedScene::State::load(const ProgressReport& progress)
{
    lookUpAll(readSources(progress));
    const bool rests = measureFirst(progress);
    for (const auto& part : parts) part->finish();
    if (parts.size() > 1) joinSurfaces();
    if (rests) scene().restsAt = times.front();
    if (agreement.part().split()) agreement.requireSame("the scene's data", fingerprint(scene()));
    moveTo(startOf(description, times), progress);
    keepFolder();
}

/// Gives surfaces what they carry of the field. `step`: null where there is no field.
void LoadedScene::State::lookUpAll(std::shared_ptr<const FieldStep> step)
{
    if (step)
        for (const auto& part : parts) part->lookUp(step);
    step.reset();
    for (const auto& part : parts) part->unite();
    if (parts.size() > 1) agreement.together([&] { joined = joinedScene(parts, description); });
    requireOverlap();
}

/// Finds ranges, and what is to be warned of, by the first moment at which something flows. Returns whether that is
/// not the first of all.
bool LoadedScene::State::measureFirst(const ProgressReport& progress)
{
    std::vector<std::int64_t> areas;
    for (const auto& part : parts) areas.push_back(part->scene.inPieces ? agreement.sum(part->area()) : part->area());
    for (const auto& part : parts) part->dealToBricks();
    measureAll();
    takeWarnings(areas);
    const auto isAtRest = [](const auto& part) { return atRest(part->scene); };
    const auto flows = [](const auto& part) { return part->source().item.streaks && part->scene.maxVector > 0; };
    bool rests = false;
    if (moves() && std::ranges::all_of(parts, isAtRest)) {
        rests = std::ranges::none_of(parts, flows);
        moveTo(times.back(), progress);
        measureAll();
        rests = rests && std::ranges::any_of(parts, flows);
    }
    return rests;
}

void LoadedScene::State::keepFolder()
{
    const Data& memory = context.reader.memory;
    if (!memory.surface)
        for (SurfaceTrack& surface : sources.surfaces) surface.track.keepFolder(folder);
    if (memory.hasField() || sources.field.series.steps.empty()) return;
    sources.field.keepFolder(folder);
    scene().fieldFile = sources.field.series.steps.front().path;
}

/// Reads the surfaces and the field at their first moment. Returns the field's; null where there is none.
std::shared_ptr<const FieldStep> LoadedScene::State::readSources(const ProgressReport& progress)
{
    const Split& split = context.split;
    std::vector<LoadedSurface> surfaces(parts.size());
    PieceFacts ofAll;
    std::shared_ptr<const FieldStep> step;
    // What both have is the field's, so it is read first; a built-in flow has to know where the surfaces are.
    if (!sources.field.name.empty() && !sources.field.anyMoment) step = readFirstField(progress);
    context.read([&] {
        for (const auto& part : parts)
            if (!part->source().spec.isCut()) surfaces[part->index()] = part->readFirst(progress);
    });
    for (LoadedSurface& surface : surfaces) context.reader.complete(surface, agreement);
    if (split.surface) ofAll = uniteFacts(agreement, factsOf(surfaces.front()));
    agreement.together([&] {
        for (const auto& part : parts) {
            if (part->source().spec.isCut()) continue;
            part->takeFirst(std::move(surfaces[part->index()]), ofAll);
            context.reader.boundsWorld.add(part->scene.boundsWorld);
        }
    });
    if (!sources.field.name.empty() && !step) step = readFirstField(progress);
    agreement.together([&] { takeFirstField(step); });
    return step;
}

std::shared_ptr<const FieldStep> LoadedScene::State::readFirstField(const ProgressReport& progress)
{
    FieldStep step;
    context.read([&] { step = context.reader.field(sources.field.firstKey(), progress); });
    context.reader.complete(step, agreement);
    context.reader.decideColors(step);
    return std::make_shared<const FieldStep>(std::move(step));
}

/// Finds what follows from surfaces and field together. `step`: null where there is no field.
void LoadedScene::State::takeFirstField(const std::shared_ptr<const FieldStep>& step)
{
    if (step) {
        sources.field.takeStepsOf(step->timeSteps);
        if (sources.field.moves()) context.fields.put(sources.field.firstKey(), step);
        for (const auto& part : parts) part->takeFirstField(*step);
        keepTallies(*step);
        appendAll(parts.front()->scene.tallies, fieldTallies);
        field = {step->vectors, step->scalar};
    }
    for (const auto& part : parts)
        if (!part->scene.hasScalar && !colorByOf(part->source().item, description).empty())
            context.reader.failColorBy(part->index(), step ? step->arrays : "");
    context.reader.firstIsRead = true;
    times = sources.times();
    const auto ownFirst = [](const Track& track) { return Around{track.firstKey(), track.firstKey(), 0}; };
    shown = Moment{{}, ownFirst(sources.field)};
    for (const SurfaceTrack& surface : sources.surfaces) shown->surfaces.push_back(ownFirst(surface.track));
}

void LoadedScene::State::keepTallies(const FieldStep& step)
{
    const bool everyRankHasAll = context.split.surface && !context.split.field;
    fieldTallies = !everyRankHasAll || agreement.part().rank == 0 ? step.tallies : std::vector<Tally>{};
}

/// A built-in flow is where the surfaces are; another field may be elsewhere. One surface that it meets is enough.
void LoadedScene::State::requireOverlap()
{
    if (sources.field.name.empty() || sources.field.anyMoment) return;
    Bounds box;
    bool used = false, meetsOne = false;
    for (const auto& part : parts) {
        if (!part->samplesVectors() && !part->isLookedUp()) continue;
        used = true;
        meetsOne = part->meetsField(box) || meetsOne;
    }
    agreement.together([&] {
        if (used && !meetsOne)
            throw InputError(description.field.spec, "the field, from " + boxText(box) + ", does not meet the surface",
                             "a field around the surface, from " + boxText(scene().boundsWorld));
    });
}

void LoadedScene::State::measureAll()
{
    measured.clear();
    for (const auto& part : parts) {
        part->measureScene();
        measured.emplace_back(static_cast<const SceneRanges&>(part->scene));
    }
    if (parts.size() > 1) uniteRanges(measured, joined);
}

/// `areas`: [surfaces] of each as a whole.
void LoadedScene::State::takeWarnings(const std::vector<std::int64_t>& areas)
{
    for (const auto& part : parts) {
        part->warnOfBlanks(areas[part->index()]);
        if (!context.split.any()) continue;
        Scene& own = part->scene;
        own.tallies = sumTallies(agreement, own.tallies);
        own.warnings = agreement.distinct(own.warnings);
    }
}

void LoadedScene::State::joinWarnings()
{
    std::vector<std::string> warnings = joined.warnings;
    for (const auto& part : parts) appendAll(warnings, part->scene.warnings);
    joined.warnings = distinctTexts(warnings);
}

void LoadedScene::State::joinSurfaces()
{
    joinWarnings();
    joinMeshes(parts, visible, joined);
}

LoadedScene::LoadedScene(const SceneDescription& description, const Split& split, Agreement& agreement,
                         const ProgressReport& progress, const Data& memory)
{
    askOncePerHost(agreement, [&] { state_ = std::make_unique<State>(description, memory, split, agreement); });
    state_->load(progress);
    state_->forgetMemory();
}

LoadedScene::~LoadedScene() = default;

const Scene& LoadedScene::scene() const
{
    return state_->scene();
}

SceneChange LoadedScene::moveTo(double moment, const ProgressReport& progress)
{
    return state_->moveTo(moment, progress);
}

const std::vector<double>& LoadedScene::times() const
{
    return state_->times;
}

std::optional<std::array<double, 2>> LoadedScene::span() const
{
    return state_->sources.span();
}

double LoadedScene::shownFor(double moment) const
{
    const auto ends = span();
    return ends ? std::clamp(moment, (*ends)[0], (*ends)[1]) : moment;
}

SceneChange LoadedScene::replace(const Data& memory, double moment, const ProgressReport& progress)
{
    return state_->replace(memory, moment, progress);
}

void LoadedScene::warn(std::string warning)
{
    state_->scene().warnings.push_back(std::move(warning));
}

std::size_t LoadedScene::held() const
{
    std::size_t held = state_->context.fields.held();
    for (const auto& part : state_->parts) held += part->held();
    return held;
}

Scene LoadedScene::take() &&
{
    return std::move(state_->scene());
}

void nameMemory(SceneDescription& description, const Data& memory)
{
    if (memory.surface) description.surface.spec = "surface in memory";
    if (memory.grid) description.field.spec = "grid in memory";
    if (memory.volume) description.field.spec = "volume in memory";
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
