#include "engine/frame.h"

#include "engine/frame_stats.h"

namespace aeolic {
Palette paletteOf(const FrameRequest& request, const Scene& scene)
{
    const auto& [camera, lic, shading, colorMap, colorMaps, overlay] = request;
    if (!scene.surfaces.empty()) return makePalette(shading, scene.colors, colorMaps);
    const std::array<double, 2>& range = scene.rangeFor(shading);
    return colorMap ? makePalette(shading, scene.hasScalar, range, *colorMap)
                    : makePalette(shading, scene.hasScalar, range);
}

void startFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group, Frame& frame)
{
    frame.stats = {};
    frame.mine = {};
    FrameClock clock(group.communicator(), frame.stats, frame.mine);
    const View view = makeView(request.camera, scene, request.lic);
    const LicOptions lic = inShortSteps(request.lic, view);
    const Palette palette = paletteOf(request, scene);
    const FrameRows& rows = frame.plan.rows;
    frame.plan.edgeRows = palette.antialias ? limits::kEdgeRows : 0;
    Share share;

    clock.time(stages::balance, [&] {  // Which rank draws which rows.
        group.partition(view, lic, scene, backend, frame.plan);
        frame.tiles.stripe.resize(rows.stripe);
    });
    clock.time(stages::project, [&] {  // Surface and field to pixels.
        share = backend.project(view, rows.drawn, rows.valid);
    });
    clock.time(stages::composite, [&] {  // What other ranks' parts of the scene show in these rows.
        group.composite(frame.plan, share);
        backend.complete(view, rows.drawn);
    });
    clock.time(stages::convolve, [&] {  // Noise along streams; the rows that traces read and others own.
        backend.convolve(lic, rows.stripe, group.guards(backend, frame.plan).get());
        backend.smooth(lic, rows.stripe, group.beside(frame.plan).get(), frame.plan.edgeRows);
        backend.flatten(lic, rows.stripe, group.beside(frame.plan).get(), frame.plan.edgeRows);
    });
    clock.time(stages::shade, [&] {  // LIC, light and colour to pixels.
        backend.occlude(palette, rows.stripe, group.beside(frame.plan).get(), frame.plan.edgeRows);
        backend.shade(palette, rows.stripe, frame.tiles.stripe, group.edges(frame.plan, scene).get());
        frame.over.overlay = request.overlay;
        frame.over.view = view;
        if (request.overlay) backend.see(rows.stripe, frame.over.seen);
    });
}

void finishFrame(Backend& backend, FrameGroup& group, Frame& frame)
{
    FrameClock clock(group.communicator(), frame.stats, frame.mine);
    clock.time(stages::shade, [&] {
        backend.finish();  // The pixels are here.
        if (frame.over.overlay) frame.over.overlay->draw(frame.over.view, frame.over.seen, frame.tiles.stripe);
    });
    clock.time(stages::gather, [&] { group.gather(frame.plan, frame.tiles); });  // Stripes to rank 0.
    completeStats(backend, frame.plan.rows, frame.stats, frame.mine);
    group.finish(frame.plan, frame.mine, frame.stats);
}

void renderFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group, Frame& frame)
{
    startFrame(request, scene, backend, group, frame);
    finishFrame(backend, group, frame);
}

}  // namespace aeolic
