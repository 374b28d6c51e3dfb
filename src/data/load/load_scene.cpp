#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "data/load/scene_steps.h"
#include "data/surface_range.h"

namespace aeolic {
namespace {

double longest(const std::vector<glm::vec3>& vectors)
{
    std::vector<float> lengths(vectors.size());
    parallelRanges(vectors.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) lengths[i] = glm::length(vectors[i]);
    });
    const auto range = finiteRange(lengths);
    return range ? (*range)[1] : 0.0;
}

}  // namespace

void measure(Scene& scene)
{
    const SurfaceMesh& mesh = scene.surface;
    scene.maxVector =
        scene.field ? scene.field->maxMagnitude : std::max(longest(mesh.pointVectors), longest(mesh.cellVectors));
    if (!scene.hasScalar) return;
    const auto range = scene.colorByFieldMagnitude ? rangeOnSurface(mesh, *scene.field)
                       : scene.scalarField
                           ? rangeOnSurface(mesh, *scene.scalarField)
                           : finiteRange(mesh.pointScalars.empty() ? mesh.cellScalars : mesh.pointScalars);
    scene.scalarRangeKnown = range.has_value();
    if (range) scene.scalarRange = *range;
}

bool atRest(const Scene& scene)
{
    return scene.maxVector == 0 ||
           (scene.hasScalar && (!scene.scalarRangeKnown || scene.scalarRange[0] == scene.scalarRange[1]));
}

double startOf(const SceneDescription& description, const std::vector<double>& times)
{
    if (description.time.moment) return *description.time.moment;
    if (description.time.range) return (*description.time.range)[0];
    return times.empty() ? 0 : times.front();
}

double momentOfFrame(const std::array<double, 2>& range, int index, int frames)
{
    if (index <= 0 || frames <= 1) return range[0];
    if (index >= frames - 1) return range[1];
    return range[0] + (range[1] - range[0]) * index / (frames - 1);
}

Scene loadPart(const SceneDescription& description, const FieldPart& part, Progress function, void* context)
{
    const ProgressReport progress{function, context};
    SceneSteps steps(description, part);
    Scene scene = steps.first(progress);
    if (!steps.moves()) return scene;
    if (atRest(scene)) {
        steps.prepare(steps.times().back(), progress);
        steps.show(scene);
        measure(scene);
    }
    steps.prepare(startOf(description, steps.times()), progress);
    steps.show(scene);
    return scene;
}

void finishScene(Scene& scene)
{
    if (scene.maxVector == 0) scene.warnings.push_back(scene.surface.name + ": all vectors are zero or masked");
    if (scene.hasScalar && !scene.scalarRangeKnown)
        scene.warnings.push_back(scene.surface.name + ": '" + scene.scalarName +
                                 "' has no finite value on the surface");
    std::vector<std::string> all;
    for (const Tally& tally : scene.tallies)
        for (std::string& warning : warningsOf(tally)) all.push_back(std::move(warning));
    all.insert(all.end(), scene.warnings.begin(), scene.warnings.end());
    scene.tallies.clear();
    std::vector<std::string> distinct;  // An array that serves twice is judged twice.
    for (std::string& warning : all)
        if (std::find(distinct.begin(), distinct.end(), warning) == distinct.end())
            distinct.push_back(std::move(warning));
    scene.warnings = std::move(distinct);
}

Scene loadScene(const SceneDescription& description, Progress function, void* context)
{
    Scene scene = loadPart(description, {}, function, context);
    finishScene(scene);
    return scene;
}

}  // namespace aeolic
