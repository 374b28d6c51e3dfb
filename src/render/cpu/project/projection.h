#pragma once

#include <vector>

#include "render/cpu/project/brick_triangles.h"
#include "render/cpu/project/scene_arrays.h"
#include "render/cpu/project/visibility.h"
#include "render/gbuffer.h"
#include "render/lic/noise.h"
#include "render/share.h"
#include "render/view.h"

namespace aeolic::cpu {

/// The projection stage (paper, section 3) of one scene: the visible triangles, then the values that later stages need
/// of each visible pixel. Memory is kept between frames.
class Projection {
public:
    /// `scene` must outlive it.
    explicit Projection(const Scene& scene);

    const SceneArrays& arrays() const { return arrays_; }
    Visibility& visibility() { return visibility_; }  ///< Of draw() alone until it has returned; then anyone's.
    /// Local. After a change of the surface.
    void surfaceMoved(const SceneChange& change);

    /// Local. Backend::project() into `out`, of the rows `valid`.
    Share draw(const View& view, const Extent& drawn, const Extent& valid, GBuffer& out);
    /// Local. Backend::complete() of what draw() drew into `out`.
    void complete(const View& view, const Extent& drawn, GBuffer& out) const;

private:
    const Scene& scene() const { return *arrays_.scene; }
    void measurePiece();
    void takeNoise(const View& view);
    void drawWhole(const View& view, const Extent& drawn, const Extent& valid, GBuffer& out);
    /// Every visible pixel of the image whose position lies in this rank's own cells.
    void drawBrick(const View& view);
    /// Every pixel of the image in which this rank's piece of the surface shows.
    void drawPiece(const View& view);
    /// Draws the tiles that mayShow(tile) says yes to. Calls resolve(tile, keys, its extent) where anything is visible,
    /// and clear(tile, its extent) elsewhere.
    template <class MayShow, class Resolve, class Clear>
    void drawTiles(const MayShow& mayShow, const Resolve& resolve, const Clear& clear) const;

    SceneArrays arrays_;
    Visibility visibility_;
    NoisePyramid noise_{1};
    std::vector<char> seen_;  // [tiles]: is anything visible in it?
    BrickTriangles brickTriangles_;
    FieldPixels brick_;
    Image<std::uint32_t> masked_;  // All bricks' masks of this rank's rows.
    Bounds pieceBounds_;           // World, of what this rank holds of a surface in pieces.
    SurfacePixels piece_;
};

}  // namespace aeolic::cpu
