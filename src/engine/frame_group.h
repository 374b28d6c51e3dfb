#pragma once

#include <memory>
#include <optional>

#include "aeolic/renderer.h"
#include "base/busy_clock.h"
#include "cluster/balance/balancer.h"
#include "cluster/balance/frame_costs.h"
#include "cluster/balance/speed_history.h"
#include "cluster/comm/communicator.h"
#include "cluster/composite/painted_pixels.h"
#include "cluster/guards/stripe_guards.h"
#include "render/backend.h"
#include "render/jump_plan.h"

namespace aeolic {

/// The rows one rank has to do with in a frame.
struct FrameRows {
    Extent stripe;  ///< Convolved and shaded here.
    Extent drawn;   ///< Projected for this rank: the stripe, and its guard where that is drawn again.
    Extent linked;  ///< Those and the neighbours that their links need.
    Extent valid;   ///< What traces may read.
};

/// Who draws which rows of a frame, and what is needed of that until it is finished.
struct FramePlan {
    FrameRows rows;  ///< This rank's.
    Stripes stripes;
    int width = 0, guardRows = 0;
    GuardSource source = GuardSource::project;
    double maxStepPx = 0, flowUnitPx = 1;
    TraceReach reach;      ///< Of the method.
    StripeCosts costs;     ///< As the balancer reckoned with.
    RowCoverage coverage;  ///< Empty where it needed none.
};

/// The picture's pixels, and memory kept from frame to frame: in an animation no frame allocates.
struct FrameTiles {
    Tile stripe;                        ///< This rank's.
    PaintedPixels sent;                 ///< The same on its way to rank 0, where the picture is gathered.
    std::vector<PaintedPixels> others;  ///< On rank 0, where it is gathered: what all others sent.
    bool gather = true;                 ///< The same on all ranks.
};

/// What is remembered of the frames finished: what balancing goes by.
struct FrameHistory {
    Stripes stripes;             ///< Of the last …
    std::vector<double> busyMs;  ///< … and what each rank took for its own.
    SpeedHistory speeds;
};

/// The ranks that draw frames together: who draws which rows, who gets which from whom, and what is remembered of the
/// frames before. Every method is Collective unless it says otherwise.
class FrameGroup {
public:
    /// Throws InputError for options that name no balancer, guard or guard rows.
    FrameGroup(std::shared_ptr<Communicator> communicator, const RunOptions& options);

    Communicator& communicator() { return *communicator_; }  ///< Local.
    int rank() const { return communicator_->rank(); }
    int ranks() const { return communicator_->size(); }
    BusyClock& busy() { return busy_; }  ///< Local.

    /// Splits the image's rows by the balancer chosen (paper, section 5.3), and plans this rank's.
    void partition(const View& view, const LicOptions& lic, const Scene& scene, Backend& backend, FramePlan& plan);

    /// Where the field is split into bricks: every rank's pixels of its own brick, to the ranks whose rows they are in.
    void composite(const FramePlan& plan, const FieldPixels& mine, const FieldRows& into);

    /// Where the surface is in pieces: what every rank sees of its own, likewise; the nearest stays.
    void composite(const FramePlan& plan, const SurfacePixels& mine, GBuffer& into);

    /// After the projection: who receives guard rows from others, or null where everything was drawn here.
    std::unique_ptr<GuardExchange> guards(Backend& projected, const FramePlan& plan);

    /// Where the picture is gathered: rank 0 gets what everyone has finished.
    void gather(const FramePlan& plan, FrameTiles& tiles);

    /// Tells everyone how busy all were, which counts as `mine.balance`, and remembers it.
    void finish(const FramePlan& plan, RankStats& mine, FrameStats& stats);

protected:
    /// Local. Balancing the frames started from now on goes by what `ranks`, all of them, took for the frame too.
    void remember(const FramePlan& plan, const std::vector<RankStats>& ranks);

    FrameHistory history_;

private:
    RowCoverage coverage(const View& view, const Scene& scene, Backend& backend);
    std::vector<Extent> linkedRows(const FramePlan& plan) const;  ///< Of every rank.
    /// What a rank took for the rows it was given. Not counting pixels, nor drawing its brick or its piece, which lies
    /// where it lies.
    double stripeMs(const RankStats& rank) const;

    std::shared_ptr<Communicator> communicator_;
    std::unique_ptr<Balancer> balancer_;
    bool estimateGuards_;
    std::optional<GuardSource> forcedSource_;
    BusyClock busy_;
    Bytes guardRoom_;  // Kept for StripeGuards.
    bool composited_ = false;
};

}  // namespace aeolic
