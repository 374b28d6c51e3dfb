#pragma once

#include <memory>
#include <vector>

#include "base/busy_clock.h"
#include "cluster/communicator.h"
#include "cluster/guard_reach.h"
#include "render/guard_exchange.h"

namespace aeolic {

/// Guard rows received from the ranks that own them, of one frame. They go straight from owner to user, as one message
/// of the pixels between the first and the last with flow of each row, for no more is read. Everyone knows everyone's
/// stripes, reach and spans, so neither the way nor sizes need be told.
class StripeGuards final : public GuardExchange {
public:
    /// `facts`: of the whole image. `room`: what is packed there is nobody's after a call; kept between frames, for
    /// memory taken anew costs more than copying into it. `busy` runs while receive() is called, and is stopped while
    /// it waits.
    StripeGuards(Communicator& communicator, const Stripes& stripes, std::unique_ptr<GuardReach> reach,
                 std::vector<RowFacts> facts, Bytes& room, BusyClock& busy);

    GuardRows rows(const TraceReach& reach) const override;
    GuardRows sentRows(const TraceReach& reach) const override;
    ColumnSpan flowOf(int row) const override;
    std::vector<ReachedRows> reached(const std::vector<JumpBoxes>& boxes, const TraceReach& reach, int jumps) override;
    void receive(const std::vector<GuardPart>& parts) override;

private:
    /// A part, and of each rank's stripe the rows that it has, and with those what it needs.
    struct Wanted {
        const GuardPart* part;
        std::vector<Extent> had, needed;  // [ranks]
    };
    Wanted wanted(const GuardPart& part) const;
    /// Each rank's stripe with the guard rows of that reach.
    std::vector<Extent> rowsOfAll(const std::optional<TraceReach>& reach) const;
    /// What `user` needs of `owner`'s stripe: rows above those it has, and rows below.
    std::vector<RowSpan> shared(const std::vector<Extent>& had, const std::vector<Extent>& needed, int user,
                                int owner) const;
    /// Adds those pixels that `user` needs of rows that another rank owns.
    void addReached(const ReachedRows& all, int user, const RowSpan& owned, std::vector<Extent>& pixels) const;
    void addRows(const RowSpan& owned, std::vector<Extent>& pixels) const;

    /// What a message has of a part: those pixels of its images, one image after the other.
    struct Load {
        const std::vector<ImageRows>* images;
        std::vector<Extent> pixels;
    };
    std::vector<Load> loads(const std::vector<Wanted>& parts, int user, int owner) const;
    static std::size_t bytesOf(const std::vector<Load>& loads);
    /// Calls copy(in an image, in the room, bytes) row by row; returns where in the room the next ones go.
    template <class Byte, class Copy>
    static Byte* copyRows(const std::vector<Load>& loads, Byte* room, const Copy& copy);
    void clear(const GuardPart& part, const RowSpan& rows) const;
    NearFlow nearFlow() const;

    Communicator& communicator_;
    Stripes stripes_;
    std::unique_ptr<GuardReach> reach_;
    std::vector<RowFacts> facts_;
    NearFlow near_;  // Of the whole image, as wide as any.
    BusyClock& busy_;
    Bytes& room_;
};

}  // namespace aeolic
