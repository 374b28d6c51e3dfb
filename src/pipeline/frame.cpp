#include "pipeline/frame.h"

#include "pipeline/frame_clock.h"

namespace aeolic {
namespace {

/// A device works after the calls that tell it what to do: their times say nothing, its own do.
void countDevice(const DeviceTimes& device, FrameStats& stats, RankStats& mine)
{
    stats.shadeMs += stats.projectMs + stats.convolveMs - device.projectMs - device.convolveMs;  // The sum stays.
    stats.projectMs = device.projectMs;
    stats.convolveMs = device.convolveMs;
    mine.project.busyMs = device.projectMs;
    mine.convolve.busyMs = device.convolveMs;
    mine.shade.busyMs = device.shadeMs + device.readBackMs;
}

}  // namespace

void renderFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group,
                 FrameTiles& tiles, FrameStats& stats)
{
    FrameClock clock(group.busy(), group.communicator());
    RankStats mine;
    const View view = makeView(request.camera, scene, request.lic);
    const Palette palette = makePalette(request.shading, scene.hasScalar, scene.scalarRange);

    const FrameRows rows = group.partition(view, request.lic, scene, backend);  // Who draws which rows.
    Tile& finished = group.tileFor(rows, tiles);
    clock.lap(stats.balanceMs, mine.balance);
    if (scene.inPieces) {
        const SurfacePixels& piece = backend.projectPiece(view);  // This rank's part of the surface, in anyone's rows.
        clock.lap(stats.projectMs, mine.project);
        group.composite(piece, backend.surfaceRows(view, rows.valid));  // The nearest of all.
        backend.link(view, rows.drawn);
        clock.lap(stats.compositeMs, mine.composite);
    } else if (scene.bricked()) {
        backend.project(view, rows.drawn, rows.valid);
        const FieldPixels& brick = backend.projectBrick(view);  // This rank's part of the field, in anyone's rows.
        clock.lap(stats.projectMs, mine.project);
        group.composite(brick, backend.fieldRows());
        backend.link(view, rows.drawn);
        clock.lap(stats.compositeMs, mine.composite);
    } else {
        backend.project(view, rows.drawn, rows.valid);  // Surface and field to pixels.
        clock.lap(stats.projectMs, mine.project);
    }
    const auto guards = group.guards(backend, rows);           // Rows that traces read and others own.
    backend.convolve(request.lic, rows.stripe, guards.get());  // Noise along streams.
    clock.lap(stats.convolveMs, mine.convolve);
    backend.shade(palette, rows.stripe, finished);  // LIC, light and colour to pixels.
    clock.lap(stats.shadeMs, mine.shade);
    if (const auto device = backend.deviceTimes()) countDevice(*device, stats, mine);
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
    mine.pixels = backend.coveredPixels(rows.stripe.y0, rows.stripe.y1);
    mine.guardPixels =
        backend.coveredPixels(rows.drawn.y0, rows.stripe.y0) + backend.coveredPixels(rows.stripe.y1, rows.drawn.y1);
    mine.busyMs = mine.balance.busyMs + mine.project.busyMs + mine.composite.busyMs + mine.convolve.busyMs +
                  mine.shade.busyMs + mine.gather.busyMs;
    mine.sentBytes = clock.sent().bytes;
    mine.sentMessages = clock.sent().messages;
    clock.stop();
    group.finish(mine, stats);
}

}  // namespace aeolic
