#pragma once

#include <memory>
#include <optional>

#include "data/cells/near_surface.h"
#include "data/cells/near_wall.h"
#include "data/load/agreement.h"
#include "data/load/field/field_step.h"

namespace aeolic {

/// Looks a field's step up along one surface. Of a field in its own cells those near the surface are fetched, wherever
/// they were read; of a grid in bricks the values asked for are. All of it is Collective.
class WallSampler {
public:
    /// What of a step can be looked up.
    struct Volume {
        const FieldStep* step;
        std::shared_ptr<const VolumeSampler> sampler;
        std::shared_ptr<const LeftOut> leftOut;  ///< CellVolume::Shell's.
    };

    /// `inPieces`: each rank has other points of the surface. `shear`: WallLookup::shear.
    WallSampler(Agreement& agreement, bool inPieces, bool shear, std::optional<double> offsetWorld)
        : agreement_(agreement), inPieces_(inPieces), shear_(shear), offsetWorld_(offsetWorld)
    {
    }

    /// The cells that touch the surface, and some cells beside it.
    Volume touching(const SurfaceMesh& mesh, const FieldStep& step) const;

    /// All that is looked up on the surface, but for points beside which nothing flows. `touching`: the same surface's.
    Volume aroundWall(const SurfaceMesh& mesh, Volume touching) const;
    Volume aroundWall(const SurfaceMesh& mesh, const FieldStep& step) const
    {
        return aroundWall(mesh, touching(mesh, step));
    }

    /// The values of lookUpNearWall() for all of the mesh. Points without flow in the cells beside them are looked up
    /// again, in cells farther off. The offset and the shear are the sampler's.
    WallValues values(const SurfaceMesh& mesh, const Volume& volume, WallLookup lookup) const;

    /// On which side of the surface the field is, WallLookup::side. All pieces vote.
    double side(const SurfaceMesh& mesh, const Volume& volume) const;

private:
    Volume around(SurfaceZone zone, const FieldStep& step, double diagonals) const;
    double diagonalsAtOnce(const FieldStep& step) const;  // Local.
    template <class Look, class Take>
    void lookAt(const SurfaceMesh& mesh, const Volume& volume, const Look& look, const Take& take) const;
    void lookFarther(const SurfaceMesh& mesh, const Volume& volume, const WallLookup& lookup, WallValues& all) const;

    Agreement& agreement_;
    bool inPieces_, shear_;
    std::optional<double> offsetWorld_;
};

/// So many points of a mesh from `first` on, with their normals alone.
SurfaceMesh pointsOf(const SurfaceMesh& mesh, std::size_t first, std::size_t count);

}  // namespace aeolic
