#include "cluster/composite/composite.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "base/parallel.h"
#include "cluster/composite/pixel_messages.h"

namespace aeolic {
namespace {

bool hasScalar(const GBuffer& pixels)
{
    return pixels.scalar.valid() == pixels.flow.valid();
}

/// Calls visit(image) for each image that travels beside depth and order, in this order.
template <class Pixels, class Visit>
void forEachImage(Pixels& pixels, const Visit& visit)
{
    visit(pixels.invDepth);
    visit(pixels.gradX);
    visit(pixels.gradY);
    visit(pixels.light);
    visit(pixels.flow);
    if (hasScalar(pixels)) visit(pixels.scalar);
}

constexpr std::size_t kKeyBytes = 12, kWordsOfSurface = 5;

std::size_t pixelBytes(const GBuffer& pixels)
{
    return kKeyBytes + 4 * (kWordsOfSurface + (hasScalar(pixels) ? 1 : 0));
}

Bytes pixelsFor(const Extent& rows, const SurfacePixels& pixels)
{
    const MessageRows range{std::max(rows.y0, pixels.drawn.y0), std::min(rows.y1, pixels.drawn.y1)};
    Bytes bytes;
    if (rows.empty() || pixels.drawn.empty() || range.y0 >= range.y1) return bytes;
    appendBytes(bytes, &range, 1);
    std::vector<PixelRun> runs;
    bool any = false;
    for (int y = range.y0; y < range.y1; ++y) {
        const std::uint32_t* depth = pixels.depth.row(y);
        findRuns(
            pixels.drawn, [&](int x) { return depth[x] != 0; }, runs);
        any = any || !runs.empty();
        appendRuns(bytes, runs);
        for (const PixelRun& run : runs) {
            const auto count = std::size_t(run.x1 - run.x0);
            appendBytes(bytes, depth + run.x0, count);
            appendBytes(bytes, &pixels.order.at(run.x0, y), count);
            forEachImage(pixels.seen, [&](const auto& image) { appendBytes(bytes, &image.at(run.x0, y), count); });
        }
    }
    return any ? bytes : Bytes();
}

/// A run of pixels in a message.
struct Received {
    PixelRun run;
    const std::byte* pixels;
};

/// Finds the runs of each row of `rows` in the messages. Throws for anything malformed, before anything is written.
std::vector<std::vector<Received>> runsByRow(const std::vector<Message>& messages, const Extent& rows,
                                             std::size_t bytesPerPixel)
{
    std::vector<std::vector<Received>> byRow(std::size_t(std::max(rows.height(), 0)));
    for (const Message& message : messages) {
        PixelReader reader(message.bytes, message.rank);
        const MessageRows range = reader.rows(rows);
        std::vector<PixelRun> runs;
        for (int y = range.y0; y < range.y1; ++y) {
            reader.runs(rows, runs);
            for (const PixelRun& run : runs)
                byRow[std::size_t(y - rows.y0)].push_back(
                    {run, reader.skip(std::size_t(run.x1 - run.x0) * bytesPerPixel)});
        }
        reader.requireEnd();
    }
    return byRow;
}

/// The nearest so far in each pixel of a row.
struct NearestRow {
    std::vector<std::uint32_t> depth;
    std::vector<std::uint64_t> order;
};

/// Several ranks may hold the triangle seen in a pixel. Each gives the pixel what its brick of the field holds there,
/// and at most one of them has something.
void addField(const std::byte* value, std::size_t imageBytes, int x, int y, GBuffer& into)
{
    constexpr std::size_t kFlow = 4, kScalar = 5;  // Places in forEachImage().
    std::uint32_t flow = 0;
    std::memcpy(&flow, value + kFlow * imageBytes, sizeof flow);
    if (flow != 0) into.flow.at(x, y) = flow;
    if (!hasScalar(into)) return;
    float scalar = 0;
    std::memcpy(&scalar, value + kScalar * imageBytes, sizeof scalar);
    if (!std::isnan(scalar)) into.scalar.at(x, y) = scalar;
}

void takeRun(const Received& received, int y, int x0, NearestRow& nearest, GBuffer& into)
{
    const auto count = std::size_t(received.run.x1 - received.run.x0);
    const std::byte *depths = received.pixels, *orders = depths + 4 * count, *values = orders + 8 * count;
    for (std::size_t i = 0; i < count; ++i) {
        const int x = received.run.x0 + int(i);
        std::uint32_t depth = 0;
        std::uint64_t order = 0;
        std::memcpy(&depth, depths + 4 * i, sizeof depth);
        std::memcpy(&order, orders + 8 * i, sizeof order);
        std::uint32_t& bestDepth = nearest.depth[std::size_t(x - x0)];
        std::uint64_t& bestOrder = nearest.order[std::size_t(x - x0)];
        if (depth < bestDepth || (depth == bestDepth && order > bestOrder)) continue;
        const std::byte* value = values + 4 * i;
        if (depth == bestDepth && order == bestOrder) {
            addField(value, 4 * count, x, y, into);
            continue;
        }
        bestDepth = depth;
        bestOrder = order;
        forEachImage(into, [&](auto& image) {
            std::memcpy(&image.at(x, y), value, 4);
            value += 4 * count;
        });
    }
}

}  // namespace

void composite(Communicator& communicator, const PieceShare& share, const std::vector<Extent>& rowsOf)
{
    std::vector<Message> outgoing(rowsOf.size());
    parallelFor(rowsOf.size(), [&](std::size_t r) { outgoing[r] = {int(r), pixelsFor(rowsOf[r], *share.mine)}; });
    const std::vector<Message> incoming = communicator.exchange(std::move(outgoing));
    const Extent& rows = rowsOf[std::size_t(communicator.rank())];
    const auto byRow = runsByRow(incoming, rows, pixelBytes(*share.into));
    parallelRanges(byRow.size(), 16, [&](std::size_t begin, std::size_t end) {
        NearestRow nearest;
        for (std::size_t i = begin; i < end; ++i) {
            nearest.depth.assign(std::size_t(rows.width()), 0);
            nearest.order.assign(std::size_t(rows.width()), 0);
            for (const Received& received : byRow[i])
                takeRun(received, rows.y0 + int(i), rows.x0, nearest, *share.into);
        }
    });
}

}  // namespace aeolic
