#pragma once

#include <optional>

#include "aeolic/pick.h"
#include "cluster/comm/communicator.h"
#include "data/scene.h"
#include "data/surface_range.h"
#include "description/camera.h"

namespace aeolic {

/// A scene with all of its surface, though each rank may hold a piece of it, and of its field a brick. What it gives is
/// the same on all ranks, and what a rank alone would find. Its operations are Collective, unless all of the scene is
/// in this process.
class WholeScene {
public:
    /// Both must outlive this.
    WholeScene(const Scene& scene, Communicator& ranks) : own_(scene), ranks_(ranks) {}

    /// A surface in pieces is gathered on every rank when this is first asked for: about 100 bytes a triangle. The
    /// field stays in bricks.
    const Scene& scene();

    /// Of all the field.
    FieldLookup lookUp();

    /// pickSurface(). Of a surface in pieces no more is gathered than what the ray meets.
    std::optional<PickedPlace> pick(const Camera& camera, int x, int y);

private:
    Scene around(SurfaceMesh surface) const;

    const Scene& own_;
    Communicator& ranks_;
    std::optional<Scene> gathered_;
};

/// Local. Throws InputError where the ranks of this host have no memory for what is asked of the whole surface; `asks`:
/// what asks for it. A scene in one piece is always whole.
void requireRoomForWhole(const Scene& scene, int ranksOnHost, const char* asks);

}  // namespace aeolic
