#include "engine/frame.h"

#include <algorithm>

#include "engine/frame_clock.h"

namespace aeolic {
namespace {

/// A device works after the calls that tell it what to do: their times say nothing, its own do. The sum stays, but
/// where it worked while this thread did something else.
void countDevice(const DeviceTimes& device, FrameStats& stats, RankStats& mine)
{
    const double callsMs = stats.projectMs + stats.convolveMs + stats.shadeMs;
    stats.projectMs = device.projectMs;
    stats.convolveMs = device.convolveMs;
    stats.shadeMs = std::max(callsMs - device.projectMs - device.convolveMs, device.shadeMs + device.readBackMs);
    mine.project.busyMs = device.projectMs;
    mine.convolve.busyMs = device.convolveMs;
    mine.shade.busyMs = device.shadeMs + device.readBackMs;
}

}  // namespace

void startFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group, Frame& frame)
{
    FrameClock clock(group.busy(), group.communicator());
    FrameStats& stats = frame.stats = {};
    RankStats& mine = frame.mine = {};
    const View view = makeView(request.camera, scene, request.lic);
    const LicOptions lic = inShortSteps(request.lic, view);
    const Palette palette = makePalette(request.shading, scene.hasScalar, scene.scalarRange);

    group.partition(view, lic, scene, backend, frame.plan);  // Who draws which rows.
    const FrameRows& rows = frame.plan.rows;
    frame.tiles.stripe.resize(rows.stripe);
    clock.lap(stats.balanceMs, mine.balance);
    if (scene.inPieces) {
        const SurfacePixels& piece = backend.projectPiece(view);  // This rank's part of the surface, in anyone's rows.
        clock.lap(stats.projectMs, mine.project);
        group.composite(frame.plan, piece, backend.surfaceRows(view, rows.valid));  // The nearest of all.
        backend.link(view, rows.drawn);
        clock.lap(stats.compositeMs, mine.composite);
    } else if (scene.bricked()) {
        backend.project(view, rows.drawn, rows.valid);
        const FieldPixels& brick = backend.projectBrick(view);  // This rank's part of the field, in anyone's rows.
        clock.lap(stats.projectMs, mine.project);
        group.composite(frame.plan, brick, backend.fieldRows());
        backend.link(view, rows.drawn);
        clock.lap(stats.compositeMs, mine.composite);
    } else {
        backend.project(view, rows.drawn, rows.valid);  // Surface and field to pixels.
        clock.lap(stats.projectMs, mine.project);
    }
    const auto guards = group.guards(backend, frame.plan);  // Rows that traces read and others own.
    backend.convolve(lic, rows.stripe, guards.get());       // Noise along streams.
    clock.lap(stats.convolveMs, mine.convolve);
    backend.shade(palette, rows.stripe, frame.tiles.stripe);  // LIC, light and colour to pixels.
    clock.lap(stats.shadeMs, mine.shade);

    const Extent reached =
        guards ? withGuard(rows.stripe, guards->rows(frame.plan.reach.steps), view.camera.height) : rows.valid;
    mine.guardAbove = rows.stripe.y0 - reached.y0;
    mine.guardBelow = reached.y1 - rows.stripe.y1;
    clock.addSent(mine);
}

void finishFrame(Backend& backend, FrameGroup& group, Frame& frame)
{
    FrameClock clock(group.busy(), group.communicator());
    FrameStats& stats = frame.stats;
    RankStats& mine = frame.mine;
    const FrameRows& rows = frame.plan.rows;
    backend.finish();  // The pixels are here.
    clock.lap(stats.shadeMs, mine.shade);
    if (const auto device = backend.deviceTimes()) countDevice(*device, stats, mine);
    group.gather(frame.plan, frame.tiles);  // Stripes to rank 0.
    clock.lap(stats.gatherMs, mine.gather);
    stats.totalMs =
        stats.balanceMs + stats.projectMs + stats.compositeMs + stats.convolveMs + stats.shadeMs + stats.gatherMs;

    mine.rank = group.rank();
    mine.firstRow = rows.stripe.y0;
    mine.rows = rows.stripe.height();
    mine.pixels = backend.coveredPixels(rows.stripe.y0, rows.stripe.y1);
    mine.guardPixels =
        backend.coveredPixels(rows.drawn.y0, rows.stripe.y0) + backend.coveredPixels(rows.stripe.y1, rows.drawn.y1);
    mine.busyMs = mine.balance.busyMs + mine.project.busyMs + mine.composite.busyMs + mine.convolve.busyMs +
                  mine.shade.busyMs + mine.gather.busyMs;
    clock.addSent(mine);
    clock.stop();
    group.finish(frame.plan, mine, stats);
}

void renderFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group, Frame& frame)
{
    startFrame(request, scene, backend, group, frame);
    finishFrame(backend, group, frame);
}

}  // namespace aeolic
