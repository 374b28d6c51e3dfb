#pragma once

#include "aeolic/renderer.h"
#include "stream/requests.h"

namespace aeolic::stream {

/// Local. The payload of Scene for what `renderer` has loaded (docs/protocol.md), without "load".
Json sceneReport(const Renderer& renderer);

}  // namespace aeolic::stream
