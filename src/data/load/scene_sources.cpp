#include "data/load/scene_sources.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "data/builtin/flows.h"
#include "data/builtin/surfaces.h"
#include "data/named_file.h"
#include "data/reading/file_questions.h"

namespace aeolic {
namespace {

TimeSeries seriesOfCase(const std::string& path)
{
    const std::vector<double> times = timesOfCase(path);
    return times.empty() ? TimeSeries{{0}, {{path, std::nullopt}}} : seriesInFile(path, times);
}

/// `spec`: a file, and which parts of it.
Track fileTrack(const std::string& spec, const FileAndParts& source)
{
    const std::string& path = source.file;
    Track track;
    track.name = spec;
    const bool isSeries = namesSeries(path), isCase = !isSeries && namedKindHas(path, kNamesFiles);
    track.series = isCase     ? seriesOfCase(path)
                   : isSeries ? readTimeSeries(path)
                              : TimeSeries{{0}, {{path, std::nullopt}}};
    for (StepFile& step : track.series.steps) step.parts = source.parts;
    if (isCase || isSeries) track.times = track.series.times;
    return track;
}

Track builtinTrack(const std::string& spec, std::vector<double> times)
{
    Track track;
    track.name = spec;
    track.times = std::move(times);
    track.anyMoment = true;
    return track;
}

}  // namespace

FileAndParts splitField(const std::string& spec)
{
    if (spec.find(':') == std::string::npos) return {spec, {}};
    FileAndParts split = splitParts(spec);
    const FileKind* kind = namedKind(split.file);
    const bool hasParts = kind && kind->has(kHasParts) && kind->use != FileUse::surface;
    return hasParts ? split : FileAndParts{spec, {}};
}

void Track::takeStepsOf(const std::vector<double>& timeSteps)
{
    if (series.steps.size() != 1 || timeSteps.size() < 2 || !series.steps.front().others.empty()) return;
    const StepFile file = series.steps.front();
    series = seriesInFile(file.path, timeSteps);
    for (StepFile& step : series.steps) step.parts = file.parts;
    times = series.times;
}

void Track::keepFolder(const StartFolder& folder)
{
    for (StepFile& step : series.steps) {
        step.path = folder.absolute(step.path);
        for (std::string& other : step.others) other = folder.absolute(other);
    }
}

SceneSources::SceneSources(const SceneDescription& description)
{
    for (const SurfaceItem& item : surfacesOf(description)) {
        SurfaceTrack surface{item, parseSurfaceSpec(item.spec), {}};
        if (surface.spec.kind == SurfaceSpec::Kind::file) surface.track = fileTrack(item.spec, splitParts(item.spec));
        if (surface.spec.kind == SurfaceSpec::Kind::builtin)
            surface.track = builtinTrack(item.spec, builtinSurfaceTimes(item.spec));
        surfaces.push_back(std::move(surface));
    }
    const std::string& spec = description.field.spec;
    if (!spec.empty())
        field = isBuiltinFlow(spec) ? builtinTrack(spec, builtinFlowTimes(spec)) : fileTrack(spec, splitField(spec));
}

Moment SceneSources::around(double moment) const
{
    Moment found{{}, field.around(moment)};
    for (const SurfaceTrack& surface : surfaces) found.surfaces.push_back(surface.track.around(moment));
    return found;
}

std::optional<std::array<double, 2>> SceneSources::span() const
{
    std::optional<std::array<double, 2>> all;
    bool anyMoment = false;
    const auto add = [&](const Track& track) {
        if (!track.moves()) return;
        anyMoment = anyMoment || track.anyMoment;
        const double first = track.times.front(), last = track.times.back();
        all = all ? std::array{std::min((*all)[0], first), std::max((*all)[1], last)} : std::array{first, last};
    };
    add(field);
    for (const SurfaceTrack& surface : surfaces) add(surface.track);
    return anyMoment ? std::nullopt : all;
}

std::vector<double> SceneSources::times() const
{
    bool moves = field.moves();
    std::vector<double> all = field.times;
    for (const SurfaceTrack& surface : surfaces) {
        moves = moves || surface.track.moves();
        all = mergedTimes(all, surface.track.times);
    }
    return moves ? all : std::vector<double>{};
}

}  // namespace aeolic
