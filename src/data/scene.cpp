#include "data/scene.h"

namespace aeolic {

/// A sphere about some of the surfaces has to contain theirs, and need not leave the box around them. It follows from
/// the spheres and boxes of each alone, so it is the same whatever was shown before.
SurfaceReach Scene::fit() const
{
    const SurfaceReach whole{boundsWorld, fitRadius};
    const auto isShown = [](const SceneSurface& s) { return s.shown; };
    if (std::all_of(surfaces.begin(), surfaces.end(), isShown)) return whole;
    SurfaceReach some;
    for (const SceneSurface& s : surfaces)
        if (s.shown) some.boundsWorld.add(s.fit.boundsWorld);
    if (some.boundsWorld.empty()) return whole;
    const glm::dvec3 center = some.boundsWorld.center();
    for (const SceneSurface& s : surfaces)
        if (s.shown)
            some.radius = std::max(some.radius, glm::distance(center, s.fit.boundsWorld.center()) + s.fit.radius);
    some.radius = std::min(some.radius, some.boundsWorld.diagonal() / 2);
    return some;
}

}  // namespace aeolic
