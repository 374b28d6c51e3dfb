#pragma once

#include <memory>
#include <string>

#include "base/image.h"
#include "render/gbuffer.h"
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

    /// Projection stage. Local. Fills the G-buffer over `valid`, rows in global pixels, full width; its links only
    /// where all neighbours are in `valid` or beyond the image.
    virtual GBuffer& project(const View& view, const Extent& valid) = 0;

    /// LIC stage. Local. Over the rows of `compute`, reading as far as `buffer` is valid.
    virtual const Image<float>& convolve(const GBuffer& buffer, const LicOptions& lic, const Extent& compute) = 0;

    /// Blending stage. Local. The finished pixels of `compute`, in place in `out`.
    virtual void shade(const GBuffer& buffer, const Image<float>& lic, const Palette& palette, const Extent& compute,
                       Tile& out) = 0;
};

/// `scene` must outlive the backend. Throws InputError for a name that is not to be had here.
std::unique_ptr<Backend> makeBackend(const std::string& name, const Scene& scene);

}  // namespace aeolic
