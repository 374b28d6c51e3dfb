#include "cluster/stripe_guards.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "cluster/frame_costs.h"

namespace aeolic {

StripeGuards::StripeGuards(Communicator& communicator, const Stripes& stripes, std::unique_ptr<GuardReach> reach,
                           std::vector<RowFacts> facts, Bytes& room, BusyClock& busy, const NetworkModel& network)
    : communicator_(communicator),
      stripes_(stripes),
      reach_(std::move(reach)),
      facts_(std::move(facts)),
      near_(nearFlow()),
      busy_(busy),
      network_(network),
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
    for (int r = 0; r < communicator_.size(); ++r)
        for (const RowRange& range : shared(r, communicator_.rank(), reach)) {
            const bool userAbove = stripes_.extent(r, 1).y1 <= own.y0;
            (userAbove ? sent.above : sent.below) =
                std::max(userAbove ? sent.above : sent.below, userAbove ? range.end - own.y0 : own.y1 - range.begin);
        }
    return sent;
}

std::vector<StripeGuards::RowRange> StripeGuards::shared(int user, int owner, const TraceReach& reach) const
{
    const Extent stripe = stripes_.extent(user, 1), owned = stripes_.extent(owner, 1);
    if (user == owner || stripe.empty() || owned.empty()) return {};
    const Extent needed = withGuard(stripe, reach_->rows(stripe, reach), stripes_.height());
    std::vector<RowRange> ranges;
    for (const RowRange& side : {RowRange{needed.y0, stripe.y0}, RowRange{stripe.y1, needed.y1}}) {
        const RowRange range{std::max(side.begin, owned.y0), std::min(side.end, owned.y1)};
        if (range.begin < range.end) ranges.push_back(range);
    }
    return ranges;
}

void StripeGuards::addTransfers(const std::vector<ImageRows>& images, int user, int owner, const TraceReach& reach,
                                std::vector<Transfer>& transfers) const
{
    for (RowRange rows : shared(user, owner, reach)) {
        while (rows.begin < rows.end && flowOf(rows.begin).empty()) ++rows.begin;
        while (rows.begin < rows.end && flowOf(rows.end - 1).empty()) --rows.end;
        if (rows.begin == rows.end) continue;
        std::int64_t pixels = 0, packed = 0, whole = 0;
        for (int y = rows.begin; y < rows.end; ++y) pixels += flowOf(y).x1 - flowOf(y).x0;
        for (const ImageRows& image : images) {
            packed += pixels * image.pixelBytes;
            whole += std::int64_t(inPlace(image, rows).size());
        }
        const bool areInPlace = cheaperInPlace(whole, int(images.size()), packed, network_);
        transfers.push_back({user == communicator_.rank() ? owner : user, rows, areInPlace ? 0 : packed, {}});
    }
}

std::span<std::byte> StripeGuards::inPlace(const ImageRows& image, const RowRange& rows) const
{
    std::byte* first = image.at(flowOf(rows.begin).x0, rows.begin);
    return {first, image.at(flowOf(rows.end - 1).x1, rows.end - 1)};
}

void StripeGuards::takeRoom(std::vector<Transfer>& sent, std::vector<Transfer>& received)
{
    std::int64_t bytes = 0;
    for (const auto* transfers : {&sent, &received})
        for (const Transfer& transfer : *transfers) bytes += transfer.packedBytes;
    if (room_.size() < std::size_t(bytes)) room_.resize(std::size_t(bytes));
    std::span<std::byte> room(room_);
    for (auto* transfers : {&sent, &received})
        for (Transfer& transfer : *transfers) {
            transfer.packed = room.first(std::size_t(transfer.packedBytes));
            room = room.subspan(transfer.packed.size());
        }
}

template <class Part>
std::vector<Part> StripeGuards::partsOf(const std::vector<ImageRows>& images,
                                        const std::vector<Transfer>& transfers) const
{
    std::vector<Part> parts;
    for (const Transfer& transfer : transfers) {
        if (!transfer.packed.empty())
            parts.push_back({transfer.rank, transfer.packed});
        else
            for (const ImageRows& image : images) parts.push_back({transfer.rank, inPlace(image, transfer.rows)});
    }
    return parts;
}

template <class Copy>
void StripeGuards::forEachPackedSpan(const std::vector<ImageRows>& images, const Transfer& transfer,
                                     const Copy& copy) const
{
    if (transfer.packed.empty()) return;
    for (const ImageRows& image : images)
        for (int y = transfer.rows.begin; y < transfer.rows.end; ++y) {
            const ColumnSpan span = flowOf(y);
            copy(image.at(span.x0, y), std::size_t(span.x1 - span.x0) * std::size_t(image.pixelBytes));
        }
}

void StripeGuards::clear(const std::vector<ImageRows>& images, const RowRange& rows) const
{
    for (const ImageRows& image : images)
        for (int y = rows.begin; y < rows.end; ++y) {
            // Beside what is received; all of it where nothing is.
            const ColumnSpan near{near_.at(y).x0, std::min(near_.at(y).x1, image.valid.x1)};
            const RowFacts& received = facts_[std::size_t(y)];
            const auto clearColumns = [&](int x0, int x1) {
                if (x0 < x1) std::memset(image.at(x0, y), 0, std::size_t(x1 - x0) * std::size_t(image.pixelBytes));
            };
            clearColumns(near.x0, received.x0 < received.x1 ? received.x0 : near.x1);
            clearColumns(received.x1, received.x0 < received.x1 ? near.x1 : received.x1);
        }
}

void StripeGuards::receive(const std::vector<ImageRows>& images, const TraceReach& reach)
{
    std::vector<Transfer> sent, received;
    for (int r = 0; r < communicator_.size(); ++r) {
        addTransfers(images, r, communicator_.rank(), reach, sent);
        addTransfers(images, communicator_.rank(), r, reach, received);
    }
    takeRoom(sent, received);
    for (const Transfer& transfer : sent) {
        std::byte* to = transfer.packed.data();
        forEachPackedSpan(images, transfer, [&](std::byte* from, std::size_t bytes) {
            std::memcpy(to, from, bytes);
            to += bytes;
        });
    }
    busy_.stop();
    communicator_.exchangeInPlace(partsOf<OutgoingBytes>(images, sent), partsOf<IncomingBytes>(images, received));
    busy_.start();
    for (const Transfer& transfer : received) {
        const std::byte* from = transfer.packed.data();
        forEachPackedSpan(images, transfer, [&](std::byte* to, std::size_t bytes) {
            std::memcpy(to, from, bytes);
            from += bytes;
        });
    }
    for (int r = 0; r < communicator_.size(); ++r)
        for (const RowRange& rows : shared(communicator_.rank(), r, reach)) clear(images, rows);
}

}  // namespace aeolic
