#include "data/load/field/plane_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "aeolic/error.h"
#include "data/load/scene_sources.h"
#include "data/vtk/file_reader.h"
#include "description/option_table.h"

namespace aeolic {

namespace {

struct Samples {
    GridIndex dims{0, 0, 0};
    glm::dvec3 spacingWorld{1};
};

/// Those of the first step; none where the header does not tell.
Samples samplesOfFile(const SceneDescription& description)
{
    const SceneSources sources(description);
    if (sources.field.series.steps.empty()) return {};
    const FileReader reader(sources.field.series.steps.front().path, FileReader::Use::field);
    return {reader.imageDims(), reader.imageSpacing()};
}

Samples samplesOf(const Grid& grid)
{
    return {{grid.dims[0], grid.dims[1], grid.dims[2]}, {grid.spacing[0], grid.spacing[1], grid.spacing[2]}};
}

/// One direction of a plane.
struct Side {
    std::int64_t samples = 0;
    double spacingWorld = 1;
};

/// The shape of the samples' cells, with a pixel for each sample where they are closest, or as many as there may be.
PlaneSize sizeOf(const Side& across, const Side& up)
{
    constexpr double kRounding = 1e-6;  // Of a side: what division leaves is no pixel more.
    const double closest = std::min(across.spacingWorld, up.spacingWorld);
    const double width = double(across.samples) * (across.spacingWorld / closest),
                 height = double(up.samples) * (up.spacingWorld / closest);
    if (!(closest > 0) || !std::isfinite(width + height))  // Loading reports the fault.
        return {int(across.samples), int(up.samples)};
    const double fit = std::min(1.0, options::side.hi / std::max(width, height));
    const auto pixels = [&](double length) { return std::max(int(std::ceil(fit * length * (1 - kRounding))), 1); };
    return {pixels(width), pixels(height)};
}

}  // namespace

std::optional<PlaneSize> planeSize(const SceneDescription& description, const Data& memory)
{
    if (!description.surfaces.empty() || description.surface.spec != "image" || memory.volume) return std::nullopt;
    const auto [dims, spacing] = memory.grid ? samplesOf(*memory.grid) : samplesOfFile(description);
    if (dims[0] == 0) return std::nullopt;
    std::vector<Side> sides;
    for (int c = 0; c < 3; ++c)
        if (dims[std::size_t(c)] > 1) sides.push_back({dims[std::size_t(c)], spacing[c]});
    if (sides.size() != 2)
        throw InputError("--surface image",
                         fmt::format("found a field of {} x {} x {} samples", dims[0], dims[1], dims[2]),
                         "one of a single layer, or --surface slice:…");
    const auto most = std::int64_t(options::side.hi);
    if (std::max(sides[0].samples, sides[1].samples) > most)
        throw InputError("--surface image", fmt::format("found {} x {} samples", sides[0].samples, sides[1].samples),
                         fmt::format("at most {} each way, or --size", most));
    return sizeOf(sides[0], sides[1]);
}

}  // namespace aeolic
