#pragma once

#include <memory>
#include <optional>

#include "aeolic/renderer.h"
#include "cluster/balance/balancer.h"
#include "cluster/balance/speed_history.h"
#include "cluster/comm/communicator.h"
#include "cluster/composite/painted_pixels.h"
#include "cluster/guards/stripe_guards.h"
#include "engine/frame_plan.h"
#include "engine/held_cycle.h"
#include "render/backend.h"

namespace aeolic {

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
    /// Throws InputError for options that name no balancer, guard or guard rows.
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
    std::unique_ptr<Balancer> balancer_;
    bool estimateGuards_;
    std::optional<GuardSource> forcedSource_;
    HeldCycle cycle_;
    Bytes guardRoom_;          // Kept for StripeGuards.
    bool composited_ = false;  // Whether the scene is split.
};

}  // namespace aeolic
