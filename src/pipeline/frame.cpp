#include "pipeline/frame.h"

#include "pipeline/frame_clock.h"

namespace aeolic {
namespace {

/// Covered pixels of rows [y0, y1).
std::int64_t countCovered(const GBuffer& buffer, int y0, int y1)
{
    std::int64_t count = 0;
    for (int y = y0; y < y1; ++y) {
        const float* depth = buffer.invDepth.row(y);
        for (int x = buffer.valid().x0; x < buffer.valid().x1; ++x) count += depth[x] > 0;
    }
    return count;
}

}  // namespace

void renderFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group,
                 FrameTiles& tiles, FrameStats& stats)
{
    FrameClock clock(group.busy(), group.communicator());
    RankStats mine;
    const View view = makeView(request.camera, scene, request.lic);
    const Palette palette = makePalette(request.shading, scene.hasScalar, scene.scalarRange);

    const FrameRows rows = group.partition(view, request.lic, backend);  // Who draws which rows.
    Tile& finished = group.tileFor(rows, tiles);
    clock.lap(stats.balanceMs, mine.balance);
    GBuffer& visible = backend.project(view, rows.drawn, rows.valid);  // Surface and field to pixels.
    if (scene.bricked()) {
        const FieldPixels& brick = backend.projectBrick(view);  // This rank's part of the field, in anyone's rows.
        clock.lap(stats.projectMs, mine.project);
        group.composite(brick, scene.scalarFromField(), visible);
        backend.link(view, rows.drawn, visible);
        clock.lap(stats.compositeMs, mine.composite);
    } else {
        clock.lap(stats.projectMs, mine.project);
    }
    const auto guards = group.guards(visible, rows);  // Rows that traces read and others own.
    const Image<float>& lic =
        backend.convolve(visible, request.lic, rows.stripe, guards.get());  // Noise along streams.
    clock.lap(stats.convolveMs, mine.convolve);
    backend.shade(visible, lic, palette, rows.stripe, finished);  // LIC, light and colour to pixels.
    clock.lap(stats.shadeMs, mine.shade);
    group.gather(tiles);  // Stripes to the picture.
    clock.lap(stats.gatherMs, mine.gather);
    stats.totalMs = clock.totalMs();

    mine.rank = group.rank();
    mine.firstRow = rows.stripe.y0;
    mine.rows = rows.stripe.height();
    const Extent reached =
        guards ? withGuard(rows.stripe, guards->rows(backend.reach(request.lic)), view.camera.height) : rows.valid;
    mine.guardAbove = rows.stripe.y0 - reached.y0;
    mine.guardBelow = reached.y1 - rows.stripe.y1;
    mine.pixels = countCovered(visible, rows.stripe.y0, rows.stripe.y1);
    mine.guardPixels =
        countCovered(visible, rows.drawn.y0, rows.stripe.y0) + countCovered(visible, rows.stripe.y1, rows.drawn.y1);
    mine.busyMs = clock.busyMs();
    mine.sentBytes = clock.sent().bytes;
    mine.sentMessages = clock.sent().messages;
    clock.stop();
    group.finish(mine, stats);
}

}  // namespace aeolic
