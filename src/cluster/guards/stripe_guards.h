#pragma once

#include <memory>
#include <vector>

#include "cluster/comm/communicator.h"
#include "cluster/guards/guard_plan.h"
#include "render/guard_exchange.h"

namespace aeolic {

/// The guard rows of one frame, received from the ranks that own them. They go straight from owner to user, in one
/// message: of each row the pixels from the first to the last with flow, for no more is read.
class StripeGuards final : public GuardExchange {
public:
    /// `room`: exchangeRows()'s, kept between frames.
    StripeGuards(Communicator& communicator, GuardPlan needs, Bytes& room);

    GuardRows rows(int steps) const override { return needs_.rows(communicator_.rank(), steps); }
    GuardRows sentRows(int steps) const override { return needs_.sentRows(communicator_.rank(), steps); }
    ColumnSpan flowOf(int row) const override { return needs_.flowOf(row); }
    std::vector<JumpFootprint> reached(const std::vector<JumpBoxes>& boxes, int steps, int jumps) override;
    void receive(const std::vector<GuardPart>& parts) override;

private:
    void clear(const GuardPart& part, const RowSpan& rows) const;

    Communicator& communicator_;
    GuardPlan needs_;
    NearFlow near_;  // For the whole image, as wide as any.
    Bytes& room_;
};

/// Finished rows from the ranks next to a stripe. Stripes may have fewer rows than are asked for: then rows come from
/// several.
class StripeNeighbours final : public RowExchange {
public:
    StripeNeighbours(Communicator& communicator, const Stripes& stripes)
        : communicator_(communicator), stripes_(stripes)
    {
    }

    void receive(const ImageRows& image, int rows) override;

private:
    Communicator& communicator_;
    const Stripes& stripes_;
};

}  // namespace aeolic
