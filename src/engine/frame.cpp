#include "engine/frame.h"

#include "engine/frame_stats.h"

namespace aeolic {

Palette paletteOf(const FrameRequest& request, const Scene& scene)
{
    const ShadingOptions& shading = request.shading;
    if (!scene.surfaces.empty()) return makePalette(shading, scene.colors, request.colorMaps);
    const std::array<double, 2>& range = scene.rangeFor(shading);
    return request.colorMap ? makePalette(shading, scene.hasScalar, range, *request.colorMap)
                            : makePalette(shading, scene.hasScalar, range);
}

namespace {

/// The LIC stage: noise along streams, from the rows that traces read and others own.
void convolveFrame(const LicOptions& lic, Backend& backend, FrameGroup& group, FramePlan& plan)
{
    const Extent& stripe = plan.rows.stripe;
    backend.convolve(lic, stripe, group.guards(backend, plan).get());
    backend.smooth(lic, stripe, group.beside(plan).get(), plan.edgeRows);
    backend.flatten(lic, stripe, group.beside(plan).get(), plan.edgeRows);
}

/// The LIC stage of a frame that belongs to a cycle: its values are mixed from three phases. These are convolved where
/// the backend does not hold them from the frame before.
void convolveInCycle(const LicOptions& lic, Backend& backend, FrameGroup& group, FramePlan& plan)
{
    for (int i = 0; !plan.again && i < phase_mix::kPhases; ++i) {
        LicOptions ofPhase = lic;
        ofPhase.phase = phase_mix::phaseOf(i);
        convolveFrame(ofPhase, backend, group, plan);
        backend.keepPhase(i);
    }
    backend.mixPhases(phase_mix::weights(lic.phase));
}

}  // namespace

void startFrame(const FrameRequest& request, const Scene& scene, Backend& backend, FrameGroup& group, Frame& frame)
{
    frame.stats = {};
    frame.mine = {};
    FrameClock clock(group.communicator(), frame.stats, frame.mine);
    const View view = makeView(request.camera, scene, request.lic);
    const LicOptions lic = inShortSteps(request.lic, view);
    const Palette palette = paletteOf(request, scene);
    const bool again = request.inCycle && group.cycle().holds(request.camera, lic, palette);
    if (again) frame.plan = group.cycle().plan();
    frame.plan.again = again;
    const FrameRows& rows = frame.plan.rows;
    frame.plan.edgeRows = palette.antialias ? limits::kEdgeRows : 0;
    Share share;

    clock.time(stages::balance, [&] {  // Which rank draws which rows.
        if (!again) group.partition(view, lic, scene, backend, frame.plan);
        frame.tiles.stripe.resize(rows.stripe);
    });
    clock.time(stages::project, [&] {  // Surface and field to pixels.
        if (again) return backend.projectAgain(rows.drawn);
        group.cycle().forget();
        share = backend.project(view, rows.drawn, rows.valid);
    });
    clock.time(stages::composite, [&] {  // What other ranks' parts of the scene show in these rows.
        if (again) return;
        group.composite(frame.plan, share);
        backend.complete(view, rows.drawn);
    });
    clock.time(stages::convolve, [&] {  // Noise along streams.
        if (!request.inCycle) return convolveFrame(lic, backend, group, frame.plan);
        convolveInCycle(lic, backend, group, frame.plan);
    });
    clock.time(stages::shade, [&] {  // LIC, light and colour to pixels.
        if (!again) backend.occlude(palette, rows.stripe, group.beside(frame.plan).get(), frame.plan.edgeRows);
        if (request.inCycle) group.cycle().hold(request.camera, lic, palette, frame.plan);
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
