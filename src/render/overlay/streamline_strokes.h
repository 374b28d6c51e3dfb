#pragma once

#include <memory>

#include "data/streamlines/even_streamlines.h"
#include "render/overlay/strokes.h"

namespace aeolic {

/// How many pixels a spacing asked for is in a picture: in proportion to its shorter side, so that a smaller picture of
/// the same view has the same lines; but no fewer than can be told apart.
float spacingIn(const Camera& camera, double spacingPx);

/// Evenly spaced streamlines with arrow heads, drawn over a surface. At each place those levels of the lines show that
/// have room in the picture; a level comes and goes by getting thinner, so that nothing pops while the camera moves.
class StreamlineStrokes final : public SurfaceOverlay {
public:
    /// `spacingPx`: about how far apart lines are, in a picture of 800x800 pixels; see spacingIn(). `lines` get more
    /// levels where a view needs them.
    StreamlineStrokes(std::shared_ptr<EvenStreamlines> lines, double spacingPx)
        : lines_(std::move(lines)), spacingPx_(float(spacingPx))
    {
    }

    /// Cost: O(points of all lines), parallel, drawStrokes(), and EvenStreamlines::refineTo() where a view comes nearer
    /// than any before.
    void draw(const View& view, const SeenSurface& seen, Tile& out) const override;

private:
    std::shared_ptr<EvenStreamlines> lines_;
    float spacingPx_;
};

}  // namespace aeolic
