#pragma once

#include "aeolic/topology.h"
#include "data/scene.h"
#include "data/surface_range.h"

namespace aeolic {

/// The topology that an overlay draws, as numbers: with what the surface has at each place. The scene's surface is
/// whole in this process; `lookUp`: its fields.
FlowTopology flowTopology(const Scene& scene, double persistence, const FieldLookup& lookUp);

/// The open lines that an overlay draws, in the same way.
FlowTopology openLines(const Scene& scene, double persistence, const FieldLookup& lookUp);

}  // namespace aeolic
