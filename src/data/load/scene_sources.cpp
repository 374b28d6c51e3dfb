#include "data/load/scene_sources.h"

#include <optional>
#include <utility>

#include "data/builtin/flows.h"
#include "data/builtin/surfaces.h"

namespace aeolic {
namespace {

Track fileTrack(const std::string& path)
{
    Track track;
    track.name = path;
    track.series = namesSeries(path) ? readTimeSeries(path) : TimeSeries{{0}, {{path, std::nullopt}}};
    if (namesSeries(path)) track.times = track.series.times;
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

void Track::takeStepsOf(const std::vector<double>& timeSteps)
{
    if (series.steps.size() != 1 || timeSteps.size() < 2) return;
    series = seriesInFile(series.steps.front().path, timeSteps);
    times = series.times;
}

SceneSources::SceneSources(const SceneDescription& description)
    : surfaceSpec(parseSurfaceSpec(description.surface.spec))
{
    if (surfaceSpec.kind == SurfaceSpec::Kind::file) surface = fileTrack(surfaceSpec.text);
    if (surfaceSpec.kind == SurfaceSpec::Kind::builtin)
        surface = builtinTrack(surfaceSpec.text, builtinSurfaceTimes(surfaceSpec.text));
    const std::string& spec = description.field.spec;
    if (!spec.empty()) field = isBuiltinFlow(spec) ? builtinTrack(spec, builtinFlowTimes(spec)) : fileTrack(spec);
}

std::vector<double> SceneSources::times() const
{
    if (!surface.moves() && !field.moves()) return {};
    return mergedTimes(surface.times, field.times);
}

}  // namespace aeolic
