#include "cluster/composite/composite.h"

#include <algorithm>

#include "base/parallel.h"
#include "cluster/composite/pixel_messages.h"

namespace aeolic {
namespace {

void appendRow(const FieldPixels& pixels, int y, const FieldRows& into, std::vector<PixelRun>& runs, Bytes& bytes)
{
    const std::uint32_t* flow = pixels.flow.row(y);
    const float* scalar = into.scalar ? pixels.scalar.row(y) : nullptr;
    const std::uint32_t* masked = into.masked ? pixels.masked.row(y) : nullptr;
    const auto holds = [&](int x) { return flow[x] != 0 || (scalar && scalar[x] == scalar[x]); };
    findRuns(pixels.drawn, holds, runs);
    appendRuns(bytes, runs);
    const auto append = [&](const auto* row) {
        for (const PixelRun& run : runs) appendBytes(bytes, row + run.x0, std::size_t(run.x1 - run.x0));
    };
    append(flow);
    if (scalar) append(scalar);
    if (masked) append(masked);
}

Bytes pixelsFor(const Extent& rows, const FieldPixels& pixels, const FieldRows& into)
{
    const MessageRows range{std::max(rows.y0, pixels.drawn.y0), std::min(rows.y1, pixels.drawn.y1)};
    Bytes bytes;
    if (rows.empty() || pixels.drawn.empty() || range.y0 >= range.y1) return bytes;
    appendBytes(bytes, &range, 1);
    std::vector<PixelRun> runs;
    for (int y = range.y0; y < range.y1; ++y) appendRow(pixels, y, into, runs, bytes);
    return bytes;
}

void takePixels(const Message& message, const Extent& rows, const FieldRows& into)
{
    PixelReader reader(message.bytes, message.rank);
    const MessageRows range = reader.rows(rows);
    std::vector<PixelRun> runs;
    for (int y = range.y0; y < range.y1; ++y) {
        const auto take = [&](auto& image) {
            for (const PixelRun& run : runs) reader.read(&image.at(run.x0, y), std::size_t(run.x1 - run.x0) * 4);
        };
        reader.runs(rows, runs);
        take(*into.flow);
        if (into.scalar) take(*into.scalar);
        if (into.masked) take(*into.masked);
    }
    reader.requireEnd();
}

}  // namespace

void composite(Communicator& communicator, const BrickShare& share, const std::vector<Extent>& rowsOf)
{
    std::vector<Message> outgoing(rowsOf.size());
    parallelFor(rowsOf.size(), [&](std::size_t r) {
        outgoing[r] = {int(r), pixelsFor(rowsOf[r], *share.mine, share.into)};
    });
    const std::vector<Message> incoming = communicator.exchange(std::move(outgoing));
    const Extent& rows = rowsOf[std::size_t(communicator.rank())];
    parallelFor(incoming.size(), [&](std::size_t i) { takePixels(incoming[i], rows, share.into); });
}

}  // namespace aeolic
