#include "cluster/guards/stripe_guards.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#include "cluster/guards/jump_footprint.h"

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

NearFlow wholeImage(const GuardPlan& needs)
{
    const int height = needs.stripes().height();
    std::vector<ColumnSpan> flow;
    flow.reserve(std::size_t(height));
    for (int y = 0; y < height; ++y) flow.push_back(needs.flowOf(y));
    return {{0, 0, std::numeric_limits<std::uint16_t>::max(), height}, flow};
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

template <class Byte, class Copy>
Byte* StripeGuards::copyRows(const std::vector<GuardLoad>& loads, Byte* room, const Copy& copy)
{
    for (const GuardLoad& load : loads)
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
    std::vector<std::vector<GuardLoad>> toRank, fromRank;
    std::size_t bytes = 0;
    for (int r = 0; r < ranks; ++r) {
        toRank.push_back(needs_.loads(all, r, me));
        fromRank.push_back(needs_.loads(all, me, r));
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
    communicator_.exchangeInPlace(std::move(outgoing), std::move(incoming));
    for (const std::vector<GuardLoad>& loads : fromRank)
        from = copyRows(loads, from, [](std::byte* inImage, const std::byte* inRoom, std::size_t count) {
            std::memcpy(inImage, inRoom, count);
        });
    for (const GuardPlan::PartRows& part : all)
        for (int r = 0; r < ranks && !part.part->reached; ++r)
            for (const RowSpan& rows : needs_.shared(part, me, r)) clear(*part.part, rows);
}

}  // namespace aeolic
