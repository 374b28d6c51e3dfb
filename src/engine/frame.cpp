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
}

/// The last step of the LIC stage: the means around are taken off.
void flattenFrame(const LicOptions& lic, Backend& backend, FrameGroup& group, const FramePlan& plan)
{
    backend.flatten(lic, plan.rows.stripe, group.beside(plan).get(), plan.edgeRows);
}

/// The runs of the LIC stage that a frame's values are mixed from (phase_mix.h). Between two of them the surface may
/// get other noise.
void convolveRuns(View view, const LicOptions& lic, Backend& backend, FrameGroup& group, FramePlan& plan,
                  FrameClock& clock)
{
    const bool isComets = phase_mix::isComets(lic);
    int kept = 0;
    for (const phase_mix::Run& run : phase_mix::runsOf(lic)) {
        if (run.grains != view.noise.grains) {
            view.noise.grains = run.grains;
            Share share;
            clock.time(stages::project, [&] { share = backend.projectGrains(view, plan.rows.drawn, plan.rows.valid); });
            clock.time(stages::composite, [&] {
                group.composite(plan, share);
                backend.complete(view, plan.rows.drawn);
            });
        }
        clock.time(stages::convolve, [&] {
            LicOptions ofRun = lic;
            ofRun.phase = run.phase;
            convolveFrame(ofRun, backend, group, plan);
            if (!isComets) flattenFrame(ofRun, backend, group, plan);
            backend.keepPhase(kept++);
        });
    }
    if (!isComets) return;
    clock.time(stages::convolve, [&] {
        backend.mixPhases(phase_mix::MeanOfComets{});
        flattenFrame(lic, backend, group, plan);
        backend.keepPhase(phase_mix::kMeanOfComets);
    });
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
    const bool hasLic = lic.method != LicMethod::none, inCycle = hasLic && request.inCycle;
    const bool again = inCycle && group.cycle().holds(request.camera, lic, palette);
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
    const bool isMixed = inCycle || (hasLic && phase_mix::isComets(lic));
    if (isMixed && !again) convolveRuns(view, lic, backend, group, frame.plan, clock);
    clock.time(stages::convolve, [&] {  // Noise along streams.
        if (isMixed) return backend.mixPhases(phase_mix::mixtureOf(lic));
        convolveFrame(lic, backend, group, frame.plan);
        flattenFrame(lic, backend, group, frame.plan);
    });
    clock.time(stages::shade, [&] {  // LIC, light and colour to pixels.
        if (!again) backend.occlude(palette, rows.stripe, group.beside(frame.plan).get(), frame.plan.edgeRows);
        if (inCycle) group.cycle().hold(request.camera, lic, palette, frame.plan);
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
