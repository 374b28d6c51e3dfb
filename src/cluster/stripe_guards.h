#pragma once

#include <memory>
#include <vector>

#include "base/busy_clock.h"
#include "cluster/communicator.h"
#include "cluster/guard_reach.h"
#include "cluster/network_model.h"
#include "render/guard_exchange.h"

namespace aeolic {

/// Guard rows received from the ranks that own them, of one frame. They go straight from owner to user: where most of
/// a row has flow as whole rows, an image after the other, from where they lie to where they belong; else as one
/// message of the pixels between the first and the last with flow of each row, for no more is read. Everyone knows
/// everyone's stripes, reach and spans, so neither the way nor sizes need be told.
class StripeGuards final : public GuardExchange {
public:
    /// `facts`: of the whole image. `room`: what is packed there is nobody's after a call; kept between frames, for
    /// memory taken anew costs more than copying into it. `busy` runs while receive() is called, and is stopped while
    /// it waits.
    StripeGuards(Communicator& communicator, const Stripes& stripes, std::unique_ptr<GuardReach> reach,
                 std::vector<RowFacts> facts, Bytes& room, BusyClock& busy, const NetworkModel& network = {});

    GuardRows rows(const TraceReach& reach) const override;
    GuardRows sentRows(const TraceReach& reach) const override;
    ColumnSpan flowOf(int row) const override;
    void receive(const std::vector<ImageRows>& images, const TraceReach& reach) override;

private:
    struct RowRange {
        int begin, end;
    };
    /// Rows on their way to a rank or from it.
    struct Transfer {
        int rank;
        RowRange rows;
        std::int64_t packedBytes;     ///< 0: they go in place.
        std::span<std::byte> packed;  ///< In room_.
    };
    /// The rows that `user` needs of `owner`'s stripe: those above its own stripe, and those below.
    std::vector<RowRange> shared(int user, int owner, const TraceReach& reach) const;
    void addTransfers(const std::vector<ImageRows>& images, int user, int owner, const TraceReach& reach,
                      std::vector<Transfer>& transfers) const;
    void takeRoom(std::vector<Transfer>& sent, std::vector<Transfer>& received);
    /// From the first pixel with flow to the last, with all that lies between.
    std::span<std::byte> inPlace(const ImageRows& image, const RowRange& rows) const;
    template <class Part>
    std::vector<Part> partsOf(const std::vector<ImageRows>& images, const std::vector<Transfer>& transfers) const;
    template <class Copy>
    void forEachPackedSpan(const std::vector<ImageRows>& images, const Transfer& transfer, const Copy& copy) const;
    void clear(const std::vector<ImageRows>& images, const RowRange& rows) const;
    NearFlow nearFlow() const;

    Communicator& communicator_;
    Stripes stripes_;
    std::unique_ptr<GuardReach> reach_;
    std::vector<RowFacts> facts_;
    NearFlow near_;  // Of the whole image, as wide as any.
    BusyClock& busy_;
    NetworkModel network_;
    Bytes& room_;
};

}  // namespace aeolic
