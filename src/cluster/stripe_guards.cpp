#include "cluster/stripe_guards.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace aeolic {
namespace {

int pixelBytesOf(const std::vector<ImageRows>& images)
{
    int bytes = 0;
    for (const ImageRows& image : images) bytes += image.pixelBytes;
    return bytes;
}

}  // namespace

StripeGuards::StripeGuards(Communicator& communicator, const Stripes& stripes, std::unique_ptr<GuardReach> reach,
                           std::vector<RowFacts> facts, BusyClock& busy)
    : communicator_(communicator),
      stripes_(stripes),
      reach_(std::move(reach)),
      facts_(std::move(facts)),
      near_(nearFlow()),
      busy_(busy)
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

std::int64_t StripeGuards::pixelsOf(const std::vector<RowRange>& ranges) const
{
    std::int64_t pixels = 0;
    for (const RowRange& range : ranges)
        for (int y = range.begin; y < range.end; ++y) pixels += facts_[std::size_t(y)].x1 - facts_[std::size_t(y)].x0;
    return pixels;
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
    const int me = communicator_.rank(), pixelBytes = pixelBytesOf(images);
    // Calls copy(image, x, y, bytes) for what goes over in these rows, in the order in which it does.
    const auto forEachSpan = [&](const std::vector<RowRange>& ranges, const auto& copy) {
        for (const ImageRows& image : images)
            for (const RowRange& range : ranges)
                for (int y = range.begin; y < range.end; ++y) {
                    const RowFacts& span = facts_[std::size_t(y)];
                    copy(image.at(span.x0, y), std::size_t(span.x1 - span.x0) * std::size_t(image.pixelBytes));
                }
    };
    std::vector<Message> outgoing;
    std::vector<Announced> incoming;
    for (int r = 0; r < communicator_.size(); ++r) {
        const auto theirs = shared(r, me, reach);
        if (const std::int64_t pixels = pixelsOf(theirs)) {
            Message message{r, Bytes(std::size_t(pixels * pixelBytes))};
            std::byte* to = message.bytes.data();
            forEachSpan(theirs, [&](const std::byte* from, std::size_t bytes) {
                std::memcpy(to, from, bytes);
                to += bytes;
            });
            outgoing.push_back(std::move(message));
        }
        const auto ours = shared(me, r, reach);
        for (const RowRange& range : ours) clear(images, range);
        if (const std::int64_t pixels = pixelsOf(ours)) incoming.push_back({r, pixels * pixelBytes});
    }
    busy_.stop();
    const std::vector<Message> received = communicator_.exchange(std::move(outgoing), incoming);
    busy_.start();
    for (const Message& message : received) {
        const std::byte* from = message.bytes.data();
        forEachSpan(shared(me, message.rank, reach), [&](std::byte* to, std::size_t bytes) {
            std::memcpy(to, from, bytes);
            from += bytes;
        });
    }
}

}  // namespace aeolic
