#pragma once

#include "aeolic/streamlines.h"
#include "aeolic/topology.h"
#include "data/scene.h"
#include "data/surface_range.h"
#include "render/view.h"

/// Points and lines of the flow along a scene's surface as numbers: with what the surface has at each place. The
/// scene's surface is whole in this process; `lookUp`: its fields.
namespace aeolic {

/// The flow's topology, as numbers: that which an overlay draws.
FlowTopology flowTopology(const Scene& scene, double persistence, const FieldLookup& lookUp);

/// The open lines of separation and attachment, as numbers: those which an overlay draws.
FlowTopology openLines(const Scene& scene, double persistence, const FieldLookup& lookUp);

/// Evenly spaced streamlines, about as far apart as `spacingPx` pixels of the view (as StreamlineStrokes counts them)
/// at the depth of the surface's middle, or as close as EvenStreamlines goes. What finer levels add to a line is part
/// of it. Cost: EvenStreamlines.
EvenSurfaceLines surfaceStreamlines(const Scene& scene, const View& view, double spacingPx, const FieldLookup& lookUp);

}  // namespace aeolic
