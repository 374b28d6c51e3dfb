#pragma once

#include <array>
#include <memory>

#include "data/streamlines/even_streamlines.h"
#include "description/overlays.h"
#include "engine/whole_scene.h"
#include "render/surface_overlay.h"

namespace aeolic {

/// What the options lay over a scene's surface. Each part is found once, and kept while the data and its options stay.
class SceneOverlay {
public:
    /// What the options ask for; null where they ask for nothing. Collective where the scene is in pieces, because then
    /// the surface is gathered, else Local. The cost of what is not known yet is that of surfaceTopology(),
    /// EvenStreamlines() and SurfaceOutline().
    std::shared_ptr<const SurfaceOverlay> of(const ShadingOptions& shading, WholeScene whole);

    /// Something has been found.
    bool any() const { return topology_ || separation_ || edges_ || outline_ || streamlines_; }

    /// The data changed, or the part of them that is shown.
    void forget() { *this = {}; }

private:
    std::shared_ptr<const SurfaceOverlay> topologyOf(double persistence, WholeScene& whole);
    std::shared_ptr<const SurfaceOverlay> separationOf(double persistence, WholeScene& whole);
    std::shared_ptr<EvenStreamlines> streamlinesOf(WholeScene& whole);
    std::shared_ptr<const SurfaceOverlay> lineThrough(const std::array<double, 3>& positionWorld, WholeScene& whole);

    std::shared_ptr<const SurfaceOverlay> topology_, separation_, edges_, outline_;
    std::shared_ptr<EvenStreamlines> streamlines_;
    double persistence_ = 0, apart_ = 0;  // topology_'s and separation_'s.
    std::shared_ptr<const SurfaceOverlay> through_;
    std::array<double, 3> throughWorld_{};  // through_'s.
};

}  // namespace aeolic
