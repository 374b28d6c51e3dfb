#include "pipeline/frame.h"

namespace aeolic {
namespace {

std::int64_t countCovered(const GBuffer& buffer, const Extent& rows)
{
    std::int64_t count = 0;
    for (int y = rows.y0; y < rows.y1; ++y) {
        const float* depth = buffer.invDepth.row(y);
        for (int x = rows.x0; x < rows.x1; ++x) count += depth[x] > 0;
    }
    return count;
}

}  // namespace

void renderFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group,
                 FrameTiles& tiles, FrameStats& stats)
{
    const Traffic sentBefore = group.communicator().sent();
    FrameClock clock(group.busy());
    RankStats mine;
    const View view = makeView(request.camera, scene, request.lic);
    const Palette palette = makePalette(request.shading, scene.hasScalar, scene.scalarRange);

    const FrameRows rows = group.partition(view, request.lic, backend);  // Who draws which rows.
    tiles.stripe.resize(rows.stripe);
    clock.lap(stats.balanceMs, mine.balanceBusyMs);
    GBuffer& visible = backend.project(view, rows.drawn, rows.valid);  // Surface and field to pixels.
    if (scene.bricked()) {
        const FieldPixels& brick = backend.projectBrick(view);  // This rank's part of the field, in anyone's rows.
        clock.lap(stats.projectMs, mine.projectBusyMs);
        group.composite(brick, scene.scalarFromField(), visible);
        backend.link(view, rows.drawn, visible);
        clock.lap(stats.compositeMs, mine.compositeBusyMs);
    } else {
        clock.lap(stats.projectMs, mine.projectBusyMs);
    }
    const auto guards = group.guards(visible, rows);  // Rows that traces read and others own.
    const Image<float>& lic =
        backend.convolve(visible, request.lic, rows.stripe, guards.get());  // Noise along streams.
    clock.lap(stats.convolveMs, mine.convolveBusyMs);
    backend.shade(visible, lic, palette, rows.stripe, tiles.stripe);  // LIC, light and colour to pixels.
    clock.lap(stats.shadeMs, mine.shadeBusyMs);
    group.gather(tiles.stripe, tiles.picture);  // Stripes to the picture.
    clock.lap(stats.gatherMs, mine.gatherBusyMs);
    stats.totalMs = clock.totalMs();

    mine.rank = group.rank();
    mine.firstRow = rows.stripe.y0;
    mine.rows = rows.stripe.height();
    const Extent reached =
        guards ? withGuard(rows.stripe, guards->rows(backend.reach(request.lic)), view.camera.height) : rows.valid;
    mine.guardAbove = rows.stripe.y0 - reached.y0;
    mine.guardBelow = reached.y1 - rows.stripe.y1;
    mine.pixels = countCovered(visible, rows.stripe);
    mine.busyMs = clock.busyMs();
    mine.sentBytes = group.communicator().sent().bytes - sentBefore.bytes;
    mine.sentMessages = group.communicator().sent().messages - sentBefore.messages;
    group.finish(mine, stats);
}

}  // namespace aeolic
