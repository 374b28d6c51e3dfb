#include "cluster/stripe_guards.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <type_traits>

#include "cluster/shared_reach.h"

namespace aeolic {
namespace {

constexpr std::ptrdiff_t kCacheLine = 64;

/// A row of those pixels, before it is copied: no hardware foresees where it begins.
[[gnu::always_inline]] inline void prefetch(const ImageRows& image, const Extent& pixels, int y, bool toWrite)
{
    const std::byte* from = image.at(pixels.x0, y);
    const std::ptrdiff_t bytes = std::ptrdiff_t(pixels.width()) * image.pixelBytes;
    for (std::ptrdiff_t i = 0; i < bytes; i += kCacheLine)
        toWrite ? __builtin_prefetch(from + i, 1) : __builtin_prefetch(from + i);
}

}  // namespace

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
    const std::vector<Extent> owned = rowsOfAll({}), all = rowsOfAll(reach);
    for (int r = 0; r < communicator_.size(); ++r)
        for (const RowSpan& rows : shared(owned, all, r, communicator_.rank())) {
            const bool userAbove = stripes_.extent(r, 1).y1 <= own.y0;
            (userAbove ? sent.above : sent.below) =
                std::max(userAbove ? sent.above : sent.below, userAbove ? rows.y1 - own.y0 : own.y1 - rows.y0);
        }
    return sent;
}

StripeGuards::Wanted StripeGuards::wanted(const GuardPart& part) const
{
    return {&part, rowsOfAll(part.had), rowsOfAll(part.reach)};
}

std::vector<Extent> StripeGuards::rowsOfAll(const std::optional<TraceReach>& reach) const
{
    std::vector<Extent> rows;
    for (int r = 0; r < communicator_.size(); ++r) {
        const Extent stripe = stripes_.extent(r, 1);
        rows.push_back(stripe.empty() || !reach ? stripe
                                                : withGuard(stripe, reach_->rows(stripe, *reach), stripes_.height()));
    }
    return rows;
}

std::vector<RowSpan> StripeGuards::shared(const std::vector<Extent>& had, const std::vector<Extent>& needed, int user,
                                          int owner) const
{
    const Extent &mine = had[std::size_t(user)], &all = needed[std::size_t(user)], owned = stripes_.extent(owner, 1);
    if (user == owner || mine.empty() || owned.empty()) return {};
    std::vector<RowSpan> shared;
    for (const RowSpan& side : {RowSpan{all.y0, mine.y0}, RowSpan{mine.y1, all.y1}}) {
        const RowSpan rows{std::max(side.y0, owned.y0), std::min(side.y1, owned.y1)};
        if (!rows.empty()) shared.push_back(rows);
    }
    return shared;
}

std::vector<ReachedRows> StripeGuards::reached(const std::vector<JumpBoxes>& boxes, const TraceReach& reach, int jumps)
{
    if (!reach_->estimates()) return {};
    const Extent stripe = stripes_.extent(communicator_.rank(), 1),
                 limits = withGuard(stripe, reach_->rows(stripe, reach), stripes_.height());
    return shareReachedRows(communicator_, stripes_, boxes, {limits.y0, limits.y1}, jumps, busy_);
}

void StripeGuards::addReached(const ReachedRows& all, int user, const RowSpan& owned, std::vector<Extent>& pixels) const
{
    const RowSpan* reached = &all.rows[std::size_t(user) * std::size_t(all.columns)];
    RowSpan rows{owned.y1, owned.y0};
    for (int c = 0; c < all.columns; ++c) {
        rows.y0 = std::min(rows.y0, std::max(reached[c].y0, owned.y0));
        rows.y1 = std::max(rows.y1, std::min(reached[c].y1, owned.y1));
    }
    for (int y = rows.y0; y < rows.y1;) {
        // No span begins or ends before the next of these rows: memory is read along rows as far as can be.
        const int end = std::min((y / ReachedRows::kRows + 1) * ReachedRows::kRows, rows.y1);
        const auto has = [&](int c) { return reached[c].y0 <= y && y < reached[c].y1; };
        for (int c = 0; c < all.columns; ++c) {
            if (!has(c)) continue;
            const int first = c;
            while (c + 1 < all.columns && has(c + 1)) ++c;
            pixels.push_back({first * JumpBoxes::kColumns, y, (c + 1) * JumpBoxes::kColumns, end});
        }
        y = end;
    }
}

void StripeGuards::addRows(const RowSpan& owned, std::vector<Extent>& pixels) const
{
    for (int y = owned.y0; y < owned.y1; ++y) {
        const ColumnSpan flow = flowOf(y);
        if (!flow.empty()) pixels.push_back({flow.x0, y, flow.x1, y + 1});
    }
}

std::vector<StripeGuards::Load> StripeGuards::loads(const std::vector<Wanted>& parts, int user, int owner) const
{
    std::vector<Load> loads;
    if (user == owner) return loads;
    for (const Wanted& wanted : parts) {
        Load load{&wanted.part->images, {}};
        for (const RowSpan& rows : shared(wanted.had, wanted.needed, user, owner))
            if (wanted.part->reached)
                addReached(*wanted.part->reached, user, rows, load.pixels);
            else
                addRows(rows, load.pixels);
        const int width = load.images->front().valid.x1;
        for (Extent& pixels : load.pixels) pixels.x1 = std::min(pixels.x1, width);
        if (!load.pixels.empty()) loads.push_back(std::move(load));
    }
    return loads;
}

std::size_t StripeGuards::bytesOf(const std::vector<Load>& loads)
{
    std::size_t bytes = 0;
    for (const Load& load : loads) {
        std::size_t pixels = 0, pixelBytes = 0;
        for (const Extent& some : load.pixels) pixels += std::size_t(some.width()) * std::size_t(some.height());
        for (const ImageRows& image : *load.images) pixelBytes += std::size_t(image.pixelBytes);
        bytes += pixels * pixelBytes;
    }
    return bytes;
}

template <class Byte, class Copy>
Byte* StripeGuards::copyRows(const std::vector<Load>& loads, Byte* room, const Copy& copy)
{
    for (const Load& load : loads)
        for (const ImageRows& image : *load.images)
            for (auto pixels = load.pixels.begin(); pixels != load.pixels.end(); ++pixels) {
                const Extent next = pixels + 1 == load.pixels.end() ? Extent{} : pixels[1];
                const std::size_t bytes = std::size_t(pixels->width()) * std::size_t(image.pixelBytes);
                for (int row = 0; row < pixels->height(); ++row, room += bytes) {
                    if (row < next.height()) prefetch(image, next, next.y0 + row, std::is_const_v<Byte>);
                    copy(image.at(pixels->x0, pixels->y0 + row), room, bytes);
                }
            }
    return room;
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

void StripeGuards::receive(const std::vector<GuardPart>& parts)
{
    const int me = communicator_.rank(), ranks = communicator_.size();
    std::vector<Wanted> all;
    all.reserve(parts.size());
    for (const GuardPart& part : parts) all.push_back(wanted(part));
    std::vector<std::vector<Load>> toRank, fromRank;
    std::size_t bytes = 0;
    for (int r = 0; r < ranks; ++r) {
        toRank.push_back(loads(all, r, me));
        fromRank.push_back(loads(all, me, r));
        bytes += bytesOf(toRank.back()) + bytesOf(fromRank.back());
    }
    if (room_.size() < bytes) room_.resize(bytes);
    std::byte* free = room_.data();
    std::vector<OutgoingBytes> outgoing;
    std::vector<IncomingBytes> incoming;
    for (int r = 0; r < ranks; ++r) {
        const std::byte* const first = free;
        free = copyRows(toRank[std::size_t(r)], free, [](std::byte* inImage, std::byte* inRoom, std::size_t count) {
            std::memcpy(inRoom, inImage, count);
        });
        outgoing.push_back({r, {first, free}});
    }
    const std::byte* from = free;
    for (int r = 0; r < ranks; ++r) {
        incoming.push_back({r, {free, bytesOf(fromRank[std::size_t(r)])}});
        free += incoming.back().bytes.size();
    }
    busy_.stop();
    communicator_.exchangeInPlace(std::move(outgoing), std::move(incoming));
    busy_.start();
    for (const std::vector<Load>& loads : fromRank)
        from = copyRows(loads, from, [](std::byte* inImage, const std::byte* inRoom, std::size_t count) {
            std::memcpy(inImage, inRoom, count);
        });
    for (const Wanted& wanted : all)
        for (int r = 0; r < ranks && !wanted.part->reached; ++r)
            for (const RowSpan& rows : shared(wanted.had, wanted.needed, me, r)) clear(*wanted.part, rows);
}

}  // namespace aeolic
