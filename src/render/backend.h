#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/image.h"
#include "render/coverage_bits.h"
#include "render/edge_exchange.h"
#include "render/gbuffer.h"
#include "render/guard_exchange.h"
#include "render/lic/phase_mix.h"
#include "render/lic/row_flow.h"
#include "render/palette.h"
#include "render/share.h"
#include "render/surface_overlay.h"
#include "render/tile.h"
#include "render/view.h"

namespace aeolic {

/// Which GPU a backend takes.
struct GpuChoice {
    int device = -1;     ///< Index among those that EGL opens, GPUs first; -1: `rankOnHost` modulo how many there are.
    int rankOnHost = 0;  ///< This process's place among those of its host.
};

/// How long a GPU took for the stages of a frame, by its own clock. Milliseconds.
struct DeviceTimes {
    double projectMs = 0, convolveMs = 0, shadeMs = 0;
    double readBackMs = 0;  ///< For the finished pixels to get to this process's memory.
};

/// A device has no more memory, hangs or was reset. Nothing it held can be relied on: the rank ends.
struct DeviceError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What a frame's stages left, for tests, statistics and tools: references into the backend, or copies that hold until
/// the next call. No frame needs them: on a GPU they cost milliseconds. All are Local.
class BackendProbe {
public:
    virtual ~BackendProbe() = default;
    virtual const GBuffer& gbuffer() = 0;   ///< Of the projection.
    virtual const Image<float>& lic() = 0;  ///< Of the LIC stage.
    /// Replaces the LIC stage's result over the extent of `values`, which must be that of its last `compute`.
    virtual void setLic(const Image<float>& values) = 0;
};

/// The three stages of a frame (paper, section 3) on one kind of machine. One instance draws one scene, a frame after
/// the other. Each stage reads what the one before left; the images between them belong to the backend and stay where
/// it computes. Only the finished pixels leave it, and what other ranks need of the rest.
class Backend {
public:
    virtual ~Backend() = default;

    virtual std::string name() const = 0;    ///< cpu | gl
    virtual std::string device() const = 0;  ///< For people: processor or GPU.
    virtual std::string simd() const = 0;    ///< SIMD target in use, or empty.

    /// Backends of the same kind draw the same bytes. Those of different kinds draw pictures that are close, in which
    /// one sees who drew what.
    virtual std::string kind() const = 0;

    /// The scene it draws was changed in place, between shade() and project(): takes over what `change` says, and keeps
    /// the rest. Throws InputError as makeBackend() does: frames that are shaded can still be finished then, but no
    /// others be drawn.
    virtual void sceneMoved(const SceneChange& change) = 0;

    /// Local. How many pixels of each row the surface covers at 1 / factor of the image's resolution, rows counted from
    /// the top, [ceil(height / factor)]: visibility alone, nothing shaded (paper, section 5.3 and figure 5).
    virtual std::vector<std::int64_t> coverage(const View& view, int factor) = 0;

    /// Local. What the `part`-th of `parts` equal parts of the triangles covers at that resolution; null where only all
    /// triangles can be counted. The caller may change it; valid until the next call.
    virtual CoverageBits* coverageOfPart(const View& /*view*/, int /*factor*/, int /*part*/, int /*parts*/)
    {
        return nullptr;
    }

    /// Projection stage. Local. Fills the G-buffer over `drawn`, full width, rows in global pixels; its memory spans
    /// `valid`, which contains `drawn`. The rows beside `drawn` are for other ranks to fill, but for one on each side,
    /// which links need.
    ///
    /// Where the scene is split the G-buffer is not complete yet. What this rank's part shows in anyone's rows is
    /// returned, with the place for what all parts show in this rank's rows. Both hold until the next call.
    virtual Share project(const View& view, const Extent& drawn, const Extent& valid) = 0;
    Share project(const View& view, const Extent& valid) { return project(view, valid, valid); }

    /// Projection stage. Local. The share that project() returned has all ranks' pixels of `drawn` now, and of one row
    /// on each side within `valid`: completes the G-buffer. Does nothing where there was nothing to share. Links are
    /// right then where all neighbours are in `valid` or beyond the image.
    virtual void complete(const View& view, const Extent& drawn) = 0;

    /// Local. What others need to know of the projected flow of these rows.
    virtual std::vector<RowFlow> rowFlow(const Extent& rows) = 0;

    /// LIC stage, over the rows of `compute`. Without `guards` it is Local and reads as far as the projection is valid.
    /// With `guards` it is Collective: the projection need only be right in `compute`, and whatever traces read beyond
    /// is received.
    virtual void convolve(const LicOptions& lic, const Extent& compute, GuardExchange* guards = nullptr) = 0;

    /// LIC stage, after convolve() over the same rows: the second, short convolution (along_flow.h) where `lic` asks
    /// for it. Values are right afterwards in `compute` and in `more` rows on each side, as far as the projection is
    /// valid. Collective with `beside`, which brings other ranks' values; Local without.
    virtual void smooth(const LicOptions& lic, const Extent& compute, RowExchange* beside = nullptr, int more = 0) = 0;

    /// LIC stage, after smooth() over the same rows: the last step of even streaks (flatten.h) where `lic` asks for it.
    /// Values are right before in `compute` and in `more` rows on each side, and stay so. Collective with `beside`,
    /// which brings other ranks' values; Local without.
    virtual void flatten(const LicOptions& lic, const Extent& compute, RowExchange* beside = nullptr, int more = 0) = 0;

    /// Projection stage. Local. In the place of project() between two convolutions of a frame: shows the same in the
    /// same rows, but grains have another value of `view`. complete() follows.
    virtual Share projectGrains(const View& view, const Extent& drawn, const Extent& valid) = 0;

    /// Local. Keeps the LIC stage's values, as flatten() left them, as those of one of the runs that mixPhases() takes.
    virtual void keepPhase(int which) = 0;

    /// Local. The LIC stage's values become a mixture of those that were kept since project(), all over the same rows
    /// (phase_mix.h).
    virtual void mixPhases(const phase_mix::Mixture& mixture) = 0;

    /// Local. In the place of project() and of all up to the LIC stage: the frame shows what the one before showed, but
    /// for the phase and the colours. `drawn`: as it was then.
    virtual void projectAgain(const Extent& drawn) = 0;

    /// Blending stage, where the palette has ambient occlusion (occlusion.h); else it does nothing. Finds the open
    /// share in `compute` and `more` rows on each side, for shade(). Collective with `beside`, which brings other
    /// ranks' depths; Local without.
    virtual void occlude(const Palette& palette, const Extent& compute, RowExchange* beside = nullptr,
                         int more = 0) = 0;

    /// Blending stage. Puts the finished pixels of `compute` in their place in `out`. They are there when finish() has
    /// returned; until then `out` must stay where it is. Where the palette has anti-aliasing the LIC stage's values are
    /// right in limits::kEdgeRows rows more.
    /// Local, but Collective with `pieces`, which brings what other ranks' pieces of the surface show at edges.
    virtual void shade(const Palette& palette, const Extent& compute, Tile& out, EdgeExchange* pieces = nullptr) = 0;

    /// Local. Waits for the pixels of the oldest frame shaded and not finished. Once for every shade().
    virtual void finish() {}

    /// How many frames may be shaded before the first of them is finished. More than one where a device draws by
    /// itself: it goes on with the next frame while the pixels of the one before are on their way.
    virtual int framesInFlight() const { return 1; }

    /// Local. How many pixels of rows [y0, y1) the surface covers in the frame finished last; where no frame is on its
    /// way, in the last projection.
    virtual std::int64_t coveredPixels(int y0, int y1) = 0;

    /// Local. What the frame finished last took; none where the calling threads do the work.
    virtual std::optional<DeviceTimes> deviceTimes() const { return std::nullopt; }

    /// Local. What the projection left of `rows`, which lie in those drawn: from complete() to the next project(). On a
    /// GPU it waits for the device, and costs 28 bytes a pixel to get here.
    virtual void see(const Extent& rows, SeenSurface& out) = 0;

    /// A look inside.
    virtual BackendProbe& probe() = 0;
};

/// `automatic` is gl on a real GPU and otherwise cpu. `scene` must outlive the backend. Throws InputError for a backend
/// that is not to be had here. A surface in pieces is drawn by cpu alone.
std::unique_ptr<Backend> makeBackend(BackendChoice choice, const Scene& scene, const GpuChoice& gpu = {});

}  // namespace aeolic
