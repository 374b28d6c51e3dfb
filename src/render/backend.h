#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/image.h"
#include "render/field_pixels.h"
#include "render/gbuffer.h"
#include "render/guard_exchange.h"
#include "render/palette.h"
#include "render/tile.h"
#include "render/view.h"

namespace aeolic {

/// The three stages of a frame (paper, section 3) on one kind of machine. One instance draws one scene, a frame at a
/// time; what a stage returns belongs to the backend and holds until that stage runs again.
class Backend {
public:
    virtual ~Backend() = default;

    virtual std::string name() const = 0;    ///< cpu | gl
    virtual std::string device() const = 0;  ///< For people: processor or GPU.
    virtual std::string simd() const = 0;    ///< SIMD target in use, or empty.

    /// The scene it draws was changed in place, no frame being drawn: takes over what `change` says, and keeps the
    /// rest. Throws InputError as makeBackend(). false: it cannot, and has to be made anew.
    virtual bool sceneMoved(const SceneChange& change)
    {
        static_cast<void>(change);
        return false;
    }

    /// How far the LIC stage's traces go with these options.
    virtual TraceReach reach(const LicOptions& lic) const = 0;

    /// Local. How many pixels of each row the surface covers at 1 / factor of the image's resolution, rows counted from
    /// the top, [ceil(height / factor)]: visibility alone, nothing shaded (paper, section 5.3 and figure 5).
    virtual std::vector<std::int64_t> coverage(const View& view, int factor) = 0;

    /// Projection stage. Local. Fills the G-buffer over `drawn`, full width, rows in global pixels; its memory spans
    /// `valid`, which contains `drawn`: the other rows are for others to fill, but for one on each side, which links
    /// need. Links are right where all neighbours are
    /// in `valid` or beyond the image.
    virtual GBuffer& project(const View& view, const Extent& drawn, const Extent& valid) = 0;
    GBuffer& project(const View& view, const Extent& valid) { return project(view, valid, valid); }

    /// Projection stage of a scene whose field is split into bricks, beside project(), which then leaves vectors and
    /// what is coloured from the field to others. Local. Every visible pixel of the image whose position lies in this
    /// rank's own cells.
    virtual const FieldPixels& projectBrick(const View& view) = 0;

    /// Local. Links of `drawn` again, once the flow of its pixels and their neighbours is complete.
    virtual void link(const View& view, const Extent& drawn, GBuffer& buffer) = 0;

    /// LIC stage. Over the rows of `compute`. Without `guards` Local, reading as far as `buffer` is valid. With them
    /// Collective: `buffer` need only be right in `compute`, and whatever traces read beyond is received.
    virtual const Image<float>& convolve(GBuffer& buffer, const LicOptions& lic, const Extent& compute,
                                         GuardExchange* guards = nullptr) = 0;

    /// Blending stage. Local. The finished pixels of `compute`, in place in `out`.
    virtual void shade(const GBuffer& buffer, const Image<float>& lic, const Palette& palette, const Extent& compute,
                       Tile& out) = 0;
};

/// `scene` must outlive the backend. Throws InputError for a name that is not to be had here.
std::unique_ptr<Backend> makeBackend(const std::string& name, const Scene& scene);

}  // namespace aeolic
