#pragma once

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

/// Ranges and the longest vector of the surfaces that are shown. Surfaces with the same colours have one range. Where
/// all of those are hidden, they count nevertheless. `ranges`: [surfaces].
void uniteRanges(const std::vector<SceneRanges>& ranges, Scene& joined);

/// The mesh of the surfaces that are visible, about the centre of all of them at the first moment.
void joinMeshes(const SurfaceParts& parts, const std::vector<bool>& visible, Scene& joined);

}  // namespace aeolic
