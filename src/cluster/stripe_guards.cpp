#include "cluster/stripe_guards.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>

namespace aeolic {

StripeGuards::StripeGuards(Communicator& communicator, const Stripes& stripes, std::unique_ptr<GuardReach> reach,
                           std::vector<RowFacts> facts, Bytes& room, BusyClock& busy)
    : communicator_(communicator),
      stripes_(stripes),
      reach_(std::move(reach)),
      facts_(std::move(facts)),
      near_(nearFlow()),
      busy_(busy),
      room_(room)
{
}

NearFlow StripeGuards::nearFlow() const
{
    std::vector<ColumnSpan> flow;
    flow.reserve(facts_.size());
    for (const RowFacts& row : facts_) flow.push_back({row.x0, row.x1});
    return {{0, 0, std::numeric_limits<std::uint16_t>::max(), stripes_.height()}, flow};
}

ColumnSpan StripeGuards::flowOf(int row) const
{
    return {facts_[std::size_t(row)].x0, facts_[std::size_t(row)].x1};
}

GuardRows StripeGuards::rows(const TraceReach& reach) const
{
    return reach_->rows(stripes_.extent(communicator_.rank(), 1), reach);
}

GuardRows StripeGuards::sentRows(const TraceReach& reach) const
{
    const Extent own = stripes_.extent(communicator_.rank(), 1);
    GuardRows sent;
    const std::vector<Extent> all = needed(reach);
    for (int r = 0; r < communicator_.size(); ++r)
        for (const RowSpan& rows : shared(all, r, communicator_.rank())) {
            const bool userAbove = stripes_.extent(r, 1).y1 <= own.y0;
            (userAbove ? sent.above : sent.below) =
                std::max(userAbove ? sent.above : sent.below, userAbove ? rows.y1 - own.y0 : own.y1 - rows.y0);
        }
    return sent;
}

std::vector<Extent> StripeGuards::needed(const TraceReach& reach) const
{
    std::vector<Extent> needed;
    for (int r = 0; r < communicator_.size(); ++r) {
        const Extent stripe = stripes_.extent(r, 1);
        needed.push_back(stripe.empty() ? stripe : withGuard(stripe, reach_->rows(stripe, reach), stripes_.height()));
    }
    return needed;
}

std::vector<RowSpan> StripeGuards::shared(const std::vector<Extent>& needed, int user, int owner) const
{
    const Extent stripe = stripes_.extent(user, 1), owned = stripes_.extent(owner, 1);
    const Extent& all = needed[std::size_t(user)];
    if (user == owner || stripe.empty() || owned.empty()) return {};
    std::vector<RowSpan> shared;
    for (const RowSpan& side : {RowSpan{all.y0, stripe.y0}, RowSpan{stripe.y1, all.y1}}) {
        const RowSpan rows{std::max(side.y0, owned.y0), std::min(side.y1, owned.y1)};
        if (!rows.empty()) shared.push_back(rows);
    }
    return shared;
}

template <class Visit>
void StripeGuards::forEachPiece(const std::vector<Wanted>& parts, int user, int owner, const Visit& visit) const
{
    for (const Wanted& wanted : parts)
        for (const RowSpan& rows : shared(wanted.needed, user, owner))
            for (const ImageRows& image : wanted.part->images)
                for (int y = rows.y0; y < rows.y1; ++y) {
                    const ColumnSpan flow = flowOf(y);
                    if (!flow.empty()) visit(image, Extent{flow.x0, y, flow.x1, y + 1});
                }
}

std::size_t StripeGuards::bytesOf(const std::vector<Wanted>& parts, int user, int owner) const
{
    std::size_t bytes = 0;
    forEachPiece(parts, user, owner, [&](const ImageRows& image, const Extent& pixels) {
        bytes += std::size_t(pixels.width()) * std::size_t(pixels.height()) * std::size_t(image.pixelBytes);
    });
    return bytes;
}

void StripeGuards::clear(const GuardPart& part, const RowSpan& rows) const
{
    for (const ImageRows& image : part.images)
        for (int y = rows.y0; y < rows.y1; ++y) {
            // Beside what is received; all of it where nothing is.
            const ColumnSpan near{near_.at(y).x0, std::min(near_.at(y).x1, image.valid.x1)}, flow = flowOf(y);
            const auto clearColumns = [&](int x0, int x1) {
                if (x0 < x1) std::memset(image.at(x0, y), 0, std::size_t(x1 - x0) * std::size_t(image.pixelBytes));
            };
            clearColumns(near.x0, flow.empty() ? near.x1 : flow.x0);
            clearColumns(flow.x1, flow.empty() ? flow.x1 : near.x1);
        }
}

void StripeGuards::receive(const std::vector<GuardPart>& images)
{
    const int me = communicator_.rank();
    std::vector<Wanted> parts;
    for (const GuardPart& part : images) parts.push_back({&part, needed(part.reach)});
    std::vector<std::size_t> toRank, fromRank;
    for (int r = 0; r < communicator_.size(); ++r) {
        toRank.push_back(bytesOf(parts, r, me));
        fromRank.push_back(bytesOf(parts, me, r));
    }
    const std::size_t all = std::accumulate(toRank.begin(), toRank.end(), std::size_t{0}) +
                            std::accumulate(fromRank.begin(), fromRank.end(), std::size_t{0});
    if (room_.size() < all) room_.resize(all);
    std::byte* at = room_.data();
    std::vector<OutgoingBytes> outgoing;
    std::vector<IncomingBytes> incoming;
    for (int r = 0; r < communicator_.size(); ++r) {
        const std::byte* const first = at;
        forEachPiece(parts, r, me, [&](const ImageRows& image, const Extent& pixels) {
            const std::size_t bytes = std::size_t(pixels.width()) * std::size_t(image.pixelBytes);
            for (int y = pixels.y0; y < pixels.y1; ++y, at += bytes) std::memcpy(at, image.at(pixels.x0, y), bytes);
        });
        outgoing.push_back({r, {first, toRank[std::size_t(r)]}});
    }
    for (int r = 0; r < communicator_.size(); ++r) {
        incoming.push_back({r, {at, fromRank[std::size_t(r)]}});
        at += fromRank[std::size_t(r)];
    }
    const std::byte* from = incoming.front().bytes.data();
    busy_.stop();
    communicator_.exchangeInPlace(std::move(outgoing), std::move(incoming));
    busy_.start();
    for (int r = 0; r < communicator_.size(); ++r)
        forEachPiece(parts, me, r, [&](const ImageRows& image, const Extent& pixels) {
            const std::size_t bytes = std::size_t(pixels.width()) * std::size_t(image.pixelBytes);
            for (int y = pixels.y0; y < pixels.y1; ++y, from += bytes) std::memcpy(image.at(pixels.x0, y), from, bytes);
        });
    for (int r = 0; r < communicator_.size(); ++r)
        for (const Wanted& wanted : parts)
            for (const RowSpan& rows : shared(wanted.needed, me, r)) clear(*wanted.part, rows);
}

}  // namespace aeolic
