#pragma once

#include "aeolic/renderer.h"
#include "stream/requests.h"

namespace aeolic::stream {

/// Local. What `renderer` shows, as a scene: a moment that was set stands in the place of an animation's range.
SceneDescription sceneShown(const Renderer& renderer);

/// Local. The `place` of Picked (docs/protocol.md).
Json placeReport(const PickedPlace& place);

/// Local. The payload of Scene for what `renderer` has loaded (docs/protocol.md), without "load".
Json sceneReport(const Renderer& renderer);

}  // namespace aeolic::stream
