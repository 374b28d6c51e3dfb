#include "cluster/guards/stripe_guards.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "cluster/guards/jump_footprint.h"

namespace aeolic {
namespace {

NearFlow wholeImage(const GuardPlan& needs)
{
    const int height = needs.stripes().height();
    std::vector<ColumnSpan> flow;
    flow.reserve(std::size_t(height));
    for (int y = 0; y < height; ++y) flow.push_back(needs.flowOf(y));
    return {{0, 0, std::numeric_limits<std::uint16_t>::max(), height}, flow};
}

/// The rows that `user` reads of `owner`'s stripe: above its own or below, for ranks own rows in order.
RowSpan rowsRead(const Stripes& stripes, int user, int owner, int rows)
{
    if (user == owner || stripes.rows(user) == 0) return {};
    const Extent mine = stripes.extent(user, 1), theirs = stripes.extent(owner, 1);
    const RowSpan side = owner < user ? RowSpan{mine.y0 - rows, mine.y0} : RowSpan{mine.y1, mine.y1 + rows};
    return {std::max(side.y0, theirs.y0), std::min(side.y1, theirs.y1)};
}

}  // namespace

StripeGuards::StripeGuards(Communicator& communicator, GuardPlan needs, Bytes& room)
    : communicator_(communicator), needs_(std::move(needs)), near_(wholeImage(needs_)), room_(room)
{
}

std::vector<JumpFootprint> StripeGuards::reached(const std::vector<JumpBoxes>& boxes, int steps, int jumps)
{
    if (!needs_.estimates()) return {};
    const Extent limits = needs_.withGuards(communicator_.rank(), steps);
    return shareFootprints(communicator_, needs_.stripes(), boxes, {limits.y0, limits.y1}, jumps);
}

void StripeGuards::clear(const GuardPart& part, const RowSpan& rows) const
{
    for (const ImageRows& image : part.images)
        for (int y = rows.y0; y < rows.y1; ++y) {
            // Beside the columns received; the whole row where none are.
            const ColumnSpan near{near_.at(y).x0, std::min(near_.at(y).x1, image.valid.x1)}, flow = flowOf(y);
            const auto clearColumns = [&](int x0, int x1) {
                if (x0 < x1) std::memset(image.at(x0, y), 0, std::size_t(x1 - x0) * std::size_t(image.pixelBytes));
            };
            clearColumns(near.x0, flow.empty() ? near.x1 : flow.x0);
            clearColumns(flow.x1, flow.empty() ? flow.x1 : near.x1);
        }
}

void StripeGuards::receive(const std::vector<GuardPart>& parts)
{
    const int me = communicator_.rank(), ranks = communicator_.size();
    std::vector<GuardPlan::PartRows> all;
    all.reserve(parts.size());
    for (const GuardPart& part : parts) all.push_back(needs_.rowsOf(part));
    std::vector<std::vector<RowLoad>> toRank, fromRank;
    for (int r = 0; r < ranks; ++r) {
        toRank.push_back(needs_.loads(all, r, me));
        fromRank.push_back(needs_.loads(all, me, r));
    }
    exchangeRows(communicator_, toRank, fromRank, room_);
    for (const GuardPlan::PartRows& part : all)
        for (int r = 0; r < ranks && !part.part->reached; ++r)
            for (const RowSpan& rows : needs_.shared(part, me, r)) clear(*part.part, rows);
}

void StripeNeighbours::receive(const ImageRows& image, int rows)
{
    const int me = communicator_.rank(), ranks = communicator_.size();
    const std::vector<ImageRows> images{image};
    const auto loadOf = [&](int user, int owner) {
        const RowSpan read = rowsRead(stripes_, user, owner, rows);
        std::vector<RowLoad> load;
        if (read.y0 < read.y1) load.push_back({&images, {{image.valid.x0, read.y0, image.valid.x1, read.y1}}});
        return load;
    };
    std::vector<std::vector<RowLoad>> toRank, fromRank;
    for (int r = 0; r < ranks; ++r) {
        toRank.push_back(loadOf(r, me));
        fromRank.push_back(loadOf(me, r));
    }
    Bytes room;
    exchangeRows(communicator_, toRank, fromRank, room);
}

}  // namespace aeolic
