#pragma once

#include <memory>
#include <vector>

#include "base/busy_clock.h"
#include "cluster/communicator.h"
#include "cluster/guard_reach.h"
#include "render/guard_exchange.h"

namespace aeolic {

/// Guard rows received from the ranks that own them, of one frame. Messages go straight from owner to user, one per
/// pair of ranks and call, and hold the pixels between the first and the last with flow of each row: no more is read.
/// Everyone knows everyone's stripes, reach and spans, so sizes need not be told.
class StripeGuards final : public GuardExchange {
public:
    /// `facts`: of the whole image. `busy` runs while receive() is called, and is stopped while it waits.
    StripeGuards(Communicator& communicator, const Stripes& stripes, std::unique_ptr<GuardReach> reach,
                 std::vector<RowFacts> facts, BusyClock& busy);

    GuardRows rows(const TraceReach& reach) const override;
    GuardRows sentRows(const TraceReach& reach) const override;
    ColumnSpan flowOf(int row) const override;
    void receive(const std::vector<ImageRows>& images, const TraceReach& reach) override;

private:
    struct RowRange {
        int begin, end;
    };
    /// The rows that `user` needs of `owner`'s stripe: those above its own stripe, and those below.
    std::vector<RowRange> shared(int user, int owner, const TraceReach& reach) const;
    std::int64_t pixelsOf(const std::vector<RowRange>& ranges) const;
    void clear(const std::vector<ImageRows>& images, const RowRange& rows) const;
    NearFlow nearFlow() const;

    Communicator& communicator_;
    Stripes stripes_;
    std::unique_ptr<GuardReach> reach_;
    std::vector<RowFacts> facts_;
    NearFlow near_;  // Of the whole image, as wide as any.
    BusyClock& busy_;
};

}  // namespace aeolic
