#pragma once

#include <array>
#include <memory>
#include <vector>

#include "aeolic/scene_description.h"
#include "data/load/surface_part.h"
#include "data/scene.h"

namespace aeolic {

using SurfaceParts = std::vector<std::unique_ptr<SurfacePart>>;

/// The scene of several surfaces at its first moment, but for its mesh. Throws InputError for more kinds of colours
/// than SceneColors::kMost.
Scene joinedScene(const SurfaceParts& parts, const SceneDescription& description);

/// The measures of one surface.
struct PartRanges {
    std::array<double, 2> scalar{0, 1}, robust{0, 1};  ///< All values, and Scene::robustRange.
    bool scalarKnown = false;
    double longestVector = 0, longestTangential = 0;
};
PartRanges rangesOf(const Scene& part);

/// Ranges and the longest vector of the surfaces that are shown. Surfaces with the same colours have one range. Where
/// all of those are hidden, they count nevertheless. `ranges`: [surfaces].
void uniteRanges(const std::vector<PartRanges>& ranges, Scene& joined);

/// The mesh of the surfaces that are visible, about the centre of all of them at the first moment.
void joinMeshes(const SurfaceParts& parts, const std::vector<bool>& visible, Scene& joined);

}  // namespace aeolic
