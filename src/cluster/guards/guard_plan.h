#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "cluster/guards/guard_estimate.h"
#include "cluster/guards/row_exchange.h"
#include "render/guard_exchange.h"

namespace aeolic {

/// Which pixels of whose stripe each rank's traces read, in one frame. The same on every rank: everyone knows
/// everyone's stripes, reach and spans, so no rank need tell the others what it sends.
class GuardPlan {
public:
    /// `facts`: one for each row of the whole image.
    GuardPlan(Stripes stripes, std::unique_ptr<GuardEstimate> reach, std::vector<RowFlow> facts);

    const Stripes& stripes() const { return stripes_; }
    /// Whether the reach depends on the flow that is there.
    bool estimates() const { return reach_->estimates(); }
    /// The columns from the first to the last pixel with flow.
    ColumnSpan flowOf(int row) const { return {facts_[std::size_t(row)].x0, facts_[std::size_t(row)].x1}; }

    /// The rows around a rank's stripe that its traces of so many steps read.
    GuardRows rows(int rank, int steps) const { return reach_->rows(stripes_.extent(rank, 1), steps); }
    /// The rows at both ends of a rank's stripe that others' traces read.
    GuardRows sentRows(int rank, int steps) const;
    /// A rank's stripe with its guard rows.
    Extent withGuards(int rank, int steps) const;

    /// Each rank's stripe with the rows of a part that are there already, and with those that its traces read.
    struct PartRows {
        const GuardPart* part;
        std::vector<Extent> had, needed;  ///< [ranks]
    };
    PartRows rowsOf(const GuardPart& part) const { return {&part, rowsOfAll(part.had), rowsOfAll(part.reach)}; }

    /// What `user` needs of `owner`'s stripe: rows above those it has, and rows below.
    std::vector<RowSpan> shared(const PartRows& part, int user, int owner) const;

    /// The message from `owner` to `user`. Cost: that of the rows, and of the columns that are reached.
    std::vector<RowLoad> loads(const std::vector<PartRows>& parts, int user, int owner) const;

private:
    /// Adds those pixels that `user` needs of rows that another rank owns.
    static void addReached(const JumpFootprint& all, int user, const RowSpan& owned, std::vector<Extent>& pixels);
    void addRows(const RowSpan& owned, std::vector<Extent>& pixels) const;
    std::vector<Extent> rowsOfAll(const std::optional<int>& steps) const;

    Stripes stripes_;
    std::unique_ptr<GuardEstimate> reach_;
    std::vector<RowFlow> facts_;
};

}  // namespace aeolic
