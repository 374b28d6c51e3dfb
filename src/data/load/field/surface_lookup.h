#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "data/load/field/wall_sampler.h"
#include "data/load/load_context.h"
#include "data/scene.h"

namespace aeolic {

/// What a field has on one surface's points, where the surface carries it: what is not sampled at every pixel.
/// Whoever calls it for one surface calls it for all, in the same order on every rank.
class SurfaceLookup {
public:
    /// `scene`: the surface's own. `index`: which surface of `context`.
    SurfaceLookup(LoadContext& context, std::size_t index, Scene& scene)
        : context_(context), index_(index), scene_(scene)
    {
    }

    /// Collective. Looks the first moment's step up where the surface has to carry it. `colors`: what the surface is
    /// coloured by is the field's.
    ///
    /// That is so for a field in its own cells, but not on cuts through them; for a grid where an offset or the wall
    /// shear is asked for, or where it is at rest along the surface; and for colours of a surface with vectors of its
    /// own.
    void lookUpFirst(const std::shared_ptr<const FieldStep>& step, bool colors);

    /// Collective. Gives another moment's mesh what the field has there. Returns how many triangles all ranks have.
    std::uint64_t lookUpAt(SurfaceMesh& mesh, const Around& around);

    /// Local. Whether the surface carries what the field has.
    bool isCarried() const { return carried_; }
    /// Local. The box of the field that was looked up, and whether it has a point of the surface of any rank.
    const Bounds& box() const { return box_; }
    bool meets() const { return meets_; }

    /// Local. The surface as it was before, where the field may change and the surface may not; else without triangles.
    const SurfaceMesh& plain() const { return plain_; }
    /// Local. It has another shape from now on.
    void keepPlain(const SurfaceMesh& mesh)
    {
        if (!plain_.triangles.empty()) plain_ = mesh;
    }

    /// Local. [points] Which are in the field, since the last call; or empty.
    std::vector<char> takeWithin() { return std::exchange(within_, {}); }

private:
    const SurfaceTrack& source() const { return context_.sources.surfaces[index_]; }
    const SurfaceAsk& ask() const { return context_.reader.asks[index_]; }
    bool isShear() const { return context_.reader.fieldVectors.shear; }
    WallSampler wall() const { return {agreement_, scene_.inPieces, isShear(), offsetWorld_}; }
    bool isWanted(const FieldStep& step);                               // Collective.
    bool isGridLookedUp(const FieldStep& step);                         // Collective.
    bool isMostlyBlank();                                               // Collective.
    void refine(SurfaceMesh& mesh, const WallSampler::Volume& volume);  // Collective.
    WallValues take(SurfaceMesh& mesh, const WallSampler::Volume& volume, const FieldStep* later,
                    double weight);  // Collective.

    LoadContext& context_;
    const std::size_t index_;
    Scene& scene_;
    Agreement& agreement_ = context_.agreement;
    std::optional<double> offsetWorld_ = context_.description.field.offset;
    double side_ = 1;  // WallLookup::side.
    bool carried_ = false, colors_ = false, meets_ = false;
    Bounds box_;
    std::vector<char> within_;
    SurfaceMesh plain_;
};

}  // namespace aeolic
