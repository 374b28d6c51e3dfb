#pragma once

#include "aeolic/topology.h"
#include "data/scene.h"

namespace aeolic {

/// The topology that an overlay draws, as numbers: with what the surface has at each place. The scene is whole.
FlowTopology flowTopology(const Scene& scene, double persistence);

/// The open lines that an overlay draws. The scene is whole.
FlowTopology openLines(const Scene& scene, double persistence);

}  // namespace aeolic
