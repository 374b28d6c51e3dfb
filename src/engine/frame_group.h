#pragma once

#include <memory>
#include <optional>
#include <string>

#include "aeolic/renderer.h"
#include "base/extent.h"
#include "cluster/balance/balancer.h"
#include "cluster/balance/frame_costs.h"
#include "cluster/balance/speed_history.h"
#include "cluster/comm/communicator.h"
#include "cluster/composite/painted_pixels.h"
#include "cluster/guards/stripe_guards.h"
#include "description/camera.h"
#include "render/backend.h"
#include "render/lic/jump_plan.h"
#include "render/palette.h"

namespace aeolic {

/// The rows one rank has to do with in a frame.
struct FrameRows {
    Extent stripe;  ///< Convolved and shaded here.
    Extent drawn;   ///< Projected here: the stripe, and its guard where that is drawn again.
    Extent valid;   ///< What traces read at most.
    Extent read;    ///< What traces read as far as is known; `valid` until guards() knows better.
};

/// Which rank draws which rows of a frame, and all else that is needed until it is finished.
struct FramePlan {
    FrameRows rows;  ///< This rank's.
    Stripes stripes;
    int width = 0, guardRows = 0;
    int edgeRows = 0;  ///< Rows next to the stripe that shading reads.
    GuardSource source = GuardSource::project;
    double maxStepPx = 0, flowUnitPx = 1;
    TraceReach reach;      ///< The LIC method's.
    StripeCosts costs;     ///< What the balancer reckoned with.
    RowCoverage coverage;  ///< Empty where the balancer needed none.
    bool again = false;    ///< It is that of the frame before, whose sums are used again.
};

/// What of a cycle of phases the backend holds (render/lic/phase_mix.h): for as long as nothing but the phase and the
/// colours change, frames are mixed from it. All ranks hold the same.
class HeldCycle {
public:
    /// Whether a frame with this camera and these options, as the LIC stage gets them, goes on with it.
    bool holds(const Camera& camera, const LicOptions& lic, const Palette& palette) const;

    /// The backend holds this frame from now on.
    void hold(const Camera& camera, const LicOptions& lic, const Palette& palette, const FramePlan& plan);

    /// The backend is used for something else, or the scene changed.
    void forget() { frame_.reset(); }

    /// The plan by which the frame was drawn that the backend holds.
    const FramePlan& plan() const { return frame_->plan; }

private:
    struct Held {
        Camera camera;
        std::string lic;  // All options but the phase, as text.
        bool antialias, occlusion;
        FramePlan plan;
    };
    std::optional<Held> frame_;
};

/// The picture's pixels, and memory kept from frame to frame: in an animation no frame allocates.
struct FrameTiles {
    Tile stripe;                        ///< This rank's.
    bool gather = true;                 ///< Rank 0 gets the whole picture. All ranks say the same.
    PaintedPixels sent;                 ///< Where it is gathered: this rank's stripe on its way to rank 0.
    std::vector<PaintedPixels> others;  ///< Where it is gathered, on rank 0: what all others sent.
};

/// What is remembered of the frames finished. Balancing goes by it.
struct FrameHistory {
    Stripes stripes;             ///< The last frame's.
    std::vector<double> workMs;  ///< [ranks]: how long each rank worked on its stripe of the last frame.
    SpeedHistory speeds;
};

/// The ranks that draw frames together: which rank draws which rows and sends which to whom, and what the ranks
/// remember of the frames before. Every method is Collective unless it says otherwise.
class FrameGroup {
public:
    /// Throws InputError for options that name no guard or guard rows.
    FrameGroup(std::shared_ptr<Communicator> communicator, const RunOptions& options);

    Communicator& communicator() { return *communicator_; }  ///< Local.
    const std::shared_ptr<Communicator>& shared() const { return communicator_; }
    int rank() const { return communicator_->rank(); }
    int ranks() const { return communicator_->size(); }

    /// What the backend that draws for this group holds. Local.
    HeldCycle& cycle() { return cycle_; }

    /// Splits the image's rows by the balancer chosen (paper, section 5.3), and plans this rank's.
    void partition(const View& view, const LicOptions& lic, const Scene& scene, Backend& backend, FramePlan& plan);

    /// Where the scene is split among the ranks: sends what this rank's part shows to the ranks in whose rows it lies,
    /// and puts the pixels that come from them in their place.
    void composite(const FramePlan& plan, const Share& share);

    /// After the projection: what receives guard rows from other ranks, or null where everything was drawn here. Tells
    /// the plan which rows traces read.
    std::unique_ptr<GuardExchange> guards(Backend& projected, FramePlan& plan);

    /// After the convolution: what receives rows beside the stripe from their owners; null for one rank. Local.
    std::unique_ptr<RowExchange> beside(const FramePlan& plan);

    /// Where edges are smoothed and the surface is in pieces: what brings what others' pieces show there. Local.
    std::unique_ptr<EdgeExchange> edges(const FramePlan& plan, const Scene& scene);

    /// Where the picture is gathered: rank 0 gets what everyone has finished.
    void gather(const FramePlan& plan, FrameTiles& tiles);

    /// Tells everyone how busy all were, and remembers it unless the plan was used again. The way to the others counts
    /// as `mine.balance`.
    void finish(const FramePlan& plan, RankStats& mine, FrameStats& stats);

protected:
    /// Local. From now on balancing goes by this frame too. `ranks`: what each took for it.
    void remember(const FramePlan& plan, const std::vector<RankStats>& ranks);

    FrameHistory history_;

private:
    RowCoverage coverage(const View& view, const Scene& scene, Backend& backend);
    /// How long a rank worked on the rows it was given, all its threads together, without waiting for others. It is
    /// wall time: by CPU time, which adds up its threads, a rank with many of them would look no faster than one with
    /// few. Counting pixels is left out, and so is drawing its brick or its piece: they lie where they lie.
    double stripeMs(const RankStats& rank) const;

    std::shared_ptr<Communicator> communicator_;
    Balance balance_;
    bool estimateGuards_;
    std::optional<GuardSource> forcedSource_;
    HeldCycle cycle_;
    Bytes guardRoom_;          // Kept for StripeGuards.
    bool composited_ = false;  // Whether the scene is split.
};

}  // namespace aeolic
