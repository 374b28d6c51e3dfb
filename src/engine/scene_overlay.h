#pragma once

#include <array>
#include <memory>

#include "data/scene.h"
#include "data/streamlines/even_streamlines.h"
#include "render/surface_overlay.h"

namespace aeolic {

/// Throws InputError where the scene is in pieces, of which none knows the whole. `option`: what asks for it.
void requireWhole(const Scene& scene, const char* option);

/// Throws InputError where the scene cannot have the overlay that the options ask for.
void requireOverlay(const ShadingOptions& shading, const Scene& scene);

/// What the options lay over a scene's surface. Each part is found once, and kept while the data and its options stay.
class SceneOverlay {
public:
    /// Local. Null: none. Cost where it is not known: surfaceTopology(), EvenStreamlines(), SurfaceOutline().
    std::shared_ptr<const SurfaceOverlay> of(const ShadingOptions& shading, const Scene& scene);

    /// The data changed, or the part of them that is shown.
    void forget() { *this = {}; }

private:
    std::shared_ptr<const SurfaceOverlay> topologyOf(double persistence, const Scene& scene);
    std::shared_ptr<const SurfaceOverlay> separationOf(double persistence, const Scene& scene);
    std::shared_ptr<EvenStreamlines> streamlinesOf(const Scene& scene);
    std::shared_ptr<const SurfaceOverlay> lineThrough(const std::array<double, 3>& positionWorld, const Scene& scene);

    std::shared_ptr<const SurfaceOverlay> topology_, separation_, edges_, outline_;
    std::shared_ptr<EvenStreamlines> streamlines_;
    double persistence_ = 0, apart_ = 0;  // topology_'s and separation_'s.
    std::shared_ptr<const SurfaceOverlay> through_;
    std::array<double, 3> throughWorld_{};  // through_'s.
};

}  // namespace aeolic
