#include "engine/scene_overlay.h"

#include <utility>
#include <vector>

#include "data/topology/point_flow.h"
#include "data/topology/surface_topology.h"
#include "render/overlay/mesh_lines.h"
#include "render/overlay/streamline_strokes.h"
#include "render/overlay/surface_lines.h"
#include "render/overlay/topology_lines.h"

namespace aeolic {

namespace {

/// Several overlays, one over the other.
class OverlayStack final : public SurfaceOverlay {
public:
    explicit OverlayStack(std::vector<std::shared_ptr<const SurfaceOverlay>> parts) : parts_(std::move(parts)) {}

    void draw(const View& view, const SeenSurface& seen, Tile& out) const override
    {
        for (const auto& part : parts_) part->draw(view, seen, out);
    }

private:
    std::vector<std::shared_ptr<const SurfaceOverlay>> parts_;  // From below to above.
};

}  // namespace

std::shared_ptr<const SurfaceOverlay> SceneOverlay::topologyOf(double persistence, WholeScene& whole)
{
    if (topology_ && persistence_ == persistence) return topology_;
    const PointFlow flow = pointFlow(whole.scene(), whole.lookUp());
    const SurfaceTopology topology = surfaceTopology(flow.mesh, flow.vectors, persistence);
    topology_ = std::make_shared<SurfaceLines>(topologyLines(topology, flow.mesh));
    persistence_ = persistence;
    return topology_;
}

std::shared_ptr<const SurfaceOverlay> SceneOverlay::separationOf(double persistence, WholeScene& whole)
{
    if (separation_ && apart_ == persistence) return separation_;
    const auto lines = streamlinesOf(whole);
    separation_ =
        std::make_shared<SurfaceLines>(openLines(lines->surface(), separationLines(lines->surface(), persistence)));
    apart_ = persistence;
    return separation_;
}

std::shared_ptr<EvenStreamlines> SceneOverlay::streamlinesOf(WholeScene& whole)
{
    if (!streamlines_) {
        PointFlow flow = pointFlow(whole.scene(), whole.lookUp());
        streamlines_ = std::make_shared<EvenStreamlines>(std::move(flow.mesh), std::move(flow.vectors));
    }
    return streamlines_;
}

std::shared_ptr<const SurfaceOverlay> SceneOverlay::lineThrough(const std::array<double, 3>& positionWorld,
                                                                WholeScene& whole)
{
    if (through_ && throughWorld_ == positionWorld) return through_;
    const auto lines = streamlinesOf(whole);
    through_ = std::make_shared<SurfaceLines>(
        streamlineThrough(lines->surface(), {positionWorld[0], positionWorld[1], positionWorld[2]}));
    throughWorld_ = positionWorld;
    return through_;
}

std::shared_ptr<const SurfaceOverlay> SceneOverlay::of(const ShadingOptions& shading, WholeScene whole)
{
    const Overlays asked = overlaysOf(shading.overlay);
    std::vector<std::shared_ptr<const SurfaceOverlay>> parts;
    if (asked.edges) {
        if (!edges_) edges_ = std::make_shared<MeshEdges>(whole.scene().surface);
        parts.push_back(edges_);
    }
    if (asked.outline) {
        if (!outline_) outline_ = std::make_shared<SurfaceOutline>(whole.scene().surface);
        parts.push_back(outline_);
    }
    if (asked.streamlinesPx > 0)
        parts.push_back(std::make_shared<StreamlineStrokes>(streamlinesOf(whole), asked.streamlinesPx));
    if (asked.through) parts.push_back(lineThrough(*asked.through, whole));
    if (asked.separation) parts.push_back(separationOf(shading.persistence, whole));
    if (asked.topology) parts.push_back(topologyOf(shading.persistence, whole));
    if (parts.size() > 1) return std::make_shared<OverlayStack>(std::move(parts));
    return parts.empty() ? nullptr : parts.front();
}

}  // namespace aeolic
