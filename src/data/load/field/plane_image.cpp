#include "data/load/field/plane_image.h"

#include <fmt/format.h>

#include <algorithm>

#include "aeolic/error.h"
#include "data/load/scene_sources.h"
#include "data/vtk/file_reader.h"
#include "description/option_table.h"
#include "description/surface_spec.h"

namespace aeolic {

namespace {

/// The samples of the first step; zeros where the header does not tell.
GridIndex dimsOfFile(const SceneDescription& description)
{
    const SceneSources sources(description);
    if (sources.field.series.steps.empty()) return {0, 0, 0};
    return FileReader(sources.field.series.steps.front().path, FileReader::Use::field).imageDims();
}

}  // namespace

std::optional<PlaneSize> planeSize(const SceneDescription& description, const Data& memory)
{
    if (!description.surfaces.empty() || description.surface.spec != "image" || memory.volume) return std::nullopt;
    const GridIndex dims = memory.grid ? memory.grid->dims : dimsOfFile(description);
    if (dims[0] == 0) return std::nullopt;
    std::vector<std::int64_t> sides;
    for (const std::int64_t side : dims)
        if (side > 1) sides.push_back(side);
    if (sides.size() != 2)
        throw InputError("--surface image",
                         fmt::format("found a field of {} x {} x {} samples", dims[0], dims[1], dims[2]),
                         "one of a single layer, or --surface slice:…");
    const auto most = std::int64_t(options::side.hi);
    if (std::max(sides[0], sides[1]) > most)
        throw InputError("--surface image", fmt::format("found {} x {} samples", sides[0], sides[1]),
                         fmt::format("at most {} each way, or --size", most));
    return PlaneSize{int(sides[0]), int(sides[1])};
}

}  // namespace aeolic
