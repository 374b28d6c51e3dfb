#include "engine/whole_scene.h"

#include <fmt/format.h>

#include <utility>

#include "aeolic/error.h"
#include "base/memory.h"
#include "cluster/composite/whole_surface.h"
#include "engine/surface_pick.h"

namespace aeolic {
namespace {

/// How many bytes a triangle of the whole surface takes on each rank: while it is gathered, as it is kept, and for what
/// finds lines on it.
constexpr std::uint64_t kWholeBytes = 256;

}  // namespace

Scene WholeScene::around(SurfaceMesh surface) const
{
    Scene scene = own_;
    scene.surface = std::move(surface);
    scene.inPieces = false;
    return scene;
}

const Scene& WholeScene::scene()
{
    if (!own_.inPieces) return own_;
    if (!gathered_) {
        SurfaceMesh all = gatherSurface(ranks_, own_.surface);
        all.order = {};  // It is in order.
        gathered_ = around(std::move(all));
    }
    return *gathered_;
}

FieldLookup WholeScene::lookUp()
{
    return [this](const GridField& field, const std::vector<glm::dvec3>& pointsWorld) {
        return vectorsOfAll(ranks_, field, pointsWorld);
    };
}

std::optional<PickedPlace> WholeScene::pick(const Camera& camera, int x, int y)
{
    if (!own_.inPieces) return pickSurface(own_, camera, x, y, lookUp());
    const std::vector<std::uint32_t> own = trianglesMet(own_, camera, x, y);
    GatheredTriangles gathered = gatherTriangles(ranks_, own_.surface, own);
    gathered.mesh.order = {};  // Triangles are told by their places here.
    const Scene met = around(std::move(gathered.mesh));
    std::optional<PickedPlace> place = pickSurface(met, camera, x, y, lookUp());
    if (!place) return place;
    const int rank = gathered.rank[place->triangle];
    const std::uint32_t ofRank = gathered.ofRank[place->triangle];
    place->triangle = placeInWhole(ranks_, own_.surface, rank, rank == ranks_.rank() ? own[ofRank] : 0);
    return place;
}

void requireRoomForWhole(const Scene& scene, int ranksOnHost, const char* asks)
{
    if (!scene.inPieces) return;
    const std::uint64_t needed = kWholeBytes * scene.allTriangles * std::uint64_t(ranksOnHost),
                        available = availableMemoryBytes();
    if (needed > available)
        throw InputError(
            asks,
            fmt::format("needs all of the surface on each rank, {} MB for the {} of a host", needed >> 20, ranksOnHost),
            fmt::format("at most the {} MB of memory available", available >> 20));
}

}  // namespace aeolic
