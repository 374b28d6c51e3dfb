#include "engine/scene_overlay.h"

#include "aeolic/error.h"
#include "data/topology/point_flow.h"
#include "data/topology/surface_topology.h"
#include "render/overlay/topology_lines.h"

namespace aeolic {

void requireWhole(const Scene& scene, const char* option)
{
    if (scene.inPieces || scene.bricked())
        throw InputError(option, "the surface or its field is in pieces",
                         "--bricks off, and room for the whole scene on each rank");
}

void requireOverlay(const ShadingOptions& shading, const Scene& scene)
{
    if (shading.overlay != Overlay::none) requireWhole(scene, "--overlay");
}

std::shared_ptr<const SurfaceOverlay> SceneOverlay::of(const ShadingOptions& shading, const Scene& scene)
{
    if (shading.overlay == Overlay::none) return nullptr;
    if (known_ && persistence_ == shading.persistence) return known_;
    const PointFlow flow = pointFlow(scene);
    const SurfaceTopology topology = surfaceTopology(flow.mesh, flow.vectors, {.persistence = shading.persistence});
    known_ = std::make_shared<SurfaceLines>(topologyLines(topology, flow.mesh));
    persistence_ = shading.persistence;
    return known_;
}

}  // namespace aeolic
